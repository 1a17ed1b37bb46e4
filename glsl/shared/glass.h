/* passes/caustics/glass.h to its shader. */
#ifndef SHARED_GLASS_H
#define SHARED_GLASS_H

#include "shared/smooth.h"

#define UNIT_GLASS_TRIANGLES (UNIT_SMOOTH_END + 0) /* two texels each: what it reflects, 1 if its back does, too; glow */
#define UNIT_GLASS_SCREEN (UNIT_SMOOTH_END + 1)    /* LAYER_SENT */
#define UNIT_GLASS_SKY (UNIT_SMOOTH_END + 2)

struct glass_params {
    float reach; /* what lies so near a surface of the picture is that surface, metres */
    float scale; /* radiance per stored glow */
    float sky_strength, sky_turn;
    int chains; /* of a pixel that shows glass */
    int rays;   /* for the indirect light of a place outside the picture */
    int pass;
    float unused;
};
PASS_BLOCK(glass_params, 32)

#endif
