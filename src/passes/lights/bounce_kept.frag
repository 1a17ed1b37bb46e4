// What patches keep of the light that paths bring to what the camera sees. Of all paths' light it is another share: where the
// sun meets window frames half of all goes from frame to frame, and is lost there, and little of it in the room.
#include "shared/bounce.h"

layout(binding = UNIT_PATH_RESULTS) uniform sampler2D paths_seen;

layout(location = TARGET_RESULT) out vec4 kept;

// Those that are seen tell as far as they differ from all by more than chance, for they may be few: an estimate that is
// shrunk towards another [James and Stein 1961]. Few paths, or one that has most light, agree with their mean by themselves:
// the variance is at least that of shares as far apart as shares are.
float shrunk(vec2 kept, vec3 squares, float towards) {
    float own = kept.y > 0.0 ? kept.x / kept.y : towards, off = own - towards;
    float spread = max(dot(squares, vec3(1.0, -2.0 * own, own * own)), squares.z);
    float variance = spread / max(kept.y * kept.y, 1e-30);
    return towards + off * max(1.0 - variance / max(off * off, 1e-12), 0.0);
}

// Of what is kept, of that times what arrives, and of what arrives.
vec3 squares_of(vec2 kept) {
    return vec3(kept.x * kept.x, kept.x * kept.y, kept.y * kept.y);
}

void main() {
    vec4 sum = vec4(0.0); // seen, all
    vec3 seen = vec3(0.0), all = vec3(0.0);
    for (int i = 0; i < params.later; i++) {
        vec4 own = texelFetch(paths_seen, ivec2(i, 0), 0);
        sum += own;
        seen += squares_of(own.xy);
        all += squares_of(own.zw);
    }
    kept = vec4(shrunk(sum.xy, seen, shrunk(sum.zw, all, 1.0)));
}
