/* Checks the samplers of each draw and dispatch in debug contexts. Each sampler of the program
 * needs a texture of its kind and a texture unit of its own. Drivers report faults differently or
 * not at all, and the sampled values are undefined. */
#ifndef GL_CONTEXT_SAMPLERS_H
#define GL_CONTEXT_SAMPLERS_H

#include "gl/api.h"

/* Wraps the draw functions of the table. Faults are logged and counted in *faults. */
void samplers_watch(struct gl_api *api, int *faults);

#endif
