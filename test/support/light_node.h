/* The bound of a node of a light tree, in C [Walter et al. 2005, Lightcuts]: how much the node can
 * give at most follows from the box of its lights' places and the cone of their normals. */
#ifndef TEST_LIGHT_NODE_H
#define TEST_LIGHT_NODE_H

#include "base/unit.h"
#include "reference/geometry_term.h"
#include "reference/vector.h"
#include "reference/warp.h"
#include "shared/vpl.h"

#include <math.h>

/* Bounds are taken so much wider than they are, for the rounding of what they bound. */
static const float rounding = 1e-5F;

/* A box of points and a cone of normals there. */
struct light_extent {
    vec3s low, high;
    vec3s axis;         /* unit */
    float cosine, sine; /* of the cone's half angle, up to pi; -1 and 0: all directions */
};

struct light_node {
    struct light_extent extent;
    vec3s flux;         /* of all lights below, W */
    float power;        /* the sum of it, over RGB */
    float area;         /* the least of all lights below, m2 */
    int representative; /* index of the VPL */
    int children[2];    /* indices of nodes; both 0: a leaf, which is its representative */
};

/* --- bounds ----------------------------------------------------------------------------------- */

struct interval {
    float low, high;
};

/* Of direction . v over a box of v. */
static inline struct interval project(vec3s direction, vec3s low, vec3s high) {
    struct interval sum = {0, 0};
    for (int c = 0; c < 3; c++) {
        float a = direction.raw[c] * low.raw[c], b = direction.raw[c] * high.raw[c];
        sum.low += fminf(a, b);
        sum.high += fmaxf(a, b);
    }
    return sum;
}

static inline float least_square(struct interval x) {
    float nearest = fmaxf(fmaxf(x.low, -x.high), 0);
    return nearest * nearest;
}

static inline float greatest_square(struct interval x) {
    return fmaxf(x.low * x.low, x.high * x.high);
}

/* The greatest cosine between a direction of the cone and a vector of the box. */
static inline float greatest_cosine(const struct light_extent *cone, vec3s low, vec3s high) {
    vec3s x_axis = warp_perpendicular(cone->axis);
    struct interval z = project(cone->axis, low, high), x = project(x_axis, low, high),
                    y = project(glms_vec3_cross(cone->axis, x_axis), low, high);
    float along = z.high + rounding * (z.high - z.low);
    float across2 =
        along >= 0 ? least_square(x) + least_square(y) : greatest_square(x) + greatest_square(y);
    float length = sqrtf(across2 + along * along);
    float cosine = length > 0 ? fminf(along / length + rounding, 1) : 1;
    if (cosine >= cone->cosine)
        return 1;
    return fmaxf(cosine * cone->cosine + sqrtf(1 - cosine * cosine) * cone->sine, 0);
}

/* No geometry term between a point of the extent and a light of the node is above this; INFINITY
 * where they may touch and nothing else bounds it. */
static inline float light_node_bound(const struct light_node *node,
                                     const struct light_extent *receiver,
                                     const struct geometry_term *term) {
    vec3s low = glms_vec3_sub(node->extent.low, receiver->high),
          high = glms_vec3_sub(node->extent.high, receiver->low);
    float distance2 = 0;
    for (int c = 0; c < 3; c++)
        distance2 += least_square((struct interval){low.raw[c], high.raw[c]});
    float cosines = greatest_cosine(receiver, low, high) *
                    greatest_cosine(&node->extent, glms_vec3_negate(high), glms_vec3_negate(low));
    return cosines > 0 ? geometry_term(term, cosines * (1 + rounding), distance2, node->area) : 0;
}

#endif
