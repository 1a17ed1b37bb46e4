// Visibility that a block of pixels shares.
#include "gather/block.glsl"

layout(binding = UNIT_BLOCK_VISIBILITY) uniform sampler2DArray block_visibilities;

vec3 light_by_block(surface s, ivec2 lights, ivec2 block) {
    vec3 sum = vec3(0.0), back;
    for (int i = lights.x; i < lights.y; i++) {
        vpl light = light_at(i);
        float visible = texelFetch(block_visibilities, ivec3(block, map_of(i, light)), 0).r;
        sum += arriving(unshadowed(i, light, s, back), back, visible);
    }
    return sum;
}
