/* Parameters of passes/lights/importance_map.h. */
#ifndef SHARED_IMPORTANCE_MAP_H
#define SHARED_IMPORTANCE_MAP_H

#include "shared/vpl.h"

#define UNIT_CANDIDATES (UNIT_OWN + 0)
#define UNIT_IMPORTANCE_VALUES (UNIT_OWN + 1)
#define UNIT_IMPORTANCE_LIGHTS (UNIT_OWN + 2)

/* Side of the square of candidates of a round; MANY: for rays of an environment, or path starts. */
#define CANDIDATES_SIDE 64
#define CANDIDATES_SIDE_MANY 128
#define CANDIDATE_PIXELS 64

struct importance_map_params {
    ivec2 tiles; /* tiles of the map, along each side */
    float vpls;  /* N */
    int bounces; /* bounces of light; for later bounces also: */
    float start; /* offset above a VPL of the light's RSM, metres */
    float area;  /* of a VPL of later bounces, m2 */
    int side;    /* side of the square of candidates of a round */
    float unused;
};
PASS_BLOCK(importance_map_params, 32)

#endif
