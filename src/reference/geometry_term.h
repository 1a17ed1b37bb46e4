/* The geometry term between a receiver and a virtual point light, cos_i cos_x / d^2, and its bounds
 * at short distance. It grows with the cosines and falls with distance and area, so bounds of these
 * bound it too. */
#ifndef REFERENCE_GEOMETRY_TERM_H
#define REFERENCE_GEOMETRY_TERM_H

#include <math.h>

#include "base/unit.h"

enum geometry_bound {
    GEOMETRY_UNBOUNDED,
    GEOMETRY_CLAMPED, /* at most clamp_value */
    GEOMETRY_DISK,    /* cos_i cos_x / (d^2 + area / pi): a disk [Prutkin 2012, eq. 2] */
};

struct geometry_term {
    enum geometry_bound bound;
    float clamp_value; /* 1/m2 */
};

/* Returns the term. cosines: product of both cosines. distance2: squared distance, m2. area: of the
 * VPL, m2. */
static inline float geometry_term(const struct geometry_term *term, float cosines, float distance2,
                                  float area) {
    switch (term->bound) {
    case GEOMETRY_CLAMPED:
        return fminf(cosines / distance2, term->clamp_value);
    case GEOMETRY_DISK:
        return cosines / (distance2 + area * GLM_1_PIf);
    case GEOMETRY_UNBOUNDED:
        break;
    }
    return cosines / distance2;
}

#endif
