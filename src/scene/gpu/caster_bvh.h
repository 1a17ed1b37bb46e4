/* The scene's triangles for rays of shaders: a buffer texture for UNIT_BVH in the layout of
 * scene/mesh/stackless_bvh.h. All triangles block light from both sides, except holes of alpha
 * masks. Panes have a BVH of their own, for UNIT_PANES. */
#ifndef SCENE_GPU_CASTER_BVH_H
#define SCENE_GPU_CASTER_BVH_H

#include "gl/buffer.h"
#include "scene/mesh/bvh.h"
#include "scene/mesh/geometry.h"

struct caster_bvh {
    struct buffer buffer;
    struct bvh built; /* on the CPU, once the geometry has moved; else none */
    unsigned pose;    /* pose of the geometry at the last build */
    bool of_panes;    /* only panes (scene/mesh/pane_triangles.h); set it before the first update */
};

/* Builds the BVH for the geometry's current pose; zeroed before the first call. Error: out of GPU
 * memory, or more triangles than a buffer texture allows; the caller must then free it. */
bool caster_bvh_update(struct caster_bvh *tree, const struct scene *scene,
                       const struct geometry *geometry);
void caster_bvh_free(struct caster_bvh *tree);

#endif
