/* passes/lights/seed_importance.h to its shaders. */
#ifndef SHARED_SEED_IMPORTANCE_H
#define SHARED_SEED_IMPORTANCE_H

#include "shared/types.h"

#define UNIT_SEED_IMPORTANCE (UNIT_OWN + 0)
#define UNIT_VPL_NUMBERS (UNIT_OWN + 1)

#define SEED_IMPORTANCE_SIDE 64    /* cells of the light's domain, along either side */
#define SEED_IMPORTANCE_LEVELS 7   /* down from all of it to a cell */
#define SEED_IMPORTANCE_PIXELS 256 /* of the picture, that a VPL is asked about */

struct seed_importance_params {
    float clamp_at; /* of the geometry term, 1/m2 */
    int unused0, unused1, unused2;
};
PASS_BLOCK(seed_importance_params, 16)

#endif
