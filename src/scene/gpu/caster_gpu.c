#include "scene/gpu/caster_gpu.h"

#include "base/clock.h"
#include "base/phases.h"

/* Where a list begins in the buffer of indices. */
static uint32_t first_of(const struct caster *caster, enum caster_kind kind) {
    uint32_t first = 0;
    for (int l = 0; l < (int)kind; l++)
        first += caster->list[l].index_count;
    return first;
}

static bool init_indices(struct caster_gpu *gpu) {
    const struct caster_list *list = gpu->caster.list;
    size_t count = first_of(&gpu->caster, CASTER_KIND_COUNT);
    if (!buffer_init(&gpu->indices, "caster indices", count * sizeof(uint32_t), NULL))
        return false;
    for (int l = 0; l < CASTER_KIND_COUNT; l++)
        buffer_write(&gpu->indices, first_of(&gpu->caster, (enum caster_kind)l) * sizeof(uint32_t),
                     list[l].index_count * sizeof(uint32_t), list[l].indices);
    return true;
}

bool caster_gpu_init(struct caster_gpu *gpu, const struct geometry *geometry,
                     const struct caster_desc *desc) {
    *gpu = (struct caster_gpu){0};
    double start = clock_ms();
    caster_init(&gpu->caster, geometry, desc);
    phase_add(PHASE_SIMPLIFY, start);
    gpu->pose = geometry->pose_count;
    if (init_indices(gpu))
        return true;
    caster_gpu_free(gpu);
    return false;
}

void caster_gpu_free(struct caster_gpu *gpu) {
    buffer_free(&gpu->indices);
    caster_free(&gpu->caster);
    *gpu = (struct caster_gpu){0};
}

/* --- what has moved --------------------------------------------------------------------------- */

/* The triangles of dynamic batches. The others keep theirs: where things move none of them is of a
 * solid, and whether it is seen from behind is all one to a depth map. */
static void update_indices(struct caster_gpu *gpu, const struct geometry *geometry) {
    for (int i = 0; i < geometry->blocking_batch_count; i++) {
        if (!geometry->batches[i].dynamic)
            continue;
        enum caster_kind kind = caster_take_batch(&gpu->caster, geometry, i);
        const struct caster_list *list = &gpu->caster.list[kind];
        const struct geometry_batch *batch = &list->batches[i];
        buffer_write(&gpu->indices,
                     (first_of(&gpu->caster, kind) + batch->first_index) * sizeof *list->indices,
                     batch->index_count * sizeof *list->indices,
                     list->indices + batch->first_index);
    }
}

bool caster_gpu_update(struct caster_gpu *gpu, const struct geometry *geometry) {
    unsigned seen = gpu->pose;
    gpu->pose = geometry->pose_count;
    if (geometry->laid_out > seen) {
        caster_lay_out(&gpu->caster, geometry);
        buffer_free(&gpu->indices);
        return init_indices(gpu);
    }
    bool rewound = false;
    for (int i = 0; i < geometry->part_count; i++)
        rewound |= geometry->parts[i].rewound > seen;
    if (rewound)
        update_indices(gpu, geometry);
    return true;
}

/* --- drawing ---------------------------------------------------------------------------------- */

GLuint caster_gpu_vertices(const struct caster_gpu *gpu, const struct scene_gpu *scene) {
    gl.VertexArrayElementBuffer(scene->caster_vertices, gpu->indices.id);
    return scene->caster_vertices;
}

static void draw(const struct caster_gpu *gpu, const struct caster_draw *what, uint32_t first,
                 uint32_t count) {
    size_t offset = (first_of(&gpu->caster, what->kind) + first) * sizeof(uint32_t);
    if (count)
        gl.DrawElementsInstancedBaseVertex(GL_TRIANGLES, (GLsizei)count, GL_UNSIGNED_INT,
                                           (const void *)offset, what->instances, 0);
}

bool caster_gpu_has_masked(const struct caster_gpu *gpu) {
    const struct caster_list *list = gpu->caster.list;
    return list[CASTER_SHORT].opaque_index_count < list[CASTER_SHORT].index_count ||
           list[CASTER_LONG].opaque_index_count < list[CASTER_LONG].index_count;
}

void caster_gpu_draw_opaque(const struct caster_gpu *gpu, const struct caster_draw *what) {
    draw(gpu, what, 0, gpu->caster.list[what->kind].opaque_index_count);
}

void caster_gpu_draw_masked(const struct caster_gpu *gpu, const struct scene_gpu *scene,
                            const struct caster_draw *what) {
    const struct caster_list *list = &gpu->caster.list[what->kind];
    for (int i = 0; i < gpu->caster.batch_count; i++) {
        const struct geometry_batch *batch = &list->batches[i];
        if (batch->first_index < list->opaque_index_count || !batch->index_count)
            continue;
        scene_gpu_bind_material(scene, batch->material);
        draw(gpu, what, batch->first_index, batch->index_count);
    }
}
