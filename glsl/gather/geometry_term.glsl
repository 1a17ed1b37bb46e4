// How much of a VPL's light a surface takes, but for its visibility: by CLAMP and the gather's parameters.
#include "gather/near_field.glsl"
#include "gather/patch.glsl"
#include "gather/sphere.glsl"
#include "lib/vpl_rows.glsl"
#if CLAMP == 1 || CLAMP == 4
#include "shared/gather.h"
#endif

// cos_i cos_x / d^2, bounded as the setting says: near a VPL the point light is no longer the patch
// that it stands for.
float geometry_term(vec3 to_vpl, vec3 normal, vpl light) {
#if CLAMP == 4
    return sphere_term(to_vpl, normal, light.normal, params.sphere2 * light.area);
#endif
    float distance2 = dot(to_vpl, to_vpl);
    float cosines = max(dot(normal, to_vpl), 0.0) * max(-dot(light.normal, to_vpl), 0.0);
    if (cosines <= 0.0)
        return 0.0;
#if CLAMP == 0
    return cosines / (distance2 * distance2);
#elif CLAMP == 1
    return min(cosines / (distance2 * distance2), params.clamp_at);
#elif CLAMP == 2
    // The form factor of a disk of the VPL's area, facing the receiver.
    return cosines / (distance2 * (distance2 + light.area * 0.31830988618));
#elif CLAMP == 5
    return patch_term(cosines, distance2, light.area);
#else
    // The near field comes from the reflective shadow map.
    float far = 1.0 - near_share(distance2, light.area, light.reach);
    return cosines * far / (distance2 * distance2);
#endif
}
