// Visibility that blocks of pixels share. BLOCKS: the block, or what the includer's block_visibility takes.
#include "passes/gather/block.glsl"

layout(binding = UNIT_BLOCK_VISIBILITY) uniform sampler2DArray block_visibilities;

float block_visibility(ivec2 block, int map) {
    return texelFetch(block_visibilities, ivec3(block, map), 0).r;
}

#ifndef BLOCKS
#define BLOCKS ivec2
#endif

vec3 light_by_block(surface s, ivec2 lights, BLOCKS blocks) {
    vec3 sum = vec3(0.0), back;
    for (int i = lights.x; i < lights.y; i++) {
        vpl light = light_at(i);
        float visible = block_visibility(blocks, map_of(i, light));
        sum += arriving(unshadowed(i, light, s, back), back, visible);
    }
    return sum;
}
