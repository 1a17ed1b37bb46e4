// Specular light of an environment, without the lights that light sampling covers (sky_sampled_lights.glsl). Rays are
// sampled by the lobe [Heitz 2018]; a ray that meets nothing takes the panorama's radiance. If no ray is blocked, the
// weights are normalised to the lobe's albedo, so a uniform sky has no noise. Otherwise they are normalised by a lobe
// without Fresnel's term: its weights would be correlated with the visible sky, and the mean would be biased.
#include "shared/sky.h"

PASS_BLOCK(environment_lighting_params, 32)

#include "lib/medium.glsl"
#include "lib/random.glsl"
#include "lib/sky.glsl"
#include "passes/visibility/bvh.glsl"
#include "passes/visibility/pixel_spread.glsl"
#include "passes/visibility/sky_sampled_lights.glsl"

layout(binding = UNIT_LOBE_SKY) uniform sampler2D panorama;

layout(location = TARGET_RESULT) out vec4 radiance;

bool in_sampled_light(vec3 direction, float alpha) {
    bool found = false;
    for (int i = 0; i < max(SUNS, BRIGHT); i++) {
        float least = 1.0;
        for (int c = 0; c < 4; c++)
            least = min(least, dot(cross(sky_corner(i, c), sky_corner(i, (c + 1) & 3)), direction));
        found = found || (sky_is_sampled_light(i, alpha) && least >= 0.0);
    }
    return found;
}

vec3 sky_along(vec3 origin, vec3 direction, float alpha, inout bool open) {
    bool blocked = in_sampled_light(direction, alpha) || bvh_meets_any(bvh_ray_along(origin, direction, BVH_FAR), true);
    open = open && !blocked;
    if (blocked)
        return vec3(0.0);
    return panorama_texel(panorama, direction, params.sky_turn) * medium_passes_along(origin, direction, MEDIUM_FAR);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    radiance = vec4(0.0);
    surface s = gbuffer_surface(pixel);
    specular_surface seen = gbuffer_specular(s, pixel);
    if (!s.present || seen.f90 == vec3(0.0))
        return;
    specular_surface wide = widened(seen, 0.0, pixel), white = wide;
    white.f0 = white.f90 = vec3(1.0);
    vec3 origin = s.position + bvh_clearance() * s.normal, found = vec3(0.0), own = vec3(0.0);
    float all = 0.0;
    bool open = true;
    int rays = is_smooth(seen.alpha) ? 4 * LOBE_RAYS : LOBE_RAYS; // no blur takes their noise
    vec2 start = vec2(uint(params.pass * rays) * LATTICE_PLASTIC >> 8u) / 16777216.0;
    for (int ray = 0; ray < rays; ray++) {
        vec3 direction = lobe_sample(wide, pixel_sample(pixel, start, ray));
        float density = lobe_density(wide, direction);
        float weight = density > 0.0 ? specular_brdf(white, direction).r / density : 0.0;
        all += weight;
        if (weight > 0.0) {
            vec3 reflects = specular_brdf(wide, direction) / density;
            own += reflects;
            found += reflects * sky_along(origin, direction, wide.alpha, open);
        }
    }
    float cosine = dot(seen.normal, seen.to_eye);
    vec3 mean = open ? specular_albedo(seen.f0, seen.f90, seen.alpha, cosine) / max(own, vec3(1e-6))
                     : vec3(lobe_albedo(seen.alpha, cosine).x / max(all, 1e-6));
    radiance.rgb = params.scale * params.sky_strength * mean * found;
}
