/* passes/gather/gather.h to its shader. */
#ifndef SHARED_GATHER_H
#define SHARED_GATHER_H

#include "shared/interleaving.h"

#define UNIT_PATHS_KEPT (UNIT_OWN + 0)
#define UNIT_CUTS (UNIT_OWN + 1)

/* What is gathered: irradiance, or what reflects as by a mirror, of VPLs as points, as balls, or as points as
 * far as rays do not find the same light better. */
#define SPECULAR_NONE 0
#define SPECULAR_POINT 1
#define SPECULAR_SPHERE 2
#define SPECULAR_RAYS 3

struct gather_params {
    STRUCT(interleaving) pattern;
    float scale;    /* of the stored irradiance */
    float clamp_at; /* 1/m2 */
    int block;      /* pixels a side of a block that shares its visibility */
    float turn;     /* of the numbers that say which VPL asks for others, from pass to pass */
    float sphere2;  /* squared radius of a VPL's ball, over the area that it stands for */
    int cut_block;  /* pixels a side of a block that shares a cut */
    int cut_layer;  /* the first of the cuts that are read */
    int gloss_rays; /* of a pixel */
    int together;   /* VPLs side by side, of which two ask for the visibility of all */
    int unused0, unused1, unused2;
};
PASS_BLOCK(gather_params, 64)

#endif
