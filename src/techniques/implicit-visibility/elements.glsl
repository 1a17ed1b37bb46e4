// Surface elements in the cells of a grid, and how much each counts for a pixel's surface.
#include "lib/gbuffer.glsl"
#include "shared/element_grid.h"

layout(std430, binding = STORAGE_ELEMENT_CELLS) readonly buffer element_cell_storage {
    uint element_cells[];
};
layout(std430, binding = STORAGE_ELEMENTS) readonly buffer element_storage {
    vec4 elements[];
};

// Whether pixels see panes, whose light is that of their own elements.
layout(location = LOCATION_OF_PANES) uniform ivec4 of_panes;

// An element this far off the surface's plane does not count, over the reach.
const float OFF_PLANE = 0.4;
// Of elements that do not count else: where there are no others.
const float LAST_RESORT = 1e-6;

// Rows of cells around a surface, each of three cells.
const int ELEMENT_ROWS = 9;

// The first element of the row, and the one after its last.
ivec2 element_row(vec3 position, int row) {
    ivec3 counts = ivec3(params.cells_x, params.cells_y, params.cells_z);
    ivec3 middle = clamp(ivec3((position - params.low) / params.cell), ivec3(1), counts - 2);
    ivec2 place = middle.yz + ivec2(row % 3 - 1, row / 3 - 1);
    int cell = (place.y * counts.y + place.x) * counts.x + middle.x - 1;
    return ivec2(element_cells[cell], element_cells[cell + 3]);
}

// Its weight, and the path to it over its reach; 0 where it faces away or lies beyond all that are looked up.
float element_weight(surface s, int number, out vec3 path) {
    vec4 place = elements[ELEMENT_TEXELS * number];
    path = (place.xyz - s.position) / params.cell;
    float distance2 = dot(path, path);
    vec4 normal = elements[ELEMENT_TEXELS * number + 1];
    float facing = dot(normal.xyz, s.normal);
    if (distance2 >= 3.0 || facing <= 0.0 || normal.w != float(of_panes.x))
        return 0.0;
    float falloff = max(1.0 - distance2, 0.0), plane = max(1.0 - abs(dot(path, s.normal)) / OFF_PLANE, 0.0);
    return facing * facing * (falloff * falloff * plane * place.w + LAST_RESORT / (1e-3 + distance2));
}
