// The light of path (x, y) over the sum of the shares of the VPLs that it is lent to; A: the least share that is lent. A path
// lends to its nearest VPLs, up to the first that it does not see: ground goes on behind a wall as a floor. A path of row 0
// leaves a VPL, which has all of its light, and as much more as paths like it lose where they find no other VPL. Where a
// path finds none by chance, another finds itself alone: what is lost on the mean is given back.
#include "passes/lights/bounce_paths.glsl"
#include "passes/visibility/bvh.glsl"

layout(location = TARGET_RESULT) out vec4 per_share;

const int PARTNERS = 4;

// Both see a place between them, above their surface as far as it may bend.
bool see_each_other(path_end a, path_end b) {
    const float RISE = 0.25; // of their distance
    vec3 above = 0.5 * RISE * distance(a.position, b.position) * (a.normal + b.normal);
    vec3 middle = 0.5 * (a.position + b.position) + above;
    return !is_blocked(a.position, a.normal, middle) && !is_blocked(b.position, b.normal, middle);
}

// Sorts a share among the largest.
void insert(float share, int vpl, inout float shares[PARTNERS], inout int vpls[PARTNERS]) {
    for (int k = 0; k < PARTNERS; k++)
        if (share > shares[k]) {
            float smaller = shares[k];
            int other = vpls[k];
            shares[k] = share;
            vpls[k] = vpl;
            share = smaller;
            vpl = other;
        }
}

void main() {
    const float SAME = 0.9999; // shares but for rounding
    ivec2 path = ivec2(gl_FragCoord.xy), pool = pool_of(path.x);
    path_end end = path_end_at(path);
    bool leaves = path.y == 0;
    float shares[PARTNERS] = float[](0.0, 0.0, 0.0, 0.0), sum = LOST, least = 1e30;
    int vpls[PARTNERS] = int[](-1, -1, -1, -1);
    for (int i = pool.x; i < pool.y; i++)
        if (!leaves || i != path.x)
            insert(share_between(end, path_end_at(ivec2(i, 0))), i, shares, vpls);
    for (int k = 0; k < PARTNERS && shares[k] > 0.0 && see_each_other(end, path_end_at(ivec2(vpls[k], 0))); k++) {
        sum += shares[k];
        least = SAME * shares[k];
    }
    float others = float(BOUNCE_ROWS - 1);
    per_share = vec4(path_flux(path) * (leaves ? 1.0 + others * LOST / sum : 1.0 / sum), least);
}
