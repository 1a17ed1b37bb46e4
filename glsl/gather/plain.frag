// Keeps pixels of plain blocks that have no further point.
#include "picture/picks.glsl"
#include "shared/planes.h"

layout(binding = UNIT_PLAIN_BLOCKS) uniform sampler2D plain_blocks;
layout(binding = UNIT_SAMPLE_PICKS) uniform usampler2D sample_picks;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uvec2 picks = texelFetch(sample_picks, min(pixel, textureSize(sample_picks, 0) - 1), 0).rg;
    if (texelFetch(plain_blocks, pixel / PLANE_BLOCK, 0).r < 0.5 || picks_further_point(picks))
        discard;
}
