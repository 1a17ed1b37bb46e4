#include "scene/scene_gpu.h"

#include "base/memory.h"
#include "shared/material.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MATERIAL_STRIDE = 256 }; /* no driver asks for a larger uniform offset alignment */

static bool upload_positions(struct scene_gpu *gpu, const struct geometry *geometry,
                             const struct caster *caster) {
    size_t count = geometry->vertex_count + caster->extra_count;
    float(*positions)[3] = mem_alloc(count, sizeof *positions);
    float(*uvs)[2] = mem_alloc(count, sizeof *uvs);
    memcpy(positions, geometry->position, geometry->vertex_count * sizeof *positions);
    memcpy(uvs, geometry->uv, geometry->vertex_count * sizeof *uvs);
    caster_fill(caster, geometry, positions + geometry->vertex_count, uvs + geometry->vertex_count);
    bool ok =
        buffer_init(&gpu->positions, "scene positions", count * sizeof *positions, positions) &&
        buffer_init(&gpu->uvs, "scene uvs", count * sizeof *uvs, uvs);
    free(positions);
    free(uvs);
    return ok;
}

/* Normals as 16-bit signed, colours as 16-bit unsigned fractions, four each. */
static bool upload_attributes(struct scene_gpu *gpu, const struct geometry *geometry) {
    size_t count = geometry->vertex_count;
    int16_t(*normals)[4] = mem_alloc(count, sizeof *normals);
    uint16_t(*colors)[4] = mem_alloc(count, sizeof *colors);
    for (size_t i = 0; i < count; i++) {
        for (int c = 0; c < 3; c++)
            normals[i][c] = (int16_t)lrintf(geometry->normal[i][c] * 32767);
        for (int c = 0; c < 4; c++)
            colors[i][c] = (uint16_t)lrintf(fminf(fmaxf(geometry->color[i][c], 0), 1) * 65535);
    }
    bool ok = buffer_init(&gpu->normals, "scene normals", count * sizeof *normals, normals) &&
              buffer_init(&gpu->colors, "scene colours", count * sizeof *colors, colors);
    free(normals);
    free(colors);
    return ok;
}

static bool upload_materials(struct scene_gpu *gpu, const struct scene *scene) {
    size_t size = (size_t)scene->material_count * MATERIAL_STRIDE;
    unsigned char *bytes = mem_alloc(size, 1);
    for (int i = 0; i < scene->material_count; i++) {
        const struct material *material = &scene->materials[i];
        struct material_block block = {
            .alpha_cutoff = material->alpha_mask ? material->alpha_cutoff : -1,
            .double_sided = material->double_sided,
            .textured = material->texture >= 0,
        };
        memcpy(block.base_color, material->base_color, sizeof block.base_color);
        memcpy(bytes + i * MATERIAL_STRIDE, &block, sizeof block);
    }
    bool ok = buffer_init(&gpu->materials, "scene materials", size, bytes);
    free(bytes);
    return ok;
}

static bool upload_texture(struct texture *texture, const struct scene_texture *source) {
    static const GLenum wraps[] = {GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT};
    const struct bitmap *bitmap = &source->bitmap;
    int levels = source->nearest ? 1 : texture_full_levels(bitmap->width, bitmap->height);
    if (!texture_init(texture, &(struct texture_desc){
                                   .label = "scene textures",
                                   .format = GL_SRGB8_ALPHA8,
                                   .width = bitmap->width,
                                   .height = bitmap->height,
                                   .levels = levels,
                                   .filter = source->nearest ? FILTER_NEAREST : FILTER_TRILINEAR,
                                   .wrap_s = wraps[source->wrap_u],
                                   .wrap_t = wraps[source->wrap_v],
                               }))
        return false;
    gl.TextureSubImage2D(texture->id, 0, 0, 0, bitmap->width, bitmap->height, GL_RGBA,
                         GL_UNSIGNED_BYTE, bitmap->rgba);
    if (levels > 1)
        gl.GenerateTextureMipmap(texture->id);
    return true;
}

static bool upload_textures(struct scene_gpu *gpu, const struct scene *scene) {
    gpu->textures = mem_alloc((size_t)scene->texture_count, sizeof *gpu->textures);
    gpu->texture_count = scene->texture_count;
    for (int i = 0; i < scene->texture_count; i++)
        if (!upload_texture(&gpu->textures[i], &scene->textures[i]))
            return false;
    return true;
}

static void add_attribute(GLuint vertices, GLuint location, const struct buffer *buffer,
                          GLint count, GLenum type, GLsizei stride) {
    gl.VertexArrayVertexBuffer(vertices, location, buffer->id, 0, stride);
    gl.VertexArrayAttribFormat(vertices, location, count, type, type != GL_FLOAT, 0);
    gl.VertexArrayAttribBinding(vertices, location, location);
    gl.EnableVertexArrayAttrib(vertices, location);
}

