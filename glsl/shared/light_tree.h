/* Nodes of a tree over lights (scene/lights/light_tree.h), and their importance at a point. */
#ifndef SHARED_LIGHT_TREE_H
#define SHARED_LIGHT_TREE_H

#include "shared/types.h"

#ifdef GL_core_profile
#define LIGHT_TREE_ROOT(x) sqrt(x)
#else
#include <math.h>
#define LIGHT_TREE_ROOT(x) sqrtf(x)
#endif

/* A node is three rows of four numbers. The root is node 0, and node 1 does not exist. */
#define LIGHT_NODE_ROWS 3

struct light_node {
    vec3 center;  /* of the box, metres; of distant lights: of unit directions to them */
    float radius; /* half the diagonal of the box */
    vec3 axis;    /* unit axis of the cone of its lights' axes */
    float cos_o;  /* cosine of the half angle of this cone */
    float power;  /* sum of intensities on the axis, mean of RGB, over the sum of all lights */
    float cos_e;  /* cosine of the greatest angle between an axis and its light */
    float reach;  /* greatest range of its lights, metres; 0: distant lights */
    int link; /* first of two adjacent children, which is even; leaf: -1 - number of its light */
};
STD140_SIZE(light_node, 16 * LIGHT_NODE_ROWS)

/* A triangle that emits to the side of the cross product of its edges. */
#define LIGHT_TRIANGLE_ROWS 3

struct light_triangle {
    vec3 corner; /* metres */
    float red;   /* mean radiance, W/(sr m2) */
    vec3 edge_1; /* from the corner to another, metres */
    float green;
    vec3 edge_2;
    float blue;
};
STD140_SIZE(light_triangle, 16 * LIGHT_TRIANGLE_ROWS)

/* Cosines are at least this where a light may arrive, for rounding. */
#define LIGHT_COSINE_MIN 1e-4f

/* Least squared distance, m2. */
#define LIGHT_DISTANCE2_MIN 1e-20f

/* Returns cos(max(a - b, 0)) of angles in [0, pi]. */
SHARED_FUNCTION float light_cos_less(float cos_a, float cos_b, float sin_b) {
    float sin_a = LIGHT_TREE_ROOT(cos_a < 1.0f && cos_a > -1.0f ? 1.0f - cos_a * cos_a : 0.0f);
    return cos_a > cos_b ? 1.0f : cos_a * cos_b + sin_a * sin_b;
}

/* Returns the greatest product of the cosine at the surface and the falloff of a node's lights
 * [Conty and Kulla 2018]; 0: no light arrives. distance2: squared distance to the
 * node's centre, m2. cos_normal: between the surface's normal and the direction to the centre.
 * cos_axis: between the node's axis and the direction from the centre to the surface. */
SHARED_FUNCTION float light_node_cosines(float distance2, float radius2, float cos_normal,
                                         float cos_axis, float cos_o, float cos_e) {
    float sin2_u = radius2 < distance2 ? radius2 / distance2 : 1.0f;
    float sin_u = radius2 < distance2 ? LIGHT_TREE_ROOT(sin2_u) : 0.0f;
    float cos_u = radius2 < distance2 ? LIGHT_TREE_ROOT(1.0f - sin2_u) : -1.0f;
    float receives = light_cos_less(cos_normal, cos_u, sin_u), sends = 1.0f;
    if (cos_o > -1.0f) {
        float sin_o = LIGHT_TREE_ROOT(cos_o < 1.0f ? 1.0f - cos_o * cos_o : 0.0f);
        sends = light_cos_less(light_cos_less(cos_axis, cos_o, sin_o), cos_u, sin_u);
    }
    if (receives < -LIGHT_COSINE_MIN || sends < cos_e - LIGHT_COSINE_MIN)
        return 0.0f;
    receives = receives > LIGHT_COSINE_MIN ? receives : LIGHT_COSINE_MIN;
    return receives * (sends > LIGHT_COSINE_MIN ? sends : LIGHT_COSINE_MIN);
}

#endif
