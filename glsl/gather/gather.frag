// Irradiance from a range of VPLs, each with the visibility of its VAL [Dong 2009 §4, §6]:
//     E = sum_i Phi_i / pi cos_i cos_x / d^2 V_C(i)(x)
// A draw fills one tile: the pixels of one place in the interleaving pattern, which share their VPLs
// [Segovia et al. 2006].
#include "lib/gbuffer.glsl"
#include "gather/receiver.glsl"
#include "gather/receiver_facet.glsl"
#if CUTS
#include "gather/cut.glsl"
#else
#include "lib/vpl_texels.glsl"
#endif
#include "visibility/visibility.glsl"
#include "gather/geometry_term.glsl"
#include "shared/gather.h"
#if CALIBRATED
#include "gather/calibration.glsl"
#endif
#if SHARE_VISIBILITY
layout(binding = UNIT_BLOCK_VISIBILITY) uniform sampler2DArray block_visibilities;
#if CLAMP >= 6
#include "gather/block_shares.glsl"
#else
#include "gather/block.glsl"
#endif
#endif

// First VPL and count, or with CUTS the set; the tile's place in the pattern.
layout(location = LOCATION_SLOT) uniform ivec4 slot;
// Samples taken of N: their sum stands for all.
layout(location = LOCATION_SLOT_WEIGHT) uniform float weight;
// Where each VPL has its own map: the map's number is the VPL's and this.
layout(location = LOCATION_FIRST_MAP) uniform int first_map;

layout(location = TARGET_RESULT) out vec4 irradiance;

const float INVERSE_PI = 0.31830988618;

#if SPECULAR
#include "gather/specular.glsl"
#endif

#if CLAMP >= 6
#include "gather/rectangle.glsl"
#endif

#if CLAMP == 5 && !SPECULAR // patches
layout(binding = UNIT_PATHS_KEPT) uniform sampler2D paths_kept;

float given_back() {
    return 1.0 / texelFetch(paths_kept, ivec2(0), 0).r;
}
#else
float given_back() {
    return 1.0;
}
#endif

vec3 receiver_facet = vec3(0.0); // the normal of the triangle that the receiver lies on

// Of light i: what geometry_term has of points and balls, or of its rectangle.
float light_term(int i, vec3 to_light, vec3 normal, vpl light) {
#if CLAMP >= 6
    return rectangle_term(i, to_light, normal, light);
#else
#if CLAMP != 4 // balls may rise above a horizon in part
    if (is_behind_horizon(receiver_facet, to_light))
        return 0.0;
#endif
    return geometry_term(to_light, normal, light);
#endif
}

// The lights that the pixel takes: first and past the last.
#if CUTS
ivec2 lights_of(ivec2 pixel) {
    return ivec2(0, cut_open(pixel, params.cut_block, params.cut_layer));
}

vpl light_at(int i) {
    return cut_light(i, slot.x);
}
#else
ivec2 lights_of(ivec2 pixel) {
    return ivec2(slot.x, slot.x + slot.y);
}

vpl light_at(int i) {
    return vpl_at(i);
}
#endif

// The map that knows the VPL's visibility.
int map_of(int i, vpl light) {
#if MAP_PER_VPL
    return first_map + i;
#else
    return int(light.val);
#endif
}

// Irradiance times pi, or with SPECULAR reflected radiance times pi, from a VPL where it arrives, and what it takes back
// where it does not: what is reflected of near VPLs counts as unoccluded.
vec3 unshadowed(int i, vpl light, surface s, out vec3 back) {
#if SPECULAR
    vec3 to_vpl = light.position - s.position;
    vec3 reflected = is_behind_horizon(receiver_facet, to_vpl) ? vec3(0.0)
                                                               : specular_light(light, s, light.area * weight);
    back = -reflected * near_share(dot(to_vpl, to_vpl), light.area, light.reach);
    return reflected;
#else
    back = vec3(0.0);
    return light.flux * light_term(i, light.position - s.position, s.normal, light);
#endif
}

#if CALIBRATED
vec2 receiver_place = vec2(0.0); // in the picture
#endif

// Whether a light's own arrives there, by that map.
float visibility_of(int map, surface s, vec3 light) {
    float visible = visibility_from(map, s.position, s.normal, light);
#if CALIBRATED
    visible = calibrated(visible, calibration_at(map, receiver_place).r);
#endif
    return visible;
}

#if TOGETHER
#include "lib/vpl_sums.glsl"

// Of VPLs side by side those of much the same hue, of which one, taken by its light, asks for the visibility of all: on average
// each counts as if it had asked. Where red light and green shared an answer, shadows would be of neither's
// hue.
struct light_group {
    vec3 arriving, hidden, place; // hidden: what its light is less where the one that asks does not arrive
    float strength, map;
};

// A light that is the group's own, whose strength it brings to `strength`, and whether it asks for all.
void group_add(inout light_group group, bool its_own, vec3 own, vec3 own_back, float strength, bool taken, vec3 place,
               float map) {
    group.arriving += its_own ? own : vec3(0.0);
    group.strength = its_own ? strength : group.strength;
    taken = taken && its_own;
    group.hidden = taken ? own + own_back : group.hidden;
    group.place = taken ? place : group.place;
    group.map = taken ? map : group.map;
}