static void make_vertex_arrays(struct scene_gpu *gpu) {
    gl.CreateVertexArrays(1, &gpu->shaded_vertices);
    add_attribute(gpu->shaded_vertices, 0, &gpu->positions, 3, GL_FLOAT, 12);
    add_attribute(gpu->shaded_vertices, 1, &gpu->normals, 3, GL_SHORT, 8);
    add_attribute(gpu->shaded_vertices, 2, &gpu->uvs, 2, GL_FLOAT, 8);
    add_attribute(gpu->shaded_vertices, 3, &gpu->colors, 4, GL_UNSIGNED_SHORT, 8);
    gl.VertexArrayElementBuffer(gpu->shaded_vertices, gpu->indices.id);
    gl.CreateVertexArrays(1, &gpu->caster_vertices);
    add_attribute(gpu->caster_vertices, 0, &gpu->positions, 3, GL_FLOAT, 12);
    add_attribute(gpu->caster_vertices, 2, &gpu->uvs, 2, GL_FLOAT, 8);
    gl.VertexArrayElementBuffer(gpu->caster_vertices, gpu->caster_indices.id);
}

static void copy_batches(struct scene_gpu *gpu, const struct geometry *geometry,
                         const struct caster *caster) {
    gpu->batch_count = geometry->batch_count;
    gpu->batches = mem_alloc((size_t)geometry->batch_count, sizeof *gpu->batches);
    memcpy(gpu->batches, geometry->batches, (size_t)geometry->batch_count * sizeof *gpu->batches);
    gpu->opaque_caster_indices = caster->opaque_index_count;
    gpu->masked_casters = mem_alloc((size_t)caster->batch_count, sizeof *gpu->masked_casters);
    for (int i = 0; i < caster->batch_count; i++)
        if (caster->batches[i].first_index >= caster->opaque_index_count)
            gpu->masked_casters[gpu->masked_caster_count++] = caster->batches[i];
}

bool scene_gpu_init(struct scene_gpu *gpu, const struct scene *scene,
                    const struct geometry *geometry, const struct caster *caster) {
    *gpu = (struct scene_gpu){.scene = scene, .vertex_count = geometry->vertex_count};
    copy_batches(gpu, geometry, caster);
    if (upload_positions(gpu, geometry, caster) && upload_attributes(gpu, geometry) &&
        buffer_init(&gpu->indices, "scene indices", geometry->index_count * sizeof(uint32_t),
                    geometry->indices) &&
        buffer_init(&gpu->caster_indices, "scene caster indices",
                    caster->index_count * sizeof(uint32_t), caster->indices) &&
        upload_materials(gpu, scene) && upload_textures(gpu, scene)) {
        make_vertex_arrays(gpu);
        return true;
    }
    scene_gpu_free(gpu);
    return false;
}

void scene_gpu_free(struct scene_gpu *gpu) {
    if (gpu->shaded_vertices)
        gl.DeleteVertexArrays(1, &gpu->shaded_vertices);
    if (gpu->caster_vertices)
        gl.DeleteVertexArrays(1, &gpu->caster_vertices);
    buffer_free(&gpu->positions);
    buffer_free(&gpu->normals);
    buffer_free(&gpu->uvs);
    buffer_free(&gpu->colors);
    buffer_free(&gpu->indices);
    buffer_free(&gpu->caster_indices);
    buffer_free(&gpu->materials);
    for (int i = 0; i < gpu->texture_count; i++)
        texture_free(&gpu->textures[i]);
    free(gpu->textures);
    free(gpu->batches);
    free(gpu->masked_casters);
    *gpu = (struct scene_gpu){0};
}

static void draw_indices(uint32_t first, uint32_t count, int instances) {
    gl.DrawElementsInstanced(GL_TRIANGLES, (GLsizei)count, GL_UNSIGNED_INT,
                             (const void *)(uintptr_t)(first * sizeof(uint32_t)), instances);
}

static void draw_batch(const struct scene_gpu *gpu, const struct geometry_batch *batch,
                       int instances) {
    int texture = gpu->scene->materials[batch->material].texture;
    gl.BindBufferRange(GL_UNIFORM_BUFFER, BLOCK_MATERIAL, gpu->materials.id,
                       (GLintptr)batch->material * MATERIAL_STRIDE, sizeof(struct material_block));
    if (texture >= 0)
        gl.BindTextureUnit(0, gpu->textures[texture].id);
    draw_indices(batch->first_index, batch->index_count, instances);
}

void scene_gpu_draw_shaded(const struct scene_gpu *gpu, int instances) {
    for (int i = 0; i < gpu->batch_count; i++)
        draw_batch(gpu, &gpu->batches[i], instances);
}

void scene_gpu_draw_masked(const struct scene_gpu *gpu, int instances) {
    for (int i = 0; i < gpu->batch_count; i++)
        if (gpu->scene->materials[gpu->batches[i].material].alpha_mask)
            draw_batch(gpu, &gpu->batches[i], instances);
}

void scene_gpu_draw_opaque_casters(const struct scene_gpu *gpu, int instances) {
    if (gpu->opaque_caster_indices)
        draw_indices(0, gpu->opaque_caster_indices, instances);
}

void scene_gpu_draw_masked_casters(const struct scene_gpu *gpu, int instances) {
    for (int i = 0; i < gpu->masked_caster_count; i++)
        draw_batch(gpu, &gpu->masked_casters[i], instances);
}
