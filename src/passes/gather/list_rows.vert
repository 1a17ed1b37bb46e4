// Two triangles over the rows of a tile that one of its lists fills.
#include "passes/gather/list_rows.glsl"

layout(location = LOCATION_SLOT) uniform ivec4 slot;

flat out ivec3 list_range;

void main() {
    list_range = list_range_of(slot.zw);
    const ivec2 corners[6] = ivec2[](ivec2(0, 0), ivec2(1, 0), ivec2(0, 1), ivec2(0, 1), ivec2(1, 0), ivec2(1, 1));
    ivec2 corner = corners[gl_VertexID];
    int row = list_rows(list_range)[corner.y];
    gl_Position = vec4(vec2(corner.x, float(row) / float(tile.y)) * 2.0 - 1.0, 0.0, 1.0);
}
