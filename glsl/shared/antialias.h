/* Parameters of passes/picture/antialias.h. */
#ifndef SHARED_ANTIALIAS_H
#define SHARED_ANTIALIAS_H

#include "shared/types.h"

#define UNIT_SAMPLE_DEPTH (UNIT_OWN + 0)
#define UNIT_SAMPLE_NORMAL (UNIT_OWN + 1)

#define SAMPLES_MAX 16
#define SAMPLES_PER_LAYER_MIN 4 /* every driver has 4 */

/* A row of an array has 16 bytes; only x and y are used. */
struct antialias_params {
    vec4 places[SAMPLES_MAX]; /* offset of the sample from the pixel's centre, pixels */
    vec4 shifts[SAMPLES_MAX / SAMPLES_PER_LAYER_MIN]; /* of each layer, in clip space */
};
PASS_BLOCK(antialias_params, 320)

#endif
