// Lists the pixels that have few like neighbours where the blur looks for them, and pixels' edge samples: by level
// and place in the pattern, row by row of its tile, from the begin and the end of its first half and from the begin of
// its second, so that a draw finds them side by side. The order within a list is that of arrival; no pixel's light
// depends on it.
//
// With SHARE_VISIBILITY such pixels are adaptive, too, that no block speaks for; the others are told which one does.
// Pixels that are not adaptive are told their triangle's normal: what draws tiles has no neighbours at hand.
#include "lib/tiles.glsl"
#include "lib/gbuffer.glsl"
#include "passes/gather/receiver_facet.glsl"
#include "lib/edge_sample.glsl"
#include "shared/gather.h"

PASS_BLOCK(adaptive_params, 48)

#if SHARE_VISIBILITY
#include "passes/gather/block.glsl"
#endif

layout(r32ui, binding = IMAGE_ADAPTIVE_PIXELS) writeonly uniform uimage2D adaptive_pixels;
layout(r32ui, binding = IMAGE_EDGE_SAMPLE_TEXELS) writeonly uniform uimage2D edge_sample_texels;
layout(binding = UNIT_SAMPLE_ASSIGNMENT) uniform usampler2D sample_assignment;
layout(std430, binding = STORAGE_LIST_COUNTS) buffer list_counts {
    uint counts[PIXEL_LISTS_MAX];
};

layout(location = TARGET_RESULT) out uint list_texel;

// Of the four pixels diagonally around it those that lie on the same surface, beside a straight edge two, at a corner
// three; and those that do, or would but for gentle relief.
ivec2 like_neighbours(surface s, ivec2 pixel, ivec2 size) {
    ivec2 like = ivec2(0);
    float height = view_height(camera, gbuffer_depth(pixel)), reach = params.distance * height;
    for (int i = 0; i < 4; i++) {
        ivec2 away = params.radius * (ivec2(i & 1, i >> 1) * 2 - 1);
        surface c = gbuffer_surface(clamp(pixel + away, ivec2(0), size - 1));
        vec3 apart = c.position - s.position;
        bool near = c.present && dot(apart, apart) < reach * reach && abs(dot(apart, s.normal)) < params.apart * height;
        float cosine = dot(c.normal, s.normal);
        like += ivec2(near && cosine > params.cosine, near && cosine > params.sharp_cosine);
    }
    return like;
}

// A list's next texel.
ivec2 next_texel(ivec2 pixel, int list) {
    int n = params.pattern.n;
    ivec2 place = pixel - divide(pixel, ivec2(n)) * n, tile = params.pattern.tile;
    int at = int(atomicAdd(counts[(list * n + place.y) * n + place.x], 1u)), half_tile = tile.x * tile.y / 2;
    at = list == PIXEL_LEVEL_DETAIL ? half_tile - 1 - at : list == LIST_EDGE_SAMPLES ? half_tile + at : at;
    int row = divide(ivec2(at), tile.xx).x;
    return place * tile + ivec2(at - row * tile.x, row);
}

void list_edge_sample(ivec2 pixel) {
    ivec2 texel = next_texel(pixel, LIST_EDGE_SAMPLES);
    imageStore(adaptive_pixels, texel, uvec4(pixel.x | pixel.y << 16));
    imageStore(edge_sample_texels, pixel, uvec4(list_texel_code(texel, 0)));
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy), size = gbuffer_size();
    surface s = gbuffer_surface(pixel);
    ivec2 like = s.present ? like_neighbours(s, pixel, size) : ivec2(4);
    bool has_block = true;
    list_texel = s.present ? facet_code(facet_of(s, pixel)) : 0u;
#if SHARE_VISIBILITY
    ivec2 block;
    has_block = !s.present || nearest_block(s, pixel, block);
    list_texel |= s.present ? block_away_code(block - block_at(pixel)) : 0u;
#endif
    if (float(like.x) < params.fewest || !has_block) {
        int level = like.y < 2 ? PIXEL_LEVEL_DETAIL : PIXEL_LEVEL_EDGE;
        ivec2 texel = next_texel(pixel, level);
        imageStore(adaptive_pixels, texel, uvec4(pixel.x | pixel.y << 16));
        list_texel = list_texel_code(texel, level);
    }
    uvec2 assignment = texelFetch(sample_assignment, min(pixel, textureSize(sample_assignment, 0) - 1), 0).rg;
    if (has_edge_sample(assignment))
        list_edge_sample(pixel);
}
