/* Triangles as an eye in the middle of a bins' cube sees them. */
#ifndef TECHNIQUES_IMPLICIT_VISIBILITY_TRIANGLE_H
#define TECHNIQUES_IMPLICIT_VISIBILITY_TRIANGLE_H

#include "techniques/implicit-visibility/bins.h"

struct triangle {
    vec3s corners[3]; /* from the eye */
    vec3s across[3];  /* of the planes through the eye and an edge */
    vec3s normal;     /* of any length */
    float along;      /* corner . normal; negative: the eye sees the front */
};

struct triangle triangle_of(const vec3s corners[3]);

/* Along the ray, in its lengths; INFINITY: it misses the triangle. A ray through an edge meets both neighbours. */
float triangle_distance(const struct triangle *triangle, vec3s ray);

/* Bins of a face whose middle rays the triangle may meet. False: none. */
bool triangle_window(const struct triangle *triangle, const struct bins *bins, int face,
                     struct bins_window *window);

#endif
