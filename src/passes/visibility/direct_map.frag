// Direct light by a filter of the lights' own maps, of one light.
#include "lib/gbuffer.glsl"
#include "lib/unshadowed.glsl"
#include "passes/visibility/lookup.glsl"
#include "passes/visibility/projection_light_map.glsl"
#include "passes/visibility/filter_light_map.glsl"
#include "passes/visibility/direct_light.glsl"

float arriving(surface s, light l, vec3 direction) {
    receiver r;
    light_map m = light_map_towards(l, direction);
    return project(m, s.position, s.normal, r) ? lit(m.layer, r, 0.0) : 1.0;
}
