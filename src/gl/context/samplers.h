/* In debug contexts each draw and dispatch asks first whether all samplers of its program have a texture, and each a unit
 * of its own. Drivers tell of one that has none, or none of its kind, each in its own way or not at all, and what it reads
 * then is theirs to choose. */
#ifndef GL_CONTEXT_SAMPLERS_H
#define GL_CONTEXT_SAMPLERS_H

#include "gl/api.h"

/* Puts itself between the table's draws and the driver. What it finds is logged and counted in *faults. */
void samplers_watch(struct gl_api *api, int *faults);

#endif
