/* passes/gather/near_field.h to its shaders. */
#ifndef SHARED_NEAR_FIELD_H
#define SHARED_NEAR_FIELD_H

#include "shared/interleaving.h"

struct near_field_params {
    STRUCT(interleaving) pattern;
    float vpl_share;      /* solid angle of one VPL, sr; of a directional light's area, m2 */
    float reach;          /* of the near field, in spacings of VPLs */
    float power_scale;    /* of the stored power: that of the irradiance over the squared radius */
    float inverse_radius; /* of the scene, 1/m */
};
PASS_BLOCK(near_field_params, 32)

/* A place around the receiver's own in the light's view. */
struct near_sample {
    vec2 direction;   /* unit */
    float log_radius; /* 0 at the least radius, 1 at the greatest */
    float unused;
};
STD140_SIZE(near_sample, 16)

#define NEAR_SAMPLES_MAX 1024

#endif
