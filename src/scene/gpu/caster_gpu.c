#include "scene/gpu/caster_gpu.h"

#include "base/memory.h"
#include "gl/vertex_array.h"
#include "shared/bindings.h"

#include <stdlib.h>

/* The geometry's values, then those of the extra vertices. */
static bool init_attribute(struct buffer *buffer, const char *label, const struct caster *caster,
                           size_t width, const void *base, const void *extra) {
    size_t base_size = caster->base_count * width, extra_size = caster->extra_count * width;
    if (!buffer_init(buffer, label, base_size + extra_size, NULL))
        return false;
    buffer_write(buffer, 0, base_size, base);
    buffer_write(buffer, base_size, extra_size, extra);
    return true;
}

static bool init_attributes(struct caster_gpu *gpu, const struct geometry *geometry) {
    const struct caster *caster = &gpu->caster;
    bool masked = caster_gpu_has_masked(gpu);
    float(*uv)[2] = masked ? mem_alloc(caster->extra_count, sizeof *uv) : NULL;
    gpu->extra = mem_alloc(caster->extra_count, sizeof *gpu->extra);
    caster_fill(caster, geometry, gpu->extra, uv);
    bool ok =
        init_attribute(&gpu->positions, "caster positions", caster, sizeof *gpu->extra,
                       geometry->position, gpu->extra) &&
        (!masked || init_attribute(&gpu->uvs, "caster uvs", caster, sizeof *uv, geometry->uv, uv));
    free(uv);
    return ok;
}

static bool init_buffers(struct caster_gpu *gpu, const struct geometry *geometry) {
    const struct caster *caster = &gpu->caster;
    gpu->pose = geometry->pose_count;
    if (!init_attributes(gpu, geometry) ||
        !buffer_init(&gpu->indices, "caster indices", caster->index_count * sizeof *caster->indices,
                     caster->indices))
        return false;
    gl.CreateVertexArrays(1, &gpu->vertices);
    vertex_array_attribute(gpu->vertices, ATTRIBUTE_POSITION,
                           &(struct vertex_attribute){&gpu->positions, 3, GL_FLOAT, 12, 0});
    if (gpu->uvs.id)
        vertex_array_attribute(gpu->vertices, ATTRIBUTE_UV,
                               &(struct vertex_attribute){&gpu->uvs, 2, GL_FLOAT, 8, 0});
    gl.VertexArrayElementBuffer(gpu->vertices, gpu->indices.id);
    return true;
}

static void free_buffers(struct caster_gpu *gpu) {
    vertex_array_free(&gpu->vertices);
    buffer_free(&gpu->positions);
    buffer_free(&gpu->uvs);
    buffer_free(&gpu->indices);
    free(gpu->extra);
    gpu->extra = NULL;
}

bool caster_gpu_init(struct caster_gpu *gpu, const struct geometry *geometry,
                     const struct caster_desc *desc) {
    *gpu = (struct caster_gpu){0};
    caster_init(&gpu->caster, geometry, desc);
    if (init_buffers(gpu, geometry))
        return true;
    caster_gpu_free(gpu);
    return false;
}

void caster_gpu_free(struct caster_gpu *gpu) {
    free_buffers(gpu);
    caster_free(&gpu->caster);
    *gpu = (struct caster_gpu){0};
}

/* --- what has moved --------------------------------------------------------------------------- */

static void update_vertices(struct caster_gpu *gpu, const struct geometry *geometry, int index) {
    const struct geometry_part *part = &geometry->parts[index];
    const struct caster_part *extra = &gpu->caster.parts[index];
    size_t size = sizeof *gpu->extra;
    caster_fill_part(&gpu->caster, geometry, index, gpu->extra);
    buffer_write(&gpu->positions, part->first_vertex * size, part->vertex_count * size,
                 geometry->position + part->first_vertex);
    buffer_write(&gpu->positions, (gpu->caster.base_count + extra->first_extra) * size,
                 extra->extra_count * size, gpu->extra + extra->first_extra);
}

/* The triangles of dynamic batches. The others keep theirs: whether a triangle is seen from behind
 * is all one to a depth map. */
static void update_indices(struct caster_gpu *gpu, const struct geometry *geometry) {
    struct caster *caster = &gpu->caster;
    for (int i = 0; i < caster->batch_count; i++) {
        const struct geometry_batch *batch = &caster->batches[i];
        if (!batch->dynamic)
            continue;
        caster_take_batch(caster, geometry, i);
        buffer_write(&gpu->indices, batch->first_index * sizeof *caster->indices,
                     batch->index_count * sizeof *caster->indices,
                     caster->indices + batch->first_index);
    }
}

bool caster_gpu_update(struct caster_gpu *gpu, const struct geometry *geometry) {
    unsigned seen = gpu->pose;
    if (geometry->laid_out > seen) {
        caster_lay_out(&gpu->caster, geometry);
        free_buffers(gpu);
        return init_buffers(gpu, geometry);
    }
    gpu->pose = geometry->pose_count;
    bool rewound = false;
    for (int i = 0; i < geometry->part_count; i++) {
        if (geometry->parts[i].moved > seen)
            update_vertices(gpu, geometry, i);
        rewound |= geometry->parts[i].rewound > seen;
    }
    if (rewound)
        update_indices(gpu, geometry);
    return true;
}

/* --- drawing ---------------------------------------------------------------------------------- */

bool caster_gpu_has_masked(const struct caster_gpu *gpu) {
    return gpu->caster.opaque_index_count < gpu->caster.index_count;
}

void caster_gpu_draw_opaque(const struct caster_gpu *gpu, int instances) {
    GLsizei count = (GLsizei)gpu->caster.opaque_index_count;
    if (count)
        gl.DrawElementsInstanced(GL_TRIANGLES, count, GL_UNSIGNED_INT, NULL, instances);
}

void caster_gpu_draw_masked(const struct caster_gpu *gpu, const struct scene_gpu *scene,
                            int instances) {
    const struct caster *caster = &gpu->caster;
    for (int i = 0; i < caster->batch_count; i++)
        if (caster->batches[i].first_index >= caster->opaque_index_count)
            scene_gpu_draw_batch(scene, &caster->batches[i], instances);
}
