/* Triangles with an alpha mask as opaque parts: 8 x 8 to a triangle, a bit each [Gruen et al. 2020]. Triangles of many
 * texels are cut in four first, at most twice.
 */
#ifndef SCENE_MESH_OPACITY_H
#define SCENE_MESH_OPACITY_H

#include "scene/mesh/geometry.h"
#include "scene/mesh/bvh.h"

/* Those that are found. */
struct opaque_triangles {
    struct bvh_triangle *items; /* of the heap; its owner's */
    uint32_t count, room;
};

void opaque_triangles_add(struct opaque_triangles *list, const struct bvh_triangle *triangle);

/* Adds what an alpha mask leaves of the triangles of a batch that has one. */
void opaque_triangles_add_masked(struct opaque_triangles *list, const struct scene *scene,
                                 const struct geometry *geometry,
                                 const struct geometry_batch *batch);

#endif
