// Direct light with that of some layers of environment lights. Visibility is that of the blocks of pixels around, between
// which it is interpolated. Rays start at a pixel on none of their surfaces, or where blocks disagree about much light.
#define BLOCK_COSINE 0.9
#include "shared/sky.h"

PASS_BLOCK(environment_lighting_params, 32)

#include "passes/gather/block.glsl"
#include "lib/medium.glsl"
#include "passes/visibility/sky_visibility.glsl"

layout(binding = UNIT_BLOCK_VISIBILITY) uniform sampler2DArray block_visibilities;
layout(binding = UNIT_DIRECT) uniform sampler2D direct; // of all other lights

layout(location = LOCATION_SKY_LAYERS) uniform ivec4 layers; // first, count

layout(location = TARGET_RESULT) out vec4 lit;
#ifdef HAS_SPECULAR
#include "lib/lobe.glsl"
#include "passes/visibility/pixel_spread.glsl"
#include "passes/visibility/sky_sampled_lights.glsl"

layout(binding = UNIT_DIRECT_SPECULAR) uniform sampler2D direct_specular; // of all other lights
layout(binding = UNIT_SKY_REFLECTED) uniform sampler2D reflected; // by rays (sky_lobes.frag)

layout(location = TARGET_DIRECT_SPECULAR) out vec4 specular;

// Returns the reflected radiance of an unoccluded light of radiance 1. Samples four points of a light that is smaller
// than the lobe, because linearly transformed cosines lack the tails of grazing lobes.
vec3 sky_specular(specular_surface s, lobe o, int i) {
    if (sky_is_small(i, s.alpha)) {
        vec3 sum = vec3(0.0);
        for (int k = 0; k < 4; k++)
            sum += specular_brdf(s, normalize(sky_towards(i, vec2(k & 1, k >> 1) - 0.5)));
        return 0.25 * length(sky_vector(i)) * sum;
    }
    const vec3 Z = vec3(0.0, 0.0, 1.0);
    polygon_sum above = polygon_sum(0.0, vec3(0.0), vec3(0.0)), p = above;
    vec3 last = o.from_world * sky_corner(i, 3);
    for (int c = 0; c < 4; c++) {
        vec3 next = o.from_world * sky_corner(i, c), a = last, b = next;
        if (polygon_cut(above, a, b, o.horizon))
            polygon_edge(p, a, b, Z);
        last = next;
    }
    polygon_edge(p, above.leaves, above.enters, Z);
    return polygon_end(p, Z) / 3.14159265 * o.albedo;
}
#endif

// Visibility has how much panes let pass: here they have their colour alone, by the light's middle.
vec3 through_medium(vec3 radiance, int i, vec3 position) {
    vec3 panes = medium_panes(position, sky_direction(i), MEDIUM_FAR);
    float most = max_of(panes);
    return most > 0.0 ? radiance * (medium_alone(position, sky_direction(i), MEDIUM_FAR) * panes) / most : radiance;
}

const float PI = 3.14159265358979;

// The four blocks around a pixel, and how much each speaks for it.
struct blocks {
    ivec2 block[4];
    vec4 weight;
};

blocks blocks_of(surface s, ivec2 pixel) {
    int size = params.block;
    vec2 place = (vec2(pixel) - float(size / 2)) / float(size);
    ivec2 base = ivec2(floor(place));
    vec2 share = place - vec2(base);
    float plane_apart = BLOCK_APART * view_height(camera, gbuffer_depth(pixel));
    blocks b;
    for (int k = 0; k < 4; k++) {
        b.block[k] = block_around(base, k);
        vec2 weight = mix(1.0 - share, share, vec2(k & 1, k >> 1));
        b.weight[k] = is_alike(s, b.block[k], plane_apart) ? weight.x * weight.y + 1e-4 : 0.0;
    }
    return b;
}

