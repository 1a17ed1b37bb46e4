// The views that a set of maps is seen from.
#include "shared/maps.h"

layout(std140, binding = BLOCK_MAPS) uniform map_uniforms {
    vec4 map_view_rows[MAP_VIEWS_MAX * MAP_VIEW_ROWS];
};

map_view map_view_at(int k) {
    int row = k * MAP_VIEW_ROWS;
    vec4 center = map_view_rows[row], axis = map_view_rows[row + 1], tangent = map_view_rows[row + 2];
    return map_view(center.xyz, center.w, axis.xyz, axis.w, tangent.xyz, tangent.w);
}
