/* What manylight needs of a driver beyond the functions of gl/api.h. */
#ifndef GL_CONTEXT_NEEDS_H
#define GL_CONTEXT_NEEDS_H

#include "gl/api.h"

/* Asked once, when a context is made, so that no shader fails for it later. Error: the first thing
 * that is missing, and what for. */
bool gl_needs_met(const struct gl_api *api);

#endif
