/* Parameters of passes/picture/composite.h. */
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
    int layer;      /* layer to write, LAYER_... */
    int samples;    /* samples of a pixel */
    float indirect; /* radiance of a white surface per stored irradiance */
    float scale;    /* radiance per stored radiance */
    float exposure; /* factor */
    BOOL filmic;    /* filmic tone map; else values are clamped */
    /* Weight of a pass when added to a sum, or of the sum. 0: the layer is written as it is. */
    float weight;
    float sky_strength; /* factor of the environment's texels; 0: invisible */
    float sky_turn;     /* radians */
    int background;     /* BACKGROUND_... */
    float unused0, unused1;
    vec3 background_colour; /* display values */
    float unused2;
};
PASS_BLOCK(composite_params, 64)

/* Behind all surfaces: the environment or black; nothing, alpha 0; a colour. */
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
#define LAYER_SPECULAR 6 /* first layer of scenes with materials that are not plain */
#define LAYER_DIRECT_SPECULAR 7
#define LAYER_INDIRECT_SPECULAR 8
#define LAYER_AIRLIGHT 9 /* with a medium */
#define LAYER_CAUSTIC 10 /* caustics on surfaces */
#define LAYER_VOLUME 11  /* caustics in a medium */
#define LAYERS 12

/* Not a layer of files. Input of glass and mirrors (passes/caustics/glass.h): radiance of the
 * pixel's centre, without the medium. A: its indirect fraction. */
#define LAYER_SENT 12

#endif
