// Where a pixel of an inspected buffer's picture lies: one layer pixel by pixel, or a sheet of many.
#include "shared/params.h"

layout(std140, binding = BLOCK_PASS) uniform pass_uniforms {
    inspect_params params;
};

struct inspected {
    bool present;
    int layer;
    vec2 place; // within the layer, 0 to 1, from the lower left
};

inspected inspect_place(vec2 picture_size) {
    inspected at;
    vec2 pixel = gl_FragCoord.xy;
    if (params.cell_width == 0.0) {
        at.present = true;
        at.layer = int(params.first_layer);
        at.place = pixel / picture_size;
        return at;
    }
    // The first layer is at the top left.
    vec2 step = vec2(params.cell_width, params.cell_height);
    vec2 cell = floor(pixel / step), inside = pixel - cell * step;
    int row = int(params.rows) - 1 - int(cell.y);
    int index = row * int(params.columns) + int(cell.x);
    at.layer = int(params.first_layer) + index;
    at.place = (inside - 0.5 * params.gap) / (step - params.gap);
    at.present = row >= 0 && cell.x < params.columns && index < int(params.layer_count) &&
                 all(greaterThanEqual(at.place, vec2(0.0))) && all(lessThan(at.place, vec2(1.0)));
    return at;
}

const vec3 NOTHING = vec3(0.06, 0.065, 0.08);
