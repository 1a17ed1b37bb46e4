// The rows of a tile that one of its lists fills: of pixels of two grades from the begin and from the end of its first
// half, of further points from the begin of its second.
#include "shared/interleaving.h"

layout(std140, binding = BLOCK_LIST_COUNTS) uniform list_counts {
    uvec4 counts[PIXEL_LISTS_MAX / 4];
};
layout(location = LOCATION_SLOT) uniform ivec4 slot;
layout(location = LOCATION_TILE) uniform ivec4 tile; // size, places a side, list

flat out ivec3 listed;

void main() {
    int list = (tile.w * tile.z + slot.w) * tile.z + slot.z, count = int(counts[list / 4][list % 4]);
    int half_tile = tile.x * tile.y / 2;
    int begin = tile.w == PIXEL_GRADE_DETAIL ? half_tile - count : tile.w == LIST_FURTHER ? half_tile : 0;
    listed = ivec3(begin, begin + count, tile.w);
    const ivec2 corners[6] = ivec2[](ivec2(0, 0), ivec2(1, 0), ivec2(0, 1), ivec2(0, 1), ivec2(1, 0), ivec2(1, 1));
    ivec2 corner = corners[gl_VertexID];
    int row = corner.y == 0 ? begin / tile.x : (begin + count + tile.x - 1) / tile.x;
    gl_Position = vec4(vec2(corner.x, float(row) / float(tile.y)) * 2.0 - 1.0, 0.0, 1.0);
}
