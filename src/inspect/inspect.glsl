// Where a pixel of an inspected buffer's picture lies: one layer pixel by pixel, or a sheet of many.
#include "shared/inspect.h"

PASS_BLOCK(inspect_params, 64)

struct inspected {
    bool present;
    int layer;
    vec2 place; // within the layer, 0 to 1, from the lower left
};

inspected inspect_place(vec2 picture_size) {
    inspected at;
    vec2 pixel = gl_FragCoord.xy;
    if (params.cell.x == 0.0) {
        at.present = true;
        at.layer = params.first_layer;
        at.place = pixel / picture_size;
        return at;
    }
    // The first layer is at the top left.
    ivec2 cell = ivec2(floor(pixel / params.cell));
    vec2 inside = pixel - vec2(cell) * params.cell;
    int row = params.rows - 1 - cell.y;
    int index = row * params.columns + cell.x;
    at.layer = params.first_layer + index;
    at.place = (inside - 0.5 * params.gap) / (params.cell - params.gap);
    at.present = row >= 0 && cell.x < params.columns && index < params.layer_count &&
                 all(greaterThanEqual(at.place, vec2(0.0))) && all(lessThan(at.place, vec2(1.0)));
    return at;
}

const vec3 NOTHING = vec3(0.06, 0.065, 0.08);
