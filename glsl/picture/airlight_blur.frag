// Joins the steps of a pattern's pixels along one axis, among neighbours of like depth; the ends have half weight, as
// in gather/blur.frag. The last axis also writes what the medium lets pass.
#include "picture/sight.glsl"
#include "shared/airlight.h"
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

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy), last = gbuffer_size() - 1;
    float depth = gbuffer_depth(pixel);
    vec4 sum = vec4(0.0);
    for (int i = -RADIUS; i <= RADIUS; i++) {
        ivec2 at = pixel + i * params.along, inside = clamp(at, ivec2(0), last);
        float other = gbuffer_depth(inside);
        bool is_like = at == inside && abs(other - depth) <= LIKE * max(other, depth);
        float weight = abs(i) == RADIUS ? 0.5 : 1.0;
        sum += is_like ? vec4(weight * texelFetch(airlight, inside, 0).rgb, weight) : vec4(0.0);
    }
    blurred = vec4(sum.rgb / sum.a, 1.0);
#ifdef LAST
    sight ray = sight_of(pixel);
    vec2 ends = medium_segment(ray.origin, ray.direction, ray.ray_length);
    transmittance = vec4(medium_passes(ends.y - ends.x), 1.0);
#endif
}
