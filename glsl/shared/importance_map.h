/* passes/lights/importance_map.h to its shaders. */
#ifndef SHARED_IMPORTANCE_MAP_H
#define SHARED_IMPORTANCE_MAP_H

#include "shared/vpl_density.h"

#define UNIT_CANDIDATES (UNIT_OWN + 0)
#define UNIT_IMPORTANCE_VALUES (UNIT_OWN + 1)
#define UNIT_IMPORTANCE_LIGHTS (UNIT_OWN + 2)

#define CANDIDATES_SIDE 64 /* squared: candidates of a round */
#define CANDIDATE_PIXELS 64

struct importance_map_params {
    ivec2 tiles; /* of the map, along either side */
    float vpls;  /* N */
    float unused;
};
PASS_BLOCK(importance_map_params, 16)

#endif
