// Direct light that is blocked as if it came from the light's middle, of one light.
#include "lib/gbuffer.glsl"
#include "lib/unshadowed.glsl"
#include "passes/visibility/lookup.glsl"
#if PROJECTION == PROJECTION_ORTHOGRAPHIC
#include "passes/visibility/projection_orthographic.glsl"
#else
#include "passes/visibility/projection_perspective.glsl"
#endif
#include "passes/visibility/filter_pcf.glsl"
#include "passes/visibility/direct_light.glsl"

float arriving(surface s, light l, vec3 direction) {
    light_view v = light_view_at(light_view_index(l, direction));
    receiver r;
    return project(v.view, s.position, s.normal, r) ? lit(v.layer, r, 0.0) : 1.0;
}
