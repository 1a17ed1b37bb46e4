/* A virtual point light, as transform feedback writes it [Dong 2009 §4]. */
#ifndef SHARED_VPL_H
#define SHARED_VPL_H

#include "shared/types.h"

struct vpl {
    vec4 position; /* metres; w: C(i), the VAL it belongs to */
    vec4 normal;   /* unit; w: the area it stands for, m2 */
    vec4 flux;     /* reflected flux, W; w: 1, or 0 for a sample that met nothing */
};

/* Where light grazes a surface, a VPL's area is that of this cosine. */
#define VPL_COSINE_MIN 0.25

/* VPLs per uniform block: 48 KiB, within the 64 KiB that all drivers seen allow (gl/needs.h). */
#define VPLS_PER_BLOCK 1024
#define VPLS_MAX 65536

#endif
