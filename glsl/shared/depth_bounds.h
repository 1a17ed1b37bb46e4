/* passes/visibility/depth_bounds.h to its shader. */
#ifndef SHARED_DEPTH_BOUNDS_H
#define SHARED_DEPTH_BOUNDS_H

#include "shared/types.h"

#define BOUNDS_GROUP 8 /* invocations a side */

struct depth_bounds_params {
    int level;
    int size, below; /* of this level, and of what it is made from, texels a side */
    int unused;
};
PASS_BLOCK(depth_bounds_params, 16)

#endif
