/* Definitions that C fills and GLSL reads. Blocks have the layout std140. C's structs match it
 * under three conditions. A vec3 begins at a multiple of 16 bytes and a scalar follows it. A vec2
 * begins at a multiple of 8. The size is a multiple of 16, and is checked beside each struct.
 *
 * For arrays of structs GLSL declares rows (vec4) and makes structs of them. Otherwise OpenGL names
 * each member of each element, and drivers keep thousands of names in every program. */
#ifndef SHARED_TYPES_H
#define SHARED_TYPES_H

#include "shared/bindings.h"

#ifdef GL_core_profile
#define STRUCT(name) name
#define BOOL bool
#define SHARED_FUNCTION
#define STD140_SIZE(name, bytes)
#define PASS_BLOCK(name, bytes)                                                                    \
    layout(std140, binding = BLOCK_PASS) uniform pass_uniforms {                                   \
        name params;                                                                               \
    };
#else
#include <assert.h>
#include <cglm/types.h> /* vec2, vec3, vec4, ivec2 and mat4 spell the same there */
#define STRUCT(name) struct name
#define BOOL int
#define SHARED_FUNCTION static inline
#define STD140_SIZE(name, bytes) static_assert(sizeof(struct name) == (bytes), "std140: " #name);
#define PASS_BLOCK(name, bytes) STD140_SIZE(name, bytes)
#endif

#endif
