/* Parameters of passes/lights/seed_importance.h. */
#ifndef SHARED_SEED_IMPORTANCE_H
#define SHARED_SEED_IMPORTANCE_H

#include "shared/types.h"

#define UNIT_SEED_IMPORTANCE (UNIT_OWN + 0)
#define UNIT_VPL_NUMBERS (UNIT_OWN + 1)

#define SEED_IMPORTANCE_SIDE 64    /* cells along each side of the light's domain */
#define SEED_IMPORTANCE_LEVELS 7   /* levels from the whole domain to a cell */
#define SEED_IMPORTANCE_PIXELS 256 /* pixels that a VPL's importance is estimated at */

struct seed_importance_params {
    float clamp_at; /* bound of the geometry term, 1/m2 */
    int unused0, unused1, unused2;
};
PASS_BLOCK(seed_importance_params, 16)

#endif