vec3 group_light(light_group group, surface s) {
    float visible = visibility_of(int(group.map), s, group.place);
#if RECEIVERS == RECEIVERS_LISTED
    return group.arriving * visible;
#else
    // In the hue of the one that asks, which no group's is in all of its lights: less even, and right on the mean.
    vec3 hidden = group.hidden * (group.strength / max(dot(group.hidden, vec3(1.0)), 1e-30));
    return group.arriving - (1.0 - visible) * hidden;
#endif
}

// Irradiance times pi of the VPLs first .. last, of which some are redder than that hue, that of all.
vec3 light_together(surface s, int first, int last, vec2 hue, float random) {
    light_group none = light_group(vec3(0.0), vec3(0.0), s.position, 0.0, 0.0);
    light_group redder = none, greener = none;
    for (int i = first; i < last; i++) {
        vpl light = light_at(i);
        vec3 back, own = unshadowed(i, light, s, back);
        bool is_red = light.flux.r * hue.g > light.flux.g * hue.r;
        float own_strength = dot(own + back, vec3(1.0));
        float strength = own_strength + (is_red ? redder.strength : greener.strength);
        // One number for all: within the part that it fell into it is as random as before.
        float share = own_strength / max(strength, 1e-30);
        bool taken = random < share;
        random = (taken ? random : random - share) / max(taken ? share : 1.0 - share, 1e-6);
        float map = float(map_of(i, light));
        group_add(redder, is_red, own, back, strength, taken, light.position, map);
        group_add(greener, !is_red, own, back, strength, taken, light.position, map);
    }
    return group_light(redder, s) + group_light(greener, s);
}

vec3 light_of_slot(surface s, ivec2 pixel, ivec2 lights) {
    vec3 sum = vec3(0.0);
    vec2 hue = vpl_hue();
    // A lattice: pixels side by side have numbers far apart. Each group has its own, as one has no digits for more.
    float random = fract(dot(vec2(pixel), vec2(0.7548776662, 0.5698402910)) + params.turn);
    for (int i = lights.x; i < lights.y; i += params.together) {
        sum += light_together(s, i, min(i + params.together, lights.y), hue, random);
        random = fract(random + 0.6180339887);
    }
    return sum;
}
#else
vec3 light_of_slot(surface s, ivec2 pixel, ivec2 lights) {
    vec3 sum = vec3(0.0), back;
#if SHARE_VISIBILITY
    ivec2 block;
#if CLAMP >= 6
    vec4 shares;
    int last = block_shares(s, pixel, block, shares) ? lights.y : lights.x;
#elif RECEIVERS == RECEIVERS_OTHERS
    block = block_at(pixel) + block_away_of(texelFetch(list_texels, pixel, 0).r);
    int last = lights.y;
#else
    int last = nearest_block(s, pixel, block) ? lights.y : lights.x;
#endif
    for (int i = lights.x; i < last; i++) {
        vpl light = light_at(i);
#if CLAMP >= 6
        float visible = shared_visibility(block, shares, map_of(i, light));
#else
        float visible = texelFetch(block_visibilities, ivec3(block, map_of(i, light)), 0).r;
#endif
#if SPECULAR
        vec3 arriving = unshadowed(i, light, s, back);
        sum += mix(-back, arriving, visible);
#else
        sum += unshadowed(i, light, s, back) * visible;
#endif
    }
    lights.x = last;
#endif
#if !(SHARE_VISIBILITY && RECEIVERS == RECEIVERS_OTHERS && CLAMP < 6) // else those without a block are listed
    // Loops and no branches: a software rasteriser leaves a loop that no pixel is in after one step, but executes both
    // sides of a branch.
    for (int i = lights.x; i < lights.y; i++) {
        vpl light = light_at(i);
        vec3 arriving = unshadowed(i, light, s, back);
        float visible = 1.0;
        for (int lit = arriving + back != vec3(0.0) ? 1 : 0; lit > 0; lit--)
            visible = visibility_of(map_of(i, light), s, light.position);
#if SPECULAR
        sum += mix(-back, arriving, visible);
#else
        sum += arriving * visible;
#endif
    }
#endif
    return sum;
}
#endif

void main() {
    ivec2 pixel;
    bool receives = receiver_pixel(params.pattern, slot.zw, pixel);
    surface s = receiver_surface(pixel);
    receives = receives && s.present;
#if CALIBRATED
    receiver_place = (vec2(pixel) + 0.5) / vec2(gbuffer_size());
#endif
#if RECEIVERS == RECEIVERS_LISTED
    receiver_facet = listed.z == LIST_FURTHER ? s.normal : facet_of(s, pixel);
#elif RECEIVERS == RECEIVERS_OTHERS
    receiver_facet = facet_of_code(texelFetch(list_texels, pixel, 0).r, s.normal);
#else
    receiver_facet = facet_of(s, pixel);
#endif
#if SPECULAR
    receiver_shine = gbuffer_shine(s, pixel);
    receives = receives && receiver_shine.f90 != vec3(0.0);
#endif
    // No lights, and no branch around the loops, which a software rasteriser would keep books of at each step.
    ivec2 lights = receives ? lights_of(pixel) : ivec2(0);
    vec3 light = light_of_slot(s, pixel, lights) * (INVERSE_PI * weight * params.scale * given_back());
    irradiance = receives ? vec4(light, 1.0) : vec4(0.0);
}
