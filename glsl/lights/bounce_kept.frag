// What patches keep of the light that paths bring to what the camera sees. Of all paths' light it is another share: where the
// sun meets window frames half of all goes from frame to frame, and is lost there, and little of it in the room.
#include "shared/bounce.h"

layout(binding = UNIT_PATH_RESULTS) uniform sampler2D paths_seen;

layout(location = TARGET_RESULT) out vec4 kept;

// Those that are seen tell as far as they differ from all by more than chance, for they may be few: an estimate that is
// shrunk towards another [James and Stein 1961]. squares: of what is kept, of that times what arrives, and of what arrives.
float shrunk(vec2 seen, vec3 squares, float of_all) {
    float own = seen.y > 0.0 ? seen.x / seen.y : of_all, off = own - of_all;
    float variance = dot(squares, vec3(1.0, -2.0 * own, own * own)) / max(seen.y * seen.y, 1e-30);
    return of_all + off * max(1.0 - max(variance, 0.0) / max(off * off, 1e-12), 0.0);
}

void main() {
    vec4 sum = vec4(0.0); // seen, all
    vec3 squares = vec3(0.0);
    for (int i = 0; i < params.later; i++) {
        vec4 own = texelFetch(paths_seen, ivec2(i, 0), 0);
        sum += own;
        squares += vec3(own.x * own.x, own.x * own.y, own.y * own.y);
    }
    kept = vec4(sum.z > 0.0 ? shrunk(sum.xy, squares, sum.z / sum.w) : 1.0);
}
