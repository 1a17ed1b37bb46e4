// Joins the steps of a pattern's pixels along one axis, among neighbours of like depth; the ends have half weight, as
// in passes/gather/blur.frag. Shadows alone are noisy: where light without them changes from pixel to pixel, as around a light
// and at the edge of its cone, only its share that arrives is blurred. The last axis also writes what the medium lets pass.
#include "lib/gbuffer.glsl"
#include "shared/medium.h"

PASS_BLOCK(airlight_params, 16 + 4 * 16 * LIGHTS_MAX)

#ifdef LAST
#include "lib/medium.glsl"
#endif

layout(binding = UNIT_AIRLIGHT) uniform sampler2D airlight;

layout(location = TARGET_RESULT) out vec4 blurred;
#ifdef LAST
layout(location = TARGET_TRANSMITTANCE) out vec4 transmittance;
#endif

const int RADIUS = AIRLIGHT_PATTERN / 2;
const float LIKE = 0.05; // depths differ by no more than so much of the greater one
const float EVEN = 0.05, UNEVEN = 0.25; // what differs from the mean by so much of it
const float HALF_MOST = 65504.0; // the target's largest number; beside a light there is more

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy), last = gbuffer_size() - 1;
    float depth = gbuffer_depth(pixel);
    vec4 own = texelFetch(airlight, pixel, 0), sum = vec4(0.0);
    float weights = 0.0;
    for (int i = -RADIUS; i <= RADIUS; i++) {
        ivec2 at = pixel + i * params.along, inside = clamp(at, ivec2(0), last);
        float other = gbuffer_depth(inside);
        bool is_like = at == inside && abs(other - depth) <= LIKE * max(other, depth);
        float weight = abs(i) == RADIUS ? 0.5 : 1.0;
        weight = is_like ? weight : 0.0;
        sum += weight * texelFetch(airlight, inside, 0);
        weights += weight;
    }
    float mean = sum.a / weights, unshadowed = mean;
    if (mean > 0.0)
        unshadowed = mix(mean, own.a, smoothstep(EVEN, UNEVEN, abs(own.a - mean) / mean));
    blurred = vec4(mean > 0.0 ? sum.rgb / sum.a * unshadowed : vec3(0.0), unshadowed);
#ifdef LAST
    blurred = min(blurred, vec4(HALF_MOST));
    sight ray = sight_of(pixel);
    vec2 ends = medium_segment(ray.origin, ray.direction, ray.ray_length);
    transmittance = vec4(medium_passes(ends.y - ends.x), 1.0);
#endif
}
