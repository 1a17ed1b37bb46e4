/* Rays through glass and mirrors. */
#ifndef SHARED_SMOOTH_H
#define SHARED_SMOOTH_H

#include "shared/types.h"

/* Data of passes/smooth_surfaces.h, for shaders that trace rays through glass and mirrors. */
#define UNIT_TRIANGLE_ROWS (UNIT_OWN + 0)    /* material row of each triangle; 0: none */
#define UNIT_SMOOTH_MATERIALS (UNIT_OWN + 1) /* SMOOTH_TEXELS a row; row 0 is omitted */
#define UNIT_CORNERS (UNIT_OWN + 2)
#define UNIT_CORNER_POSITIONS (UNIT_OWN + 3)
#define UNIT_CORNER_NORMALS (UNIT_OWN + 4) /* 16-bit signed fractions */
#define UNIT_SMOOTH_END (UNIT_OWN + 5)     /* first own unit of a pass */
/* Base colour, kind; absorption, index of refraction; transmittance, thin, two sides. */
#define SMOOTH_TEXELS 3
#define SMOOTH_IS_GLASS 1 /* enum smooth_kind, scene/material.h */
#define SMOOTH_IS_MIRROR 2

#define CHAIN_EVENTS 32 /* most smooth surfaces of a ray */

/* Parameters of passes/caustics/glass.h. */
#define UNIT_GLASS_TRIANGLES (UNIT_SMOOTH_END + 0) /* albedo, 1 if two-sided; emission */
#define UNIT_GLASS_SCREEN (UNIT_SMOOTH_END + 1)    /* LAYER_SENT */
#define UNIT_GLASS_SKY (UNIT_SMOOTH_END + 2)

struct glass_params {
    float reach; /* distance within which a point counts as a visible surface, metres */
    float scale; /* radiance per stored emission */
    float sky_strength, sky_turn;
    int chains; /* chains of a pixel of glass */
    int rays;   /* rays for the indirect light of a point outside the picture */
    int pass;
    float unused;
};
STD140_SIZE(glass_params, 32)

#endif
