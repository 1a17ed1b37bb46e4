/* passes/lights/vpl_tree.h to its shaders, and where nodes lie in its textures: node 1 is the root, 2 k and
 * 2 k + 1 are the children of k, and the last half of all are leaves. */
#ifndef SHARED_VPL_TREE_H
#define SHARED_VPL_TREE_H

#include "shared/types.h"

#define TREE_GROUP 64     /* invocations */
#define TREE_COLUMNS 1024 /* of textures */

/* Rows of a node: a layer each. */
#define TREE_LOW 0  /* of the box of places; the least squared reach of a near field, m2 */
#define TREE_HIGH 1 /* the same; the least area of a VPL, m2 */
#define TREE_CONE 2 /* of normals: axis, cosine of the half angle */
#define TREE_FLUX 3 /* of all VPLs below, W; its sum over RGB, 0 where there are none */
#define TREE_ROWS 4

struct vpl_tree_params {
    vec3 bounds_min; /* of the scene */
    int vpl_count;
    vec3 bounds_max;
    int leaves; /* a power of two, not below the count: the last are empty */
};
STD140_SIZE(vpl_tree_params, 32)

#endif
