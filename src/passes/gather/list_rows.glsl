// The rows of a tile that one of its lists fills: of pixels of two levels from the begin and from the end of its first
// half, of edge samples from the begin of its second.
#include "shared/gather.h"

layout(std140, binding = BLOCK_LIST_COUNTS) uniform list_counts {
    uvec4 counts[PIXEL_LISTS_MAX / 4];
};
layout(location = LOCATION_TILE) uniform ivec4 tile; // size, places a side, list

// Where the tile has the list, texel by texel: begin, end; which list it is.
ivec3 list_range_of(ivec2 place) {
    int list = (tile.w * tile.z + place.y) * tile.z + place.x, count = int(counts[list / 4][list % 4]);
    int half_tile = tile.x * tile.y / 2;
    int begin = tile.w == PIXEL_LEVEL_DETAIL ? half_tile - count : tile.w == LIST_EDGE_SAMPLES ? half_tile : 0;
    return ivec3(begin, begin + count, tile.w);
}

// The first one, and the one after the last.
ivec2 list_rows(ivec3 list_range) {
    return ivec2(list_range.x, list_range.y + tile.x - 1) / tile.x;
}