// What they say of four lights: the mean, and how far they disagree; those that do not speak might say anything.
vec4 visibility_of_blocks(blocks b, int layer, out vec4 apart) {
    vec4 sum = vec4(0.0), least = vec4(1.0), most = vec4(0.0);
    float weight = 0.0;
    for (int k = 0; k < 4; k++) {
        vec4 v = texelFetch(block_visibilities, ivec3(b.block[k], layer), 0);
        bool speaks = b.weight[k] > 0.0;
        sum += b.weight[k] * v;
        weight += b.weight[k];
        least = speaks ? min(least, v) : least;
        most = speaks ? max(most, v) : most;
    }
    apart = weight > 0.0 ? most - least + max(1.0 - weight, 0.0) : vec4(1.0);
    return sum / max(weight, 1e-6);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    lit = layers.x > 0 ? vec4(0.0) : texelFetch(direct, pixel, 0);
#ifdef HAS_SPECULAR
    specular = layers.x > 0 ? vec4(0.0) : texelFetch(direct_specular, pixel, 0);
    specular.rgb += layers.x > 0 ? vec3(0.0) : texelFetch(reflected, pixel, 0).rgb / params.scale;
#endif
    surface s = gbuffer_surface(pixel);
    if (!s.present)
        return;
    blocks b = blocks_of(s, pixel);
    int count = (params.count + SKY_LAYER_LIGHTS - 1) / SKY_LAYER_LIGHTS;
    float limit = params.disagree * sky_shares(s.normal, count).r;
    vec3 sum = vec3(0.0);
#ifdef HAS_SPECULAR
    vec3 shining = vec3(0.0);
    specular_surface seen = gbuffer_specular(s, pixel), wide = widened(seen, 0.0, pixel);
    lobe o = lobe_of(wide);
#endif
    // Masks and loops over their bits, no branch in the loop over lights: a software rasteriser runs what a branch
    // leaves out for all pixels.
    uint asked = 0u, shown = 0u; // asked: to trace rays to; shown: specular, by blocks
    for (int layer = layers.x; layer < min(layers.x + layers.y, count); layer++) {
        vec4 shares = sky_shares(s.normal, layer), apart;
        vec4 visible = visibility_of_blocks(b, layer, apart);
        for (int k = 0; k < SKY_LAYER_LIGHTS; k++) {
            int i = SKY_LAYER_LIGHTS * layer + k;
            vec4 radiance = sky_radiance(i);
            uint bit = 1u << (i - SKY_LAYER_LIGHTS * layers.x);
            bool ask = shares[k] * radiance.a * apart[k] > limit;
            asked |= ask ? bit : 0u;
#ifdef HAS_SPECULAR
            shown |= !ask && sky_is_sampled_light(i, wide.alpha) && shares[k] * visible[k] > 0.0 ? bit : 0u;
#endif
            sum += ask ? vec3(0.0) : through_medium(radiance.rgb, i, s.position) * (shares[k] * visible[k]);
        }
    }
    for (; asked != 0u; asked &= asked - 1u) {
        int i = SKY_LAYER_LIGHTS * layers.x + findLSB(asked);
        vec3 seen = sky_radiance(i).rgb * sky_visibility(i, s.position, s.normal);
        seen = through_medium(seen, i, s.position);
        sum += seen * sky_shares(s.normal, i / SKY_LAYER_LIGHTS)[i % SKY_LAYER_LIGHTS];
#ifdef HAS_SPECULAR
        shining += sky_is_sampled_light(i, wide.alpha) ? seen * sky_specular(wide, o, i) : vec3(0.0);
#endif
    }
#ifdef HAS_SPECULAR
    for (; shown != 0u; shown &= shown - 1u) {
        int i = SKY_LAYER_LIGHTS * layers.x + findLSB(shown);
        vec4 apart, visible = visibility_of_blocks(b, i / SKY_LAYER_LIGHTS, apart);
        vec3 seen = sky_radiance(i).rgb * visible[i % SKY_LAYER_LIGHTS];
        shining += through_medium(seen, i, s.position) * sky_specular(wide, o, i);
    }
#endif
    lit.rgb += sum / PI;
#ifdef HAS_SPECULAR
    specular.rgb += widened_scale(seen, wide) * shining;
#endif
}
