/* Rays on the CPU through a tree of triangles: a few at load. Shaders have passes/visibility/bvh.glsl, the path
 * tracer Embree (reference/scene/ray_scene.h).
 */
#ifndef SCENE_MESH_BVH_RAY_H
#define SCENE_MESH_BVH_RAY_H

#include "scene/mesh/bvh.h"

struct bvh_hit {
    const struct bvh_triangle *triangle; /* NULL = the ray meets none */
    float distance;                      /* over the direction's length */
    bool front;                          /* else it comes from behind */
};

/* The nearest triangle beyond the origin, opaque or not, from either side; none where the ray would ask more than so many,
 * as where a file has thousands in one place. The tree has one at least. */
enum { BVH_RAY_TESTS = 2048 };
struct bvh_hit bvh_ray_trace(const struct bvh *tree, vec3s origin, vec3s direction);

/* The nearest one of those that are opaque where the ray meets them. */
struct bvh_hit bvh_ray_trace_opaque(const struct bvh *tree, vec3s origin, vec3s direction);

#endif
