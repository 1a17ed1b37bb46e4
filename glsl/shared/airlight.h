/* passes/picture/airlight.h to its shaders. */
#ifndef SHARED_AIRLIGHT_H
#define SHARED_AIRLIGHT_H

#include "shared/light.h"

#define UNIT_AIRLIGHT (UNIT_OWN + 0) /* what is blurred */

/* How a light is looked up and stepped along: with one view, with six, without a place. */
#define AIRLIGHT_SPOT 0
#define AIRLIGHT_POINT 1
#define AIRLIGHT_DIRECTIONAL 2
#define AIRLIGHT_KINDS 3

/* Pixels of a pattern of so many a side have steps at different places; the blur is as wide. */
#define AIRLIGHT_PATTERN 8

struct airlight_params {
    float scale; /* stored = radiance times this */
    float turn;  /* of the pass, from 0 to 1 */
    ivec2 along; /* of the blur */
    /* Of each light: steps; how wide its share of a lamp is, metres; AIRLIGHT_FLAT_... Of such a lamp its middle and
     * two half sides. */
    vec4 sources[LIGHTS_MAX], middles[LIGHTS_MAX], rights[LIGHTS_MAX], ups[LIGHTS_MAX];
};
PASS_BLOCK(airlight_params, 16 + 4 * 16 * LIGHTS_MAX)

/* Flat lamps, over which steps are spread. */
#define AIRLIGHT_FLAT_NONE 0
#define AIRLIGHT_FLAT_RECTANGLE 1
#define AIRLIGHT_FLAT_DISK 2

#endif
