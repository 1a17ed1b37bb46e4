/* A caster (scene/mesh/caster.h) and its GPU copy, drawn for depth alone: all opaque triangles at
 * once, masked ones batch by batch. */
#ifndef SCENE_GPU_CASTER_GPU_H
#define SCENE_GPU_CASTER_GPU_H

#include "scene/gpu/scene_gpu.h"
#include "scene/mesh/caster.h"

struct caster_gpu {
    struct caster caster;
    struct buffer positions, uvs; /* uvs of the base colour; only with alpha masks */
    struct buffer indices;        /* indices of all lists, in the order of their kinds */
    GLuint vertices;              /* vertex array of positions and uvs */
    unsigned pose;                /* pose of the geometry at the last upload */
};

/* Makes the caster of the geometry's current pose and uploads it. Error: out of GPU memory. */
bool caster_gpu_init(struct caster_gpu *gpu, const struct geometry *geometry,
                     const struct caster_desc *desc);
void caster_gpu_free(struct caster_gpu *gpu);

/* Uploads parts of the geometry that moved since the last upload. If its arrays were laid out
 * again, it uploads all into new buffers. Error: out of GPU memory; the caller must then free the
 * copy. */
bool caster_gpu_update(struct caster_gpu *gpu, const struct geometry *geometry);

bool caster_gpu_has_masked(const struct caster_gpu *gpu);

/* Triangles of a kind, drawn with gpu->vertices bound. Masked triangles, of which none is solid,
 * bind the scene's BLOCK_MATERIAL and UNIT_BASE_COLOR. */
struct caster_draw {
    enum caster_kind kind;
    int instances;
};
void caster_gpu_draw_opaque(const struct caster_gpu *gpu, const struct caster_draw *what);
void caster_gpu_draw_masked(const struct caster_gpu *gpu, const struct scene_gpu *scene,
                            const struct caster_draw *what);

#endif
