/* passes/picture/composite.h to its shaders. */
#ifndef SHARED_COMPOSITE_H
#define SHARED_COMPOSITE_H

#include "shared/types.h"

#define UNIT_SKY (UNIT_OWN + 0)
#define UNIT_IN_SCATTER (UNIT_OWN + 1)
#define UNIT_TRANSMITTANCE (UNIT_OWN + 2)
#define UNIT_EDGE_SAMPLE_TEXELS (UNIT_OWN + 3)
#define UNIT_EDGE_SAMPLE_IRRADIANCE (UNIT_OWN + 4)
#define UNIT_CAUSTIC (UNIT_OWN + 5)
#define UNIT_VOLUME_CAUSTIC (UNIT_OWN + 6)
#define UNIT_LAYER_SUMS (UNIT_OWN + 7) /* LAYERS of them */

struct composite_params {
    int layer;      /* what to write, LAYER_... */
    int samples;    /* of a pixel */
    float indirect; /* radiance of a white surface per stored irradiance */
    float scale;    /* radiance per stored radiance */
    float exposure; /* factor */
    BOOL filmic;    /* tone map; else values are clamped */
    float
        weight; /* of the pass, where its layer is added to a sum; of a sum; 0: a layer as it is */
    float sky_strength; /* factor of its texels; 0: it is not seen */
    float sky_turn;     /* radians */
    int background;     /* BACKGROUND_... */
    float unused0, unused1;
    vec3 background_colour; /* light of the display */
    float unused2;
};
PASS_BLOCK(composite_params, 64)

/* Behind all surfaces: the sky or black; nothing, which alpha tells; a colour. */
#define BACKGROUND_SCENE 0
#define BACKGROUND_NONE 1
#define BACKGROUND_COLOUR 2

#define LAYER_BEAUTY 0
#define LAYER_DIRECT 1
#define LAYER_INDIRECT 2
#define LAYER_ALBEDO 3
#define LAYER_NORMAL 4
#define LAYER_DEPTH 5
#define LAYERS_PLAIN 6
#define LAYER_SPECULAR 6 /* of scenes whose materials are not all plain, and those below */
#define LAYER_DIRECT_SPECULAR 7
#define LAYER_INDIRECT_SPECULAR 8
#define LAYER_AIRLIGHT 9 /* of a medium */
#define LAYER_CAUSTIC 10 /* of smooth surfaces, on others */
#define LAYER_VOLUME 11  /* likewise, in a medium */
#define LAYERS 12

/* For glass and mirrors, which show it (passes/caustics/glass.h): what a pixel's middle sends, without the medium; A: the
 * part of it that is indirect light. Not among the layers. */
#define LAYER_SENT 12

#endif
