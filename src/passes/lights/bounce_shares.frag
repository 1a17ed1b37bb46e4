// The light of path (x, y) over what its VPLs' shares add up to. Of row 0, which leaves a VPL: what that VPL has of it, which is
// all, and as much more as paths like it lose where they find no other VPL. Where a path finds none by chance, another
// finds itself alone: what is lost on the mean is given back.
#include "passes/lights/bounce_share.glsl"

layout(location = TARGET_RESULT) out vec4 per_share;

void main() {
    ivec2 path = ivec2(gl_FragCoord.xy), pool = pool_of(path.x);
    path_end end = path_end_at(path);
    int own = path.y == 0 ? path.x : -1;
    float sum = LOST;
    for (int i = pool.x; i < pool.y; i++)
        sum += i == own ? 0.0 : share_between(end, path_end_at(ivec2(i, 0)));
    float others = float(BOUNCE_ROWS - 1);
    per_share = vec4(path_flux(path) * (path.y == 0 ? 1.0 + others * LOST / sum : 1.0 / sum), 0.0);
}
