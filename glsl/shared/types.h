/* Blocks that C fills and GLSL reads: std140, so only vec4, mat4 and scalars in fours. */
#ifndef SHARED_TYPES_H
#define SHARED_TYPES_H

#ifdef GL_core_profile
#define STRUCT(name) name
#else
#include <cglm/types.h> /* vec4 and mat4 spell the same there */
#define STRUCT(name) struct name
#endif

/* Uniform block bindings. */
#define BLOCK_VIEW 0
#define BLOCK_LIGHT 1
#define BLOCK_PASS 2
#define BLOCK_MATERIAL 3
#define BLOCK_MAPS 4
#define BLOCK_VPLS 5
#define BLOCK_VISIBILITY 6

#endif
