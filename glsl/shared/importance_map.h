/* What the importance maps of passes/lights/ share with their shaders. */
#ifndef SHARED_IMPORTANCE_MAP_H
#define SHARED_IMPORTANCE_MAP_H

#include "shared/types.h"
#include "shared/vpl.h"

/* passes/lights/importance_map.h to its shaders. */
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

/* passes/lights/seed_importance.h to its shaders. */
#define UNIT_SEED_IMPORTANCE (UNIT_OWN + 0)
#define UNIT_VPL_NUMBERS (UNIT_OWN + 1)

#define SEED_IMPORTANCE_SIDE 64    /* cells of the light's domain, along either side */
#define SEED_IMPORTANCE_LEVELS 7   /* down from all of it to a cell */
#define SEED_IMPORTANCE_PIXELS 256 /* of the picture, that a VPL is asked about */

struct seed_importance_params {
    float clamp_at; /* of the geometry term, 1/m2 */
    int unused0, unused1, unused2;
};
STD140_SIZE(seed_importance_params, 16)

#endif
