// Direct light of lights that a tree samples, one ray each. A light whose probability is at least one sample's share counts
// once. Light of the most probable points is exact. All other light goes to a second target, for a blur: pixels of a 4 x 4
// pattern divide the numbers that choose lights evenly.
#include "passes/gather/receiver_facet.glsl"
#include "lib/light_tree.glsl"
#include "lib/random.glsl"
#include "passes/visibility/shadow_ray.glsl"

PASS_BLOCK(sampled_direct_params, 32)

layout(location = TARGET_RESULT) out vec4 exact; // radiance of a white surface
layout(location = TARGET_SAMPLED) out vec4 irradiance;
#ifdef HAS_SPECULAR
#include "lib/unshadowed_specular.glsl"
#include "passes/visibility/pixel_spread.glsl"

layout(location = TARGET_SAMPLED_EXACT_SPECULAR) out vec4 exact_specular;
layout(location = TARGET_SAMPLED_SPECULAR) out vec4 radiance;
#endif

const float INVERSE_PI = 0.31830988618;
const int PATTERN = 4, NEIGHBOURS = 8;

// The pixel's place of its pattern, from 0 to 1: bits of x and y alternate from the last, so that near pixels differ most.
float pattern_number(ivec2 pixel) {
    uvec2 at = uvec2(pixel % PATTERN);
    at.y ^= at.x;
    uint number = 0u;
    for (uint bit = 0u; bit < 2u; bit++)
        number |= ((at.y >> bit & 1u) << 1u | (at.x >> bit & 1u)) << (2u - 2u * bit);
    return (float(number) + 0.5) / float(PATTERN * PATTERN);
}

// Whether the blur finds few neighbours for a pixel.
bool is_alone(surface s, ivec2 pixel) {
    float reach = params.distance * view_height(camera, gbuffer_depth(pixel));
    int alike = 0;
    for (int i = 0; i < NEIGHBOURS; i++) {
        ivec2 step = i % 2 == 0 ? ivec2(3, 0) : ivec2(2, 2);
        step = i / 2 % 2 == 0 ? step : ivec2(-step.y, step.x);
        surface other = gbuffer_surface(clamp(pixel + (i < 4 ? step : -step), ivec2(0), gbuffer_size() - 1));
        vec3 apart = other.position - s.position;
        bool like = other.present && dot(apart, apart) < reach * reach && dot(other.normal, s.normal) > params.cosine;
        alike += like ? 1 : 0;
    }
    return alike < NEIGHBOURS / 2;
}

void main() {
    exact = irradiance = vec4(0.0);
#ifdef HAS_SPECULAR
    exact_specular = radiance = vec4(0.0);
#endif
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    surface s = gbuffer_surface(pixel);
    vec3 facet = facet_of(s, pixel);
#ifdef HAS_SPECULAR
    specular_surface seen = gbuffer_specular(s, pixel), wide = widened(seen, 0.0, pixel);
    float wide_scale = widened_scale(seen, wide);
#endif
    int count = !s.present ? 0 : is_alone(s, pixel) ? params.alone_samples : params.samples;
    float shift = fract(pattern_number(pixel) + params.turn), n = float(count);
    for (int k = 0; k < count;) {
        float probability, start = (float(k) + shift) / n, number = start;
        int i = light_tree_sample(s.position, s.normal, number, probability);
        bool is_sized;
        vec2 place = random_of(uvec3(pixel, k + count * params.pass));
        light l = sampled_light_towards(max(i, 0), s.position, place, is_sized);
        // Each sample of a light with a size has another place of it.
        float share = 1.0 / (is_sized ? probability * n : min(probability * n, 1.0));
        // Alike for pixels with more samples, as they all are blurred together.
        float sharp = is_sized ? 0.0 : smoothstep(1.0, 2.0, probability * float(params.samples));
        vec3 direction = normalize(s.position - l.position);
        float cosine = max(-dot(s.normal, direction), 0.0);
        bool lights = i >= 0 && cosine > 0.0 && dot(facet, direction) < 0.0;
        vec3 power = arriving(l, s.position, facet, lights ? share : 0.0, direction);
#ifdef HAS_SPECULAR
        cosine *= diffuse_share(seen, direction);
        vec3 reflected = power * specular_brdf(wide, -direction) * wide_scale;
        reflected *= bent_lobe(seen, wide, -direction, 0.0, pixel);
        exact_specular.rgb += reflected * sharp;
        radiance.rgb += reflected * (1.0 - sharp);
#endif
        exact.rgb += power * (cosine * sharp);
        irradiance.rgb += power * (cosine * (1.0 - sharp));
        // On past all numbers that choose the same light.
        k = is_sized ? k + 1 : max(k + 1, int(ceil((start + (1.0 - number) * probability) * n - shift)));
    }
    exact.rgb *= INVERSE_PI;
    irradiance.rgb *= params.scale;
#ifdef HAS_SPECULAR
    radiance.rgb *= params.scale;
#endif
}
