// The rows of a tile that one of its two lists of pixels fills: the one from the tile's begin, the other from its end.
#include "shared/interleaving.h"

layout(std140, binding = BLOCK_LIST_COUNTS) uniform list_counts {
    uvec4 counts[PIXEL_LISTS_MAX / 4];
};
layout(location = LOCATION_SLOT) uniform ivec4 slot;
layout(location = LOCATION_TILE) uniform ivec4 tile; // size, places a side, grade

flat out ivec2 listed;

void main() {
    int list = (tile.w * tile.z + slot.w) * tile.z + slot.z;
    int count = int(counts[list / 4][list % 4]), rows = (count + tile.x - 1) / tile.x;
    bool from_end = tile.w == PIXEL_GRADE_DETAIL;
    int size = tile.x * tile.y;
    listed = from_end ? ivec2(size - count, size) : ivec2(0, count);
    const ivec2 corners[6] = ivec2[](ivec2(0, 0), ivec2(1, 0), ivec2(0, 1), ivec2(0, 1), ivec2(1, 0), ivec2(1, 1));
    vec2 corner = vec2(corners[gl_VertexID]) * vec2(1.0, float(rows) / float(tile.y));
    corner.y = from_end ? 1.0 - corner.y : corner.y;
    gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
