/* Pyramids of nearest and farthest depths: passes/visibility/depth_bounds.h to its shader, and where both find a
 * level. All levels lie side by side: rasterisers that run four pixels at once take a MIP level for all of them. */
#ifndef SHARED_DEPTH_BOUNDS_H
#define SHARED_DEPTH_BOUNDS_H

#include "shared/types.h"

#define BOUNDS_GROUP 8 /* invocations a side */

struct depth_bounds_params {
    int level;
    int base; /* squares a side of level 0: the half of the map */
    int map_size;
    int unused;
};
STD140_SIZE(depth_bounds_params, 16)

/* Squares a side of a level, and its place in the texture: level 0, and the others in a column beside it. */
SHARED_FUNCTION int bounds_side(int base, int level) {
    return base >> level;
}

SHARED_FUNCTION int bounds_x(int base, int level) {
    return level > 0 ? base : 0;
}

SHARED_FUNCTION int bounds_y(int base, int level) {
    return level > 0 ? base - (base >> (level - 1)) : 0;
}

#endif
