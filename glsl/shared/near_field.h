/* passes/gather/near_field.h to its shaders. */
#ifndef SHARED_NEAR_FIELD_H
#define SHARED_NEAR_FIELD_H

#include "shared/interleaving.h"

/* What hides near light: nothing; what the light sees; all triangles. */
#define NEAR_UNOCCLUDED 0
#define NEAR_BY_VIEWS 1
#define NEAR_BY_RAYS 2

struct near_field_params {
    STRUCT(interleaving) pattern;
    float power_scale;    /* of the stored power: that of the irradiance over the squared radius */
    float inverse_radius; /* of the scene, 1/m */
    float turn; /* of the numbers that say which sample asks for others, from pass to pass */
    float unused;
};
PASS_BLOCK(near_field_params, 32)

/* A place around the receiver's own in a light's view (base/spiral.h). */
struct near_sample {
    vec2 direction; /* unit, before it is turned */
    float number;
    float unused;
};
STD140_SIZE(near_sample, 16)

#define NEAR_SAMPLES_MAX 1024

#endif
