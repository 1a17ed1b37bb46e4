// What a group of VPLs gives to a pixel; and of one of them, taken by what it gives, whether its light arrives by its
// VAL's map, by the block, and by a ray through the scene's triangles. Its answer stands for all.
#include "gather/geometry_term.glsl"
#include "gather/receiver_facet.glsl"
#include "gather/representative.glsl"
#include "lib/vpl_texels.glsl"
#include "gather/correction_test.glsl"
#include "visibility/bvh.glsl"
#include "visibility/visibility.glsl"

layout(binding = UNIT_BLOCK_VISIBILITY) uniform sampler2DArray block_visibilities;

layout(location = TARGET_RESULT) out vec4 light_map_block_val; // the VAL's number and one, less than 0 where no ray arrives

float strength_of(int i, vpl v, surface s, vec3 facet) {
    vec3 to_vpl = v.position - s.position;
    float light = dot(v.flux, vec3(1.0)) * light_term(i, to_vpl, s.normal, v);
    return s.present && v.reach > 0.0 && !is_behind_horizon(facet, to_vpl) ? light : 0.0;
}

float by_block(ivec2 pixel, int val) {
    return params.block > 0 ? texelFetch(block_visibilities, ivec3(pixel / params.block, val), 0).r : 1.0;
}

void main() {
    ivec2 test = ivec2(gl_FragCoord.xy), size = gbuffer_size();
    int first = test_group(test) * CORRECTION_TOGETHER;
    ivec2 pixel = min(ivec2(test_place(test) * vec2(size)), size - 1);
    surface s = gbuffer_surface(pixel);
    vec3 facet = facet_of(s, pixel), place = s.position;
    float light = 0.0, val = 0.0, random = test_random(test);
    for (int i = first; i < min(first + CORRECTION_TOGETHER, params.vpl_count); i++) {
        vpl v = vpl_at(i);
        float strength = strength_of(i, v, s, facet);
        light += strength;
        bool taken = weighted_pick(strength, light, random);
        place = taken ? v.position : place;
        val = taken ? v.val : val;
    }
    float by_map = 1.0;
    bool arrives = true;
    // A loop and no branch, which a software rasteriser would execute everywhere.
    for (int lit = light > 0.0 ? 1 : 0; lit > 0; lit--) {
        by_map = visibility_from(int(val), s.position, s.normal, place);
        arrives = !is_blocked(s.position, s.normal, place);
    }
    light_map_block_val = vec4(light, by_map, by_block(pixel, int(val)), arrives ? val + 1.0 : -val - 1.0);
}
