// The rows of a tile that its list of pixels fills.
#include "shared/interleaving.h"

layout(std140, binding = BLOCK_LIST_COUNTS) uniform list_counts {
    uvec4 counts[PIXEL_LISTS_MAX / 4];
};
layout(location = LOCATION_SLOT) uniform ivec4 slot;
layout(location = LOCATION_TILE) uniform ivec4 tile; // size, places a side

flat out int listed;

void main() {
    int list = slot.w * tile.z + slot.z;
    listed = int(counts[list / 4][list % 4]);
    int rows = (listed + tile.x - 1) / tile.x;
    const ivec2 corners[6] = ivec2[](ivec2(0, 0), ivec2(1, 0), ivec2(0, 1), ivec2(0, 1), ivec2(1, 0), ivec2(1, 1));
    vec2 corner = vec2(corners[gl_VertexID]) * vec2(1.0, float(rows) / float(tile.y));
    gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
