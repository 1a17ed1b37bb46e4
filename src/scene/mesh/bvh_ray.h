/* Traces a few rays on the CPU at load. Shaders use passes/visibility/bvh.glsl; the path tracer
 * uses Embree (reference/scene/ray_scene.h). */
#ifndef SCENE_MESH_BVH_RAY_H
#define SCENE_MESH_BVH_RAY_H

#include "scene/mesh/bvh.h"

struct bvh_hit {
    const struct bvh_triangle *triangle; /* NULL: no hit */
    float distance;                      /* over the direction's length */
    bool front;                          /* hits the front; else the back */
};

/* Returns the nearest triangle, opaque or not, from either side. It gives up after BVH_RAY_TESTS
 * triangle tests, for files with thousands of triangles in one place. The tree must not be
 * empty. */
enum { BVH_RAY_TESTS = 2048 };
struct bvh_hit bvh_ray_trace(const struct bvh *tree, vec3s origin, vec3s direction);

/* Returns the nearest triangle that is opaque at the hit point. */
struct bvh_hit bvh_ray_trace_opaque(const struct bvh *tree, vec3s origin, vec3s direction);

#endif
