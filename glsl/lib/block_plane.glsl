// Of a block of pixels the plane that its middle sees, and how far its pixels are off it: two texels of
// passes/picture/planes.h.
#include "shared/bindings.h"
#include "shared/planes.h"

layout(binding = UNIT_BLOCK_PLANES) uniform sampler2D block_planes;
layout(binding = UNIT_BLOCK_NORMALS) uniform sampler2D block_normals;

struct block_plane {
    float depth;      // in the block's middle; 0 where it sees nothing
    vec2 slope;       // lib/plane.glsl
    float across;     // likewise
    vec2 normal_code; // octahedral
    float off;        // the farthest pixel, over the width of a pixel there; BLOCK_OFF_MOST and more are one
    float turned;     // the most that pixels' codes differ from the middle's, both numbers together; 1 and more are one
};

const float BLOCK_OFF_MOST = 8.0;

block_plane block_plane_fetch(ivec2 block) {
    vec4 p = texelFetch(block_planes, block, 0), n = texelFetch(block_normals, block, 0);
    return block_plane(p.x, p.yz, p.w, n.xy, n.z * BLOCK_OFF_MOST, n.w);
}

// How far the plane of the block that is so many blocks away is off this one's, across all that block; of depth.
float planes_apart(block_plane here, block_plane there, ivec2 blocks) {
    vec2 bent = abs(there.slope - here.slope);
    return abs(here.depth + dot(here.slope, vec2(blocks * PLANE_BLOCK)) - there.depth) +
           float(PLANE_BLOCK / 2) * (bent.x + bent.y);
}
