/* passes/gather/near_field.h to its shaders. */
#ifndef SHARED_NEAR_FIELD_H
#define SHARED_NEAR_FIELD_H

#include "shared/interleaving.h"

#define UNIT_NEAR_LIGHT (UNIT_OWN + 0) /* LIGHT_MAP_KINDS of them: shared/light.h */

/* What hides near light: nothing; what the light sees; all triangles. */
#define NEAR_UNOCCLUDED 0
#define NEAR_BY_VIEWS 1
#define NEAR_BY_RAYS 2
/* Of so many samples one, taken by its light, asks for all: on average each counts as if it had asked. */
#define NEAR_TOGETHER 16

struct near_field_params {
    STRUCT(interleaving) pattern;
    float power_scale;    /* of the stored power: that of the irradiance over the squared radius */
    float inverse_radius; /* of the scene, 1/m */
    float turn; /* of the numbers that say which sample asks for others, from pass to pass */
    float unused;
    vec2 next_turn; /* from sample to sample, cosine and sine (base/spiral.h) */
    vec2 unused2;
};
PASS_BLOCK(near_field_params, 48)

#define NEAR_SAMPLES_MAX 1024

#endif
