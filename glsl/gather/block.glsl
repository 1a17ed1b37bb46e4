// Visibility shared by blocks of pixels: which block speaks for a pixel.
#include "lib/gbuffer.glsl"
#include "shared/gather.h"

layout(binding = UNIT_BLOCK_VISIBILITY) uniform sampler2DArray block_visibilities;

const float BLOCK_COSINE = 0.8;

// The pixel where a block looks itself up.
ivec2 block_center(ivec2 block, int size, ivec2 picture) {
    return min(block * size + size / 2, picture - 1);
}

// Of the four blocks around a pixel the one whose centre lies nearest among those on the same surface;
// false where there is none.
bool nearest_block(surface s, ivec2 pixel, out ivec2 nearest) {
    ivec2 picture = gbuffer_size(), blocks = textureSize(block_visibilities, 0).xy;
    int size = params.block;
    ivec2 base = (pixel + size / 2) / size - 1;
    float least = 1e30, plane_apart = params.block_apart * view_height(camera, gbuffer_depth(pixel));
    nearest = ivec2(0);
    for (int i = 0; i < 4; i++) {
        ivec2 block = clamp(base + ivec2(i & 1, i >> 1), ivec2(0), blocks - 1);
        surface c = gbuffer_surface(block_center(block, size, picture));
        vec3 apart = c.position - s.position;
        float distance2 = dot(apart, apart);
        bool alike = c.present && dot(c.normal, s.normal) > BLOCK_COSINE &&
                     abs(dot(apart, s.normal)) < plane_apart;
        if (alike && distance2 < least) {
            least = distance2;
            nearest = block;
        }
    }
    return least < 1e30;
}
