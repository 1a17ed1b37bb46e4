// Irradiance from some VPLs, each with the visibility of its VAL [Dong 2009 §4, §6]:
//     E = sum_i Phi_i / pi cos_i cos_x / d^2 V_C(i)(x)
// A draw fills one tile: the pixels of one place in the interleaving pattern, which share their VPLs
// [Segovia et al. 2006].
//
// The lights of a pixel, all in the tile's range or by CUTS those of its block's cut:
//     ivec2 lights_of(pixel)                   the first, and past the last
//     vpl light_at(i)
// By SPECULAR, how a surface takes a light:
//     vec3 unshadowed(i, light, s, out back)   irradiance or reflected radiance, times pi, if the light arrives;
//                                              back: what to subtract if it does not arrive
//     vec3 arriving(own, back, visible)        of both
//     bool receives_light(s, pixel)
//     float given_back()                       what all light is multiplied by
//     int lights_per_test(most)                lights side by side that test visibility together
// By TESTED (shared/gather.h), who tests visibility:
//     vec3 light_of(s, pixel, lights)          the sum of what arrives
#include "lib/gbuffer.glsl"
#include "shared/gather.h"

PASS_BLOCK(gather_params, 64)

// First VPL and count, or with cuts the set; the tile's place in the pattern.
layout(location = LOCATION_SLOT) uniform ivec4 slot;
// Samples taken of N: their sum stands for all.
layout(location = LOCATION_SLOT_WEIGHT) uniform float weight;
// Where each VPL has its own map: the map's number is the VPL's and this.
layout(location = LOCATION_FIRST_MAP) uniform int first_map;

layout(location = TARGET_RESULT) out vec4 irradiance;

const float INVERSE_PI = 0.31830988618;

vec3 receiver_facet = vec3(0.0); // the normal of the triangle that the receiver lies on

#include "lib/vpl_texels.glsl"
#include "passes/gather/receiver.glsl"
#if CUTS
// The lights of a pixel are those of its block's cut: each is the VPL that stands for its node in the pixel's set, with as
// much flux as all have, of its own colour. The mean over sets is then right for each colour.
#include "lib/tiles.glsl"
#include "lib/vpl_tree.glsl"

layout(binding = UNIT_CUTS) uniform usampler2DArray cuts;
layout(binding = UNIT_TREE_REPRESENTATIVES) uniform usampler2DArray tree_representatives;

ivec3 cut_texel;

// A cut has a layer with its count, and then its nodes.
ivec2 lights_of(ivec2 pixel) {
    cut_texel = ivec3(divide(pixel, ivec2(params.cut_block)), params.cut_layer);
    return ivec2(0, int(texelFetch(cuts, cut_texel, 0).r));
}

vpl light_at(int i) {
    int node = int(texelFetch(cuts, cut_texel + ivec3(0, 0, i + 1), 0).r);
    vpl light = vpl_at(int(texelFetch(tree_representatives, tree_texel(node, slot.x), 0).r));
    light.flux *= tree_row(node, TREE_FLUX).w / max(dot(light.flux, vec3(1.0)), 1e-30);
    return light;
}
#else
ivec2 lights_of(ivec2 pixel) {
    return ivec2(slot.x, slot.x + slot.y);
}

vpl light_at(int i) {
    return vpl_at(i);
}
#endif
#if SPECULAR == SPECULAR_NONE
#include "passes/gather/light_diffuse.glsl"
#else
#include "passes/gather/light_specular.glsl"
#endif

// The map that knows the light's visibility.
int map_of(int i, vpl light) {
    return MAP_PER_VPL == 1 ? first_map + i : int(light.val);
}

#if TESTED == TESTED_BY_GROUP
#include "passes/gather/gather_groups.glsl"
#elif TESTED == TESTED_BY_PIXEL
#include "passes/gather/visibility_pixel.glsl"

vec3 light_of(surface s, ivec2 pixel, ivec2 lights) {
    return light_by_pixel(s, lights);
}
#else
#include "passes/gather/gather_blocks.glsl"
#endif

void main() {
    ivec2 pixel;
    bool receives = receiver_pixel(params.pattern, slot.zw, pixel);
    surface s = receiver_surface(pixel);
    receives = receives && s.present;
    receiver_facet = receiver_triangle(s, pixel);
    receives = receives_light(s, pixel) && receives;
    // No lights, and no branch around the loops, which a software rasteriser would keep books of at each step.
    ivec2 lights = receives ? lights_of(pixel) : ivec2(0);
    vec3 light = light_of(s, pixel, lights) * (INVERSE_PI * weight * params.scale * given_back());
    irradiance = receives ? vec4(light, 1.0) : vec4(0.0);
}
