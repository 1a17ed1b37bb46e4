// How much of a light a surface takes, but for its visibility, by CLAMP (shared/gather.h):
//     float light_term(i, to_light, normal, light)    in place of cos_i cos_x / d^2
//     const bool TERM_OF_POINT                        a light behind the receiver's triangle gives nothing
#include "lib/vpl_rows.glsl"
#include "passes/gather/vpl_terms.glsl"
#include "shared/gather.h"

#if CLAMP == GATHER_CLAMP_SPHERE
// The term of a ball around a VPL, by gather_params.
const bool TERM_OF_POINT = false; // balls may rise above a horizon in part

float light_term(int i, vec3 to_light, vec3 normal, vpl light) {
    return sphere_term(to_light, normal, light.normal, params.sphere2 * light.area);
}
#elif CLAMP >= GATHER_CLAMP_RECTANGLE
#include "passes/gather/rectangle.glsl"
#else
// The term of a VPL as a point, bounded by CLAMP: near it the point light is no longer the patch that it stands for.
const bool TERM_OF_POINT = true;

float light_term(int i, vec3 to_light, vec3 normal, vpl light) {
    float distance2 = dot(to_light, to_light);
    float cosines = max(dot(normal, to_light), 0.0) * max(-dot(light.normal, to_light), 0.0);
    if (cosines <= 0.0)
        return 0.0;
#if CLAMP == GATHER_CLAMP_NONE
    return cosines / (distance2 * distance2);
#elif CLAMP == GATHER_CLAMP_VALUE // by gather_params
    return min(cosines / (distance2 * distance2), params.clamp_at);
#elif CLAMP == GATHER_CLAMP_DISK // facing the receiver
    return cosines / (distance2 * (distance2 + light.area * 0.31830988618));
#elif CLAMP == GATHER_CLAMP_PATCH
    return patch_term(cosines, distance2, light.area);
#else
    float far = 1.0 - near_share(distance2, light.area, light.reach);
    return cosines * far / (distance2 * distance2);
#endif
}
#endif
