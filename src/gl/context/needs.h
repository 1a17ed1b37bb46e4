/* Requirements on a driver beyond the functions of gl/api.h. */
#ifndef GL_CONTEXT_NEEDS_H
#define GL_CONTEXT_NEEDS_H

#include "gl/api.h"

/* Checks version, extensions and limits when a context is made, so no shader fails for them later.
 * Error: names the first that is missing and its use. */
bool gl_needs_met(const struct gl_api *api);

#endif
