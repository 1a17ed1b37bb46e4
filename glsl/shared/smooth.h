/* Rays through glass and mirrors. */
#ifndef SHARED_SMOOTH_H
#define SHARED_SMOOTH_H

#include "shared/types.h"

/* passes/smooth_surfaces.h to shaders that follow rays through glass and mirrors. */
#define UNIT_TRIANGLE_ROWS (UNIT_OWN + 0)   /* of each triangle: its row of smooth materials, 0: none */
#define UNIT_SMOOTH_MATERIALS (UNIT_OWN + 1) /* SMOOTH_TEXELS a row, row 0 left out */
#define UNIT_CORNERS (UNIT_OWN + 2)
#define UNIT_CORNER_POSITIONS (UNIT_OWN + 3)
#define UNIT_CORNER_NORMALS (UNIT_OWN + 4) /* 16-bit signed fractions */
#define UNIT_SMOOTH_END (UNIT_OWN + 5) /* a pass has its own units from here on */
#define SMOOTH_TEXELS 3    /* base colour and kind; absorption and index of refraction; share let through, thin, two sides */
#define SMOOTH_IS_GLASS 1  /* enum smooth_kind, scene/material.h */
#define SMOOTH_IS_MIRROR 2

#define CHAIN_EVENTS 32 /* smooth surfaces that a ray meets at most */

/* passes/caustics/glass.h to its shader. */
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
STD140_SIZE(glass_params, 32)

#endif
