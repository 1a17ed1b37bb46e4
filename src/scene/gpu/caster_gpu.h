/* A caster (scene/mesh/caster.h) with its copy on the GPU, drawn for depth alone: all opaque
 * triangles at once, those with an alpha mask batch by batch. */
#ifndef SCENE_GPU_CASTER_GPU_H
#define SCENE_GPU_CASTER_GPU_H

#include "scene/gpu/scene_gpu.h"
#include "scene/mesh/caster.h"

struct caster_gpu {
    struct caster caster;
    struct buffer positions, uvs; /* uvs, the base colour's, only where there is an alpha mask */
    struct buffer indices;        /* of all lists, in the order of their kinds */
    GLuint vertices;              /* vertex array of positions and uvs */
    unsigned pose;                /* of the geometry, that was uploaded last */
};

/* Makes the caster of the geometry as it is posed now, and uploads it. Error: out of GPU memory. */
bool caster_gpu_init(struct caster_gpu *gpu, const struct geometry *geometry,
                     const struct caster_desc *desc);
void caster_gpu_free(struct caster_gpu *gpu);

/* Uploads the parts of the geometry that have moved since the last upload; all, into new buffers,
 * where its arrays were laid out anew. Error: out of GPU memory; the copy must then be freed. */
bool caster_gpu_update(struct caster_gpu *gpu, const struct geometry *geometry);

bool caster_gpu_has_masked(const struct caster_gpu *gpu);

/* With vertex array vertices: the triangles of a kind; the masked ones, of which none is of a solid, bind the scene's
 * BLOCK_MATERIAL and UNIT_BASE_COLOR. */
struct caster_draw {
    enum caster_kind kind;
    int instances;
};
void caster_gpu_draw_opaque(const struct caster_gpu *gpu, const struct caster_draw *what);
void caster_gpu_draw_masked(const struct caster_gpu *gpu, const struct scene_gpu *scene,
                            const struct caster_draw *what);

#endif
