/* Blocks that C fills and GLSL reads: std140, so only vec4, mat4 and scalars in fours. */
#ifndef SHARED_TYPES_H
#define SHARED_TYPES_H

#include "shared/bindings.h"

#ifdef GL_core_profile
#define STRUCT(name) name
#define SHARED_FUNCTION
#else
#include <cglm/types.h> /* vec4 and mat4 spell the same there */
#define STRUCT(name) struct name
#define SHARED_FUNCTION static inline
#endif

#endif
