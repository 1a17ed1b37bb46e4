/* A virtual point light [Dong 2009 §4]. Transform feedback writes it (lib/vpl_output.glsl); it is
 * read as a vertex (lib/vpl_input.glsl), as texels (lib/vpl_texels.glsl) and in a block
 * (lib/vpl_block.glsl). */
#ifndef SHARED_VPL_H
#define SHARED_VPL_H

#include "shared/types.h"

#define VPL_ROWS 4

struct vpl {
    vec3 position; /* metres */
    float val;     /* C(i), the VAL it belongs to: a whole number */
    vec3 normal;   /* unit */
    float area;    /* that it stands for, m2 */
    vec3 flux;     /* reflected, W */
    float reach;   /* of its near field, in spacings of its light's VPLs; 0 for a sample that met nothing */
    vec2 to_light; /* where its light came from, octahedral */
    float alpha;   /* of the lobe by which it mirrors its light */
    float lobe;    /* the share of the flux that this lobe has, and the lobe's albedo: packHalf2x16; 0: none */
};
STD140_SIZE(vpl, 16 * VPL_ROWS)

/* Where light grazes a surface, a VPL's area is that of this cosine. */
#define VPL_COSINE_MIN 0.25

/* VPLs per uniform block: the 64 KiB that all drivers seen allow (gl/context/needs.h). */
#define VPLS_PER_BLOCK 1024
#define VPLS_MAX 65536

#endif
