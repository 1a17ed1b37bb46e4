// Where the lights' domains lie in an importance map.
#include "shared/vpl.h"

ivec2 importance_tile(int index) {
    return ivec2(index % VPL_DENSITY_ROW, index / VPL_DENSITY_ROW);
}

ivec2 importance_texel(int index, vec2 place) {
    ivec2 cell = clamp(ivec2(place * float(VPL_DENSITY_SIDE)), ivec2(0), ivec2(VPL_DENSITY_SIDE - 1));
    return importance_tile(index) * VPL_DENSITY_SIDE + cell;
}
