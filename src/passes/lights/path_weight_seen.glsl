// Surfaces that light walks to count for more where pixels of the picture face them, unblocked. A path leaves its flux there
// rather than outdoors [Talbot et al. 2005]. Light that no pixel of the few sees is left as well, less often.
#include "passes/lights/seen_pixel.glsl"

const int WALK_PIXELS = 4;
const float WALK_SEEN = 6.0; // weight of a surface that all face, over one that none does

float walk_weight(vec3 position, vec3 normal) {
    vec2 shift = random_of(floatBitsToUint(position));
    float seen = 0.0;
    for (int i = 0; i < WALK_PIXELS; i++) {
        surface s = seen_pixel(i, shift);
        vec3 apart = s.position - position;
        bool faces = s.present && dot(apart, normal) > 0.0 && dot(apart, s.normal) < 0.0;
        vec3 end = faces ? s.position : position; // no way, no ray
        seen += faces && !is_blocked(position, normal, end) ? 1.0 : 0.0;
    }
    return 1.0 + (WALK_SEEN - 1.0) * seen / float(WALK_PIXELS);
}
