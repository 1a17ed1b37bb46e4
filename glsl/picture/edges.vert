// A point as large as a block of pixels for each that is not even (picture/even.frag).
#include "shared/planes.h"

layout(binding = UNIT_EVEN_BLOCKS) uniform sampler2D even_blocks;
layout(binding = UNIT_GBUFFER_DEPTH) uniform sampler2DArray gbuffer_depths;

void main() {
    int row = textureSize(even_blocks, 0).x;
    ivec2 block = ivec2(gl_VertexID % row, gl_VertexID / row);
    // What is left of the last block of a row may lie beside its middle, and without that there is no point.
    vec2 size = vec2(textureSize(gbuffer_depths, 0).xy);
    vec2 middle = min((vec2(block) + 0.5) * float(PLANE_BLOCK), size - 0.5);
    bool even = texelFetch(even_blocks, block, 0).r > 0.5;
    gl_Position = even ? vec4(2.0, 2.0, 2.0, 1.0) : vec4(middle / size * 2.0 - 1.0, 0.0, 1.0);
    gl_PointSize = float(PLANE_BLOCK);
}
