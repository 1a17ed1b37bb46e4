// Lists the pixels that have few like neighbours where the blur looks for them: by their place in the
// pattern, row by row of its tile, so that a draw finds them side by side. The order within a list is
// that of arrival; no pixel's light depends on it.
#include "lib/gbuffer.glsl"
#include "shared/detail.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(r32ui, binding = IMAGE_LISTED_PIXELS) writeonly uniform uimage2D listed_pixels;
layout(r32ui, binding = IMAGE_LIST_TEXELS) writeonly uniform uimage2D list_texels;
layout(std430, binding = STORAGE_LIST_COUNTS) buffer list_counts {
    uint counts[PIXEL_LISTS_MAX];
};

// Whether fewer than params.fewest of the four pixels diagonally around it lie on the same surface: beside a
// straight edge they are two.
bool has_few_like(surface s, ivec2 pixel, ivec2 size) {
    float like = 0.0, height = view_height(camera, gbuffer_depth(pixel));
    float reach = params.distance * height;
    for (int i = 0; i < 4 && like < params.fewest; i++) {
        ivec2 away = params.radius * (ivec2(i & 1, i >> 1) * 2 - 1);
        surface c = gbuffer_surface(clamp(pixel + away, ivec2(0), size - 1));
        vec3 apart = c.position - s.position;
        bool alike = c.present && dot(apart, apart) < reach * reach && dot(c.normal, s.normal) > params.cosine &&
                     abs(dot(apart, s.normal)) < params.apart * height;
        like += alike ? 1.0 : 0.0;
    }
    return like < params.fewest;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), size = gbuffer_size();
    if (any(greaterThanEqual(pixel, size)))
        return;
    surface s = gbuffer_surface(pixel);
    uint code = 0u;
    if (s.present && has_few_like(s, pixel, size)) {
        ivec2 place = pixel % params.pattern.n, tile = params.pattern.tile;
        int at = int(atomicAdd(counts[place.y * params.pattern.n + place.x], 1u));
        ivec2 texel = place * tile + ivec2(at % tile.x, at / tile.x);
        imageStore(listed_pixels, texel, uvec4(pixel.x | pixel.y << 16));
        code = uint(texel.x + 1 | texel.y << 16);
    }
    imageStore(list_texels, pixel, uvec4(code));
}
