/* Saves and restores the OpenGL state of a caller's context, as far as passes change it or rely on
 * it (gl/pass.h). Saving also sets the OpenGL defaults that passes rely on. Bindings are read by
 * number. Cost: about 1300 driver queries per call. */
#ifndef LIBRARY_HOST_STATE_H
#define LIBRARY_HOST_STATE_H

#include <stdbool.h>

struct host_state;

/* Loads the functions for saving. The context must be current. Error: names the first function that
 * getproc lacks. */
struct host_state *host_state_create(void *(*getproc)(const char *name));

/* Accepts NULL. */
void host_state_free(struct host_state *state);

void host_state_save(struct host_state *state);
void host_state_restore(const struct host_state *state);

#endif
