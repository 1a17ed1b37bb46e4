// Whether a block of pixels and those around it lie on one plane, or see nothing: no sample of its pixels then lies off
// what the pixel's centre sees.
#include "lib/block_plane.glsl"

layout(location = TARGET_RESULT) out float even;

// From the pixels to their block's plane, and from there to the next one's, over the width of a pixel: together less
// than a sample may be off (picture/edges.frag).
const float STEP = 0.03;
// A pixel turned so much sees something else in the plane's own depth, as a seam, which its samples lie off.
const float TURN = 0.2;

void main() {
    ivec2 block = ivec2(gl_FragCoord.xy), last = textureSize(block_planes, 0) - 1;
    block_plane here = block_plane_fetch(block);
    even = 1.0;
    for (int i = 0; i < 9; i++) {
        ivec2 at = clamp(block + ivec2(i % 3, i / 3) - 1, ivec2(0), last);
        block_plane there = block_plane_fetch(at);
        bool alike = (there.depth > 0.0) == (here.depth > 0.0) && there.off < STEP && there.turned < TURN &&
                     planes_apart(here, there, at - block) <= STEP * here.across;
        even = alike ? even : 0.0;
    }
}
