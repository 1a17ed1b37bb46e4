// Whether a block of pixels and those around it lie on one plane, so near to each other that the blur takes all for alike;
// or with ERODE, whether all around it do.
#include "lib/camera.glsl"
#include "shared/plain.h"
#include "shared/planes.h"

layout(location = TARGET_RESULT) out float plain;

#if ERODE
layout(binding = UNIT_PLAIN_BLOCKS) uniform sampler2D plain_blocks;

bool is_plain(ivec2 block) {
    return true;
}

bool is_like(ivec2 block, ivec2 at) {
    return texelFetch(plain_blocks, at, 0).r > 0.5;
}
#else
#include "lib/block_plane.glsl"

// Of what lists take for the same surface an eighth for each step, from a pixel to its block, to the next block, to a
// pixel of that: the rest is left to normals, which may differ a little.
const float STEP = 0.125;

// How far off a plane a depth may lie, over the width of a pixel there.
float off_limit() {
    float height_in_pixels = length(camera.up) / length(camera.right) * float(params.width);
    return min(STEP * PLANE_APART * height_in_pixels, BLOCK_OFF_MOST);
}

block_plane here = block_plane(0.0, vec2(0.0), 0.0, vec2(0.0), 0.0, 0.0);

bool is_plane(block_plane p) {
    return p.depth > 0.0 && p.off < off_limit() && p.turned < params.code_apart;
}

bool is_same_plane(block_plane there, ivec2 blocks) {
    vec2 turn = abs(there.normal_code - here.normal_code);
    return is_plane(there) && planes_apart(here, there, blocks) < off_limit() * here.across &&
           turn.x + turn.y < params.code_apart;
}

// No pixel that blur or lists ask for, as far along x or y, or half as far along both, is farther away than by its place
// in the picture and by its depth along the longest ray.
bool is_near() {
    vec2 extent = vec2(length(camera.right), length(camera.up));
    float pixels = float(params.reach * PLANE_BLOCK), aside = pixels * 2.0 * extent.x / float(params.width);
    float change = pixels * max(abs(here.slope.x), abs(here.slope.y)) + 2.0 * off_limit() * here.across;
    float along = camera.orthographic ? change * camera.far : change / max(here.depth - change, 1e-30);
    return along * (1.0 + extent.x + extent.y) + aside < params.distance * 2.0 * extent.y;
}

bool is_plain(ivec2 block) {
    here = block_plane_fetch(block);
    return is_plane(here) && is_near();
}

bool is_like(ivec2 block, ivec2 at) {
    return is_same_plane(block_plane_fetch(at), at - block);
}
#endif

void main() {
    ivec2 block = ivec2(gl_FragCoord.xy);
#if ERODE
    ivec2 last = textureSize(plain_blocks, 0) - 1;
#else
    ivec2 last = textureSize(block_planes, 0) - 1;
#endif
    plain = is_plain(block) ? 1.0 : 0.0;
    for (int y = -params.reach; y <= params.reach; y++)
        for (int x = -params.reach; x <= params.reach; x++)
            plain = is_like(block, clamp(block + ivec2(x, y), ivec2(0), last)) ? plain : 0.0;
}
