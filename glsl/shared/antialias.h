/* passes/picture/antialias.h to its shaders. */
#ifndef SHARED_ANTIALIAS_H
#define SHARED_ANTIALIAS_H

#include "shared/types.h"

#define UNIT_SAMPLE_DEPTH (UNIT_OWN + 0)
#define UNIT_SAMPLE_NORMAL (UNIT_OWN + 1)

#define SAMPLES_MAX 16
#define SAMPLES_PER_LAYER_MIN 4 /* which every driver has */

/* Of arrays a row has 16 bytes whatever it holds: x and y of it count. */
struct antialias_params {
    vec4 places[SAMPLES_MAX]; /* of the sample from the pixel's centre, pixels */
    vec4 shifts[SAMPLES_MAX / SAMPLES_PER_LAYER_MIN]; /* of each layer, in clip space */
};
PASS_BLOCK(antialias_params, 320)

#endif
