/* OpenGL state of a caller's context: what passes change (gl/pass.h) or count on is saved, set to the defaults of OpenGL where
 * passes count on these, and put back. Bindings are read by number, so a call costs some 1300 queries of the driver. */
#ifndef LIBRARY_HOST_STATE_H
#define LIBRARY_HOST_STATE_H

#include <stdbool.h>

struct host_state;

/* With the context current. Error: names the first function that getproc does not know. */
struct host_state *host_state_create(void *(*getproc)(const char *name));

/* Accepts NULL. */
void host_state_free(struct host_state *state);

void host_state_save(struct host_state *state);
void host_state_restore(const struct host_state *state);

#endif
