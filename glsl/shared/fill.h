/* How holes of imperfect shadow maps are closed. */
#ifndef SHARED_FILL_H
#define SHARED_FILL_H

#include "shared/types.h"

#define UNIT_COARSE_DEPTH (UNIT_OWN + 0)

/* Texels twice as wide at each; what is farther from a point than the last one's is a hole for good. */
#define FILL_LEVELS 3

struct fill_params {
    int level;      /* of the fine texels, 0 the map's own */
    float map_size; /* of level 0, texels */
    float radius;   /* of points, metres */
    float unused;
};
PASS_BLOCK(fill_params, 16)

#endif
