// How much of a light a surface takes, but for its visibility, by CLAMP (shared/gather.h):
//     float light_term(i, to_light, normal, light)    in place of cos_i cos_x / d^2
//     const bool TERM_OF_POINT                        a light behind the receiver's triangle gives nothing
#include "lib/vpl_rows.glsl"
#include "shared/gather.h"

#if CLAMP == GATHER_CLAMP_SPHERE
#include "passes/gather/term_sphere.glsl"
#elif CLAMP >= GATHER_CLAMP_RECTANGLE
#include "passes/gather/rectangle.glsl"
#else
#include "passes/gather/term_point.glsl"
#endif
