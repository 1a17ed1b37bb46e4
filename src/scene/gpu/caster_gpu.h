/* A caster (scene/mesh/caster.h) and the GPU copy of its indices, drawn for depth alone: all opaque
 * triangles at once, masked ones batch by batch. Vertices are the scene's. */
#ifndef SCENE_GPU_CASTER_GPU_H
#define SCENE_GPU_CASTER_GPU_H

#include "scene/gpu/scene_gpu.h"
#include "scene/mesh/caster.h"

struct caster_gpu {
    struct caster caster;
    struct buffer indices; /* indices of all lists, in the order of their kinds */
    unsigned pose;         /* pose of the geometry at the last upload */
};

/* Makes the caster of the geometry's current pose and uploads it. Error: out of GPU memory. */
bool caster_gpu_init(struct caster_gpu *gpu, const struct geometry *geometry,
                     const struct caster_desc *desc);
void caster_gpu_free(struct caster_gpu *gpu);

/* Uploads triangles of the geometry that changed since the last upload. If its arrays were laid out
 * again, it uploads all into a new buffer. Error: out of GPU memory; the caller must then free the
 * copy. */
bool caster_gpu_update(struct caster_gpu *gpu, const struct geometry *geometry);

bool caster_gpu_has_masked(const struct caster_gpu *gpu);

/* Prepares the scene's caster_vertices for the draws below, and returns it. */
GLuint caster_gpu_vertices(const struct caster_gpu *gpu, const struct scene_gpu *scene);

/* Triangles of a kind, drawn with caster_gpu_vertices bound. Masked triangles, of which none is
 * solid, bind the scene's BLOCK_MATERIAL and UNIT_BASE_COLOR. */
struct caster_draw {
    enum caster_kind kind;
    int instances;
};
void caster_gpu_draw_opaque(const struct caster_gpu *gpu, const struct caster_draw *what);
void caster_gpu_draw_masked(const struct caster_gpu *gpu, const struct scene_gpu *scene,
                            const struct caster_draw *what);

#endif
