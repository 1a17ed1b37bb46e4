// What a texel of a tile gathers for, by RECEIVERS (shared/interleaving.h):
//     bool receiver_pixel(pattern, place, pixel)    false: for nothing
//     surface receiver_surface(pixel)
//     vec3 receiver_triangle(s, pixel)              the normal of the triangle that the surface lies on
#include "shared/gather.h"

#if RECEIVERS == RECEIVERS_ALL
#include "passes/gather/receiver_all.glsl"
#elif RECEIVERS == RECEIVERS_ADAPTIVE
#include "passes/gather/receiver_adaptive.glsl"
#else
#include "passes/gather/receiver_other.glsl"
#endif
