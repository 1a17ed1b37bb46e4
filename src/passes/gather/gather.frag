// Irradiance from some VPLs, each with the visibility of its VAL [Dong 2009 §4, §6]:
//     E = sum_i Phi_i / pi cos_i cos_x / d^2 V_C(i)(x)
// A draw fills one tile: the pixels of one place in the interleaving pattern, which share their VPLs
// [Segovia et al. 2006].
//
// The pass chooses files, which keep these contracts (passes/gather/gather.c). GATHER_LIGHTS, the lights of a pixel:
//     ivec2 lights_of(pixel)                   the first, and past the last
//     vpl light_at(i)
// GATHER_LIGHT, how a surface takes a light:
//     vec3 unshadowed(i, light, s, out back)   irradiance or reflected radiance, times pi, if the light arrives;
//                                              back: what to subtract if it does not arrive
//     vec3 arriving(own, back, visible)        of both
//     bool receives_light(s, pixel)
//     float given_back()                       what all light is multiplied by
//     int lights_per_test(most)                lights side by side that test visibility together
// GATHER_VISIBILITY, who tests visibility:
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

#include "passes/gather/receiver.glsl"
#include GATHER_LIGHTS
#include GATHER_LIGHT

// The map that knows the light's visibility.
int map_of(int i, vpl light) {
    return MAP_PER_VPL == 1 ? first_map + i : int(light.val);
}

#include GATHER_VISIBILITY

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
