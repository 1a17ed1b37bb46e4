// Direct light of one light: by a filter of the light's own maps, or else blocked as if it came from the light's middle.
#include "lib/gbuffer.glsl"
#include "lib/unshadowed.glsl"
#include "passes/visibility/lookup.glsl"
#if PROJECTION == PROJECTION_LIGHT_MAP
#include "passes/visibility/projection_light_map.glsl"
#include "passes/visibility/filter_light_map.glsl"
#else
#if PROJECTION == PROJECTION_ORTHOGRAPHIC
#include "passes/visibility/projection_orthographic.glsl"
#else
#include "passes/visibility/projection_perspective.glsl"
#endif
#include "passes/visibility/filter_pcf.glsl"
#endif
#include "passes/visibility/direct_light.glsl"

float arriving(surface s, light l, vec3 direction) {
    receiver r;
#if PROJECTION == PROJECTION_LIGHT_MAP
    light_map m = light_map_towards(l, direction);
    return project(m, s.position, s.normal, r) ? lit(m.layer, r, 0.0) : 1.0;
#else
    light_view v = light_view_at(light_view_index(l, direction));
    return project(v.view, s.position, s.normal, r) ? lit(v.layer, r, 0.0) : 1.0;
#endif
}
