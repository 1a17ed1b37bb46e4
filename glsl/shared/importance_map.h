/* passes/lights/importance_map.h to its shaders. */
#ifndef SHARED_IMPORTANCE_MAP_H
#define SHARED_IMPORTANCE_MAP_H

#include "shared/vpl.h"

#define UNIT_CANDIDATES (UNIT_OWN + 0)
#define UNIT_IMPORTANCE_VALUES (UNIT_OWN + 1)
#define UNIT_IMPORTANCE_LIGHTS (UNIT_OWN + 2)

/* Squared: candidates of a round; and of rays from a sky, or of starts of paths. */
#define CANDIDATES_SIDE 64
#define CANDIDATES_SIDE_MANY 128
#define CANDIDATE_PIXELS 64

struct importance_map_params {
    ivec2 tiles; /* of the map, along either side */
    float vpls;  /* N */
    int bounces; /* that light of later bounces has; likewise: */
    float start; /* above a VPL of the light's own map, metres */
    float area;  /* of a VPL of later bounces, m2 */
    int side;    /* squared: candidates of a round */
    float unused;
};
PASS_BLOCK(importance_map_params, 32)

#endif
