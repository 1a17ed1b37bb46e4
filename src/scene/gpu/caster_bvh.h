/* The scene's triangles as rays of shaders meet them: a buffer texture for UNIT_BVH, as
 * scene/mesh/stackless_bvh.h lays it out. All triangles hide light, from both sides, but where
 * an alpha mask has a hole; panes have a tree of their own, for UNIT_PANES. */
#ifndef SCENE_GPU_CASTER_BVH_H
#define SCENE_GPU_CASTER_BVH_H

#include "gl/buffer.h"
#include "scene/mesh/geometry.h"

struct caster_bvh {
    struct buffer buffer;
    unsigned pose; /* of the geometry, that it is of */
    bool of_panes; /* scene/mesh/pane_triangles.h; set before the first time */
};

/* Makes it of where the geometry is now; zeroed before the first time. Error: out of GPU memory, or more triangles than a
 * buffer texture has room for; the tree must then be freed. */
bool caster_bvh_update(struct caster_bvh *tree, const struct scene *scene,
                       const struct geometry *geometry);
void caster_bvh_free(struct caster_bvh *tree);

#endif
