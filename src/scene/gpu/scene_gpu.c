#include "scene/gpu/scene_gpu.h"

#include "base/log.h"
#include "base/memory.h"
#include "gl/pass.h"
#include "gl/vertex_array.h"
#include "scene/gpu/hole_colors.h"
#include "scene/gpu/lobes.h"
#include "scene/lights/environment.h"
#include "scene/material.h"
#include "scene/texture.h"
#include "shared/bindings.h"
#include "shared/material.h"

#include <cglm/cglm.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

enum { MATERIAL_STRIDE = 256 }; /* no driver asks for a larger uniform offset alignment */

static const GLuint uv_attributes[MAPPINGS_MAX] = {ATTRIBUTE_UV, ATTRIBUTE_UV_1, ATTRIBUTE_UV_2,
                                                   ATTRIBUTE_UV_3};

static void convert_normals(float (*from)[3], size_t count, int16_t (*to)[4]) {
    for (size_t i = 0; i < count; i++)
        for (int c = 0; c < 3; c++)
            to[i][c] = (int16_t)lrintf(from[i][c] * 32767);
}

/* One element for all vertices, where they are alike: its attribute has no stride. */
static uint16_t (*convert_colors(const struct geometry *geometry, size_t count))[4] {
    uint16_t(*colors)[4] = mem_alloc(count, sizeof *colors);
    for (size_t i = 0; i < count; i++)
        for (int c = 0; c < 4; c++)
            colors[i][c] = (uint16_t)lrintf(
                fminf(fmaxf(geometry_color(geometry, (uint32_t)i)[c], 0), 1) * 65535);
    return colors;
}

/* Normals as 16-bit signed, colours as 16-bit unsigned fractions, four each. */
static bool upload_attributes(struct scene_gpu *gpu, const struct geometry *geometry) {
    size_t count = geometry->vertex_count, color_count = geometry->color ? count : 1;
    int16_t(*normals)[4] = mem_alloc(count, sizeof *normals);
    convert_normals(geometry->normal, count, normals);
    bool ok = buffer_init_texels(&gpu->normals, GL_RGBA16I, "scene normals",
                                 count * sizeof *normals, normals);
    free(normals);
    uint16_t(*colors)[4] = convert_colors(geometry, color_count);
    ok = ok && buffer_init(&gpu->colors, "scene colours", color_count * sizeof *colors, colors);
    free(colors);
    return ok;
}

/* Of glass that is not opaque a camera sees the inner side. */
static bool has_two_sides(const struct material *material, bool smooth_black) {
    return material->double_sided ||
           (smooth_black && material_smooth_kind(material) == SMOOTH_GLASS);
}

/* Glass and mirrors whose light caustics carry reflect none of their own. */
static struct material_block block_of(const struct material *material, bool smooth_black) {
    bool black = smooth_black && material_smooth_kind(material) != SMOOTH_NONE;
    struct material_block block = {
        .alpha_cutoff = material->alpha_mask ? material->alpha_cutoff - ALPHA_SLACK : -1,
        .double_sided = has_two_sides(material, smooth_black),
        .textured = material->base_color_texture >= 0,
        .emission_textured = material->emission_texture >= 0,
        .metalness = material->metalness,
        .roughness = material->roughness,
        .diffuse = black || material_is_diffuse(material),
        .unlit = material->unlit,
        .metal_roughness_textured = material->metal_roughness_texture >= 0,
        .specular_f90 = material->specular_f90,
        .normal_textured = material->normal_texture >= 0,
        .normal_scale = material->normal_scale,
        .specular_glossiness = material->specular_glossiness,
        .metal_roughness_mapping = material->metal_roughness_mapping,
        .emission_mapping = material->emission_mapping,
        .normal_mapping = material->normal_mapping,
    };
    memcpy(block.base_color, material->base_color, sizeof block.base_color);
    memcpy(block.specular_f0, material->specular_f0, sizeof block.specular_f0);
    for (int c = 0; black && c < 3; c++)
        block.base_color[c] = 0;
    return block;
}

static bool upload_materials(struct scene_gpu *gpu, const struct scene *scene) {
    size_t size = (size_t)scene->material_count * MATERIAL_STRIDE;
    unsigned char *bytes = mem_alloc(size, 1);
    for (int i = 0; i < scene->material_count; i++) {
        struct material_block block = block_of(&scene->materials[i], gpu->smooth_black);
        memcpy(bytes + i * MATERIAL_STRIDE, &block, sizeof block);
    }
    bool ok = buffer_init(&gpu->materials, "scene materials", size, bytes);
    gpu->glow = mem_alloc((size_t)scene->material_count, sizeof *gpu->glow);
    free(bytes);
    return ok;
}

/* Texels of less alpha are never seen: 0 where any material shows all of the texture. */
static float cutoff_of(const struct scene *scene, int texture) {
    float least = INFINITY;
    for (int i = 0; i < scene->material_count; i++) {
        const struct material *material = &scene->materials[i];
        if (material->emission_texture == texture || material->normal_texture == texture ||
            material->metal_roughness_texture == texture)
            return 0;
        if (material->base_color_texture == texture)
            least = fminf(least, material->alpha_mask ? material->alpha_cutoff : 0);
    }
    return least < INFINITY ? least : 0;
}

/* llvmpipe decodes sRGB by a polynomial that errs by up to 2.5 % in dark colours: there texels are
 * decoded here. */
static GLenum format_of(const struct scene_texture *source) {
    if (source->linear)
        return GL_RGBA8;
    return gl.software ? GL_RGBA16F : GL_SRGB8_ALPHA8;
}

static void write_decoded(const struct texture *texture, const unsigned char *texels) {
    float srgb_to_linear[256];
    int width = texture->desc.width;
    vec4 *row = mem_alloc((size_t)width, sizeof *row);
    texture_decode_table(srgb_to_linear);
    for (int y = 0; y < texture->desc.height; y++) {
        for (int x = 0; x < width; x++, texels += 4) {
            for (int c = 0; c < 3; c++)
                row[x][c] = srgb_to_linear[texels[c]];
            row[x][3] = (float)texels[3] / 255;
        }
        gl.TextureSubImage2D(texture->id, 0, 0, y, width, 1, GL_RGBA, GL_FLOAT, row);
    }
    free(row);
}

static bool upload_texture(struct texture *texture, const struct scene_texture *source,
                           float cutoff) {
    static const GLenum wraps[] = {GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT};
    const struct bitmap *bitmap = &source->bitmap;
    int levels = source->nearest ? 1 : texture_full_levels(bitmap->width, bitmap->height);
    if (!texture_init(texture, &(struct texture_desc){
                                   .label = "scene textures",
                                   .format = format_of(source),
                                   .width = bitmap->width,
                                   .height = bitmap->height,
                                   .levels = levels,
                                   .filter = source->nearest ? FILTER_NEAREST : FILTER_TRILINEAR,
                                   .wrap_s = wraps[source->wrap_u],
                                   .wrap_t = wraps[source->wrap_v],
                               }))
        return false;
    unsigned char *filled = levels > 1 && cutoff > 0 ? hole_colors_fill(bitmap, cutoff) : NULL;
    const unsigned char *texels = filled ? filled : bitmap->rgba;
    if (texture->desc.format == GL_RGBA16F)
        write_decoded(texture, texels);
    else
        gl.TextureSubImage2D(texture->id, 0, 0, 0, bitmap->width, bitmap->height, GL_RGBA,
                             GL_UNSIGNED_BYTE, texels);
    free(filled);
    if (levels > 1)
        gl.GenerateTextureMipmap(texture->id);
    return true;
}

/* Samplers of textures that a material has not must have some. */
static bool make_blank(struct scene_gpu *gpu) {
    static const unsigned char white[4] = {255, 255, 255, 255};
    if (!texture_init(&gpu->blank, &(struct texture_desc){
                                       .label = "no texture", .format = GL_RGBA8, .width = 1}))
        return false;
    gl.TextureSubImage2D(gpu->blank.id, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, white);
    return true;
}

/* Uploads a copy with half the sides, and so on, until a GPU has room. */
static bool upload_smaller(struct texture *texture, const struct scene_texture *source,
                           float cutoff, int *side) {
    const struct bitmap *bitmap = &source->bitmap;
    struct scene_texture copy = *source;
    bool ok = false;
    int most = bitmap->width > bitmap->height ? bitmap->width : bitmap->height;
    copy.bitmap.rgba = mem_copy(bitmap->rgba, (size_t)bitmap->width * (size_t)bitmap->height, 4);
    while (!ok && most > 1) {
        most = (most + 1) / 2;
        texture_shrink(&copy, most);
        ok = upload_texture(texture, &copy, cutoff);
    }
    bitmap_free(&copy.bitmap);
    *side = most < *side ? most : *side;
    return ok;
}

static bool upload_textures(struct scene_gpu *gpu, const struct scene *scene) {
    int side = TEXTURE_SIDE_MAX;
    gpu->textures = mem_alloc((size_t)scene->texture_count, sizeof *gpu->textures);
    gpu->texture_count = scene->texture_count;
    for (int i = 0; i < scene->texture_count; i++) {
        float cutoff = cutoff_of(scene, i);
        if (!upload_texture(&gpu->textures[i], &scene->textures[i], cutoff) &&
            !upload_smaller(&gpu->textures[i], &scene->textures[i], cutoff, &side))
            return false;
    }
    if (side < TEXTURE_SIDE_MAX)
        log_note("textures are scaled down, some to %d texels a side: GPU memory is short", side);
    return true;
}

static bool upload_sky(struct scene_gpu *gpu, const struct environment *sky) {
    if (!sky)
        return true;
    if (!texture_init(&gpu->sky, &(struct texture_desc){.label = "sky",
                                                        .format = GL_RGB32F,
                                                        .width = sky->width,
                                                        .height = sky->height}))
        return false;
    gl.TextureSubImage2D(gpu->sky.id, 0, 0, 0, sky->width, sky->height, GL_RGB, GL_FLOAT,
                         sky->texels);
    return true;
}

static bool upload_uvs(struct scene_gpu *gpu, const struct geometry *geometry) {
    bool ok = true;
    for (int m = 0; ok && m < geometry->mapping_count; m++)
        ok = buffer_init(&gpu->uvs[m], "scene uvs",
                         (geometry->has_uv[m] ? geometry->vertex_count : 1) *
                             sizeof *geometry->uv[m],
                         geometry->uv[m]);
    return ok;
}

static GLuint make_positions_array(const struct scene_gpu *gpu, const struct geometry *geometry,
                                   int mappings) {
    GLuint vertices;
    gl.CreateVertexArrays(1, &vertices);
    vertex_array_attribute(vertices, ATTRIBUTE_POSITION,
                           &(struct vertex_attribute){&gpu->positions, 3, GL_FLOAT, 12, 0});
    for (int m = 0; m < mappings; m++)
        if (gpu->uvs[m].id)
            vertex_array_attribute(vertices, uv_attributes[m],
                                   &(struct vertex_attribute){&gpu->uvs[m], 2, GL_FLOAT,
                                                              geometry->has_uv[m] ? 8 : 0, 0});
    return vertices;
}

static void make_vertex_arrays(struct scene_gpu *gpu, const struct geometry *geometry) {
    gpu->caster_vertices = make_positions_array(gpu, geometry, 1);
    gpu->shaded_vertices = make_positions_array(gpu, geometry, MAPPINGS_MAX);
    vertex_array_attribute(gpu->shaded_vertices, ATTRIBUTE_NORMAL,
                           &(struct vertex_attribute){&gpu->normals, 3, GL_SHORT, 8, 0});
    vertex_array_attribute(
        gpu->shaded_vertices, ATTRIBUTE_COLOR,
        &(struct vertex_attribute){&gpu->colors, 4, GL_UNSIGNED_SHORT, geometry->color ? 8 : 0, 0});
    gl.VertexArrayElementBuffer(gpu->shaded_vertices, gpu->indices.id);
}

static void copy_batches(struct scene_gpu *gpu, const struct geometry *geometry) {
    gpu->batch_count = geometry->blocking_batch_count;
    gpu->batches = mem_copy(geometry->batches, (size_t)geometry->batch_count, sizeof *gpu->batches);
    gpu->opaque_indices = geometry->opaque_index_count;
    gpu->has_masked = geometry->opaque_index_count < geometry->blocking_index_count;
}

/* Indices of all triangles, without repeats, and then of the levels' triangles. */
static bool upload_indices(struct scene_gpu *gpu, const struct geometry *geometry,
                           struct levels *levels) {
    gpu->levels = levels;
    repeats_init(&gpu->repeats, geometry);
    gpu->first_level_index = geometry->index_count - repeats_missing(&gpu->repeats);
    size_t size = sizeof *geometry->indices, all = gpu->first_level_index * size;
    size_t more = levels ? levels->index_count * size : 0;
    if (!buffer_init(&gpu->indices, "scene indices", all + more, NULL))
        return false;
    repeats_write(&gpu->repeats, geometry, 0, geometry->index_count, &gpu->indices);
    if (more)
        buffer_write(&gpu->indices, all, more, levels->indices);
    return true;
}

static bool init_geometry(struct scene_gpu *gpu, const struct geometry *geometry,
                          struct levels *levels) {
    size_t count = geometry->vertex_count;
    gpu->pose = geometry->pose_count;
    copy_batches(gpu, geometry);
    if (!buffer_init_texels(&gpu->positions, GL_RGB32F, "scene positions",
                            count * sizeof *geometry->position, geometry->position) ||
        !upload_uvs(gpu, geometry) || !upload_attributes(gpu, geometry) ||
        !upload_indices(gpu, geometry, levels))
        return false;
    if (!caster_bvh_update(&gpu->panes, gpu->scene, geometry))
        return false;
    make_vertex_arrays(gpu, geometry);
    culling_init(&gpu->culling, geometry);
    return true;
}

static void free_geometry(struct scene_gpu *gpu) {
    vertex_array_free(&gpu->shaded_vertices);
    vertex_array_free(&gpu->caster_vertices);
    buffers_free(&gpu->positions, &gpu->normals);
    for (int m = 0; m < MAPPINGS_MAX; m++)
        buffer_free(&gpu->uvs[m]);
    buffers_free(&gpu->colors, &gpu->indices);
    culling_free(&gpu->culling);
    repeats_free(&gpu->repeats);
    free(gpu->batches);
    gpu->batches = NULL;
}

/* Texels as the file has them, so that the path tracer has the same. */
static bool upload_slides(struct scene_gpu *gpu, const struct scene *scene) {
    struct texture_desc desc = {.label = "slides",
                                .target = GL_TEXTURE_2D_ARRAY,
                                .format = GL_RGBA16F,
                                .layers = scene->slide_count};
    for (int i = 0; i < scene->slide_count; i++) {
        desc.width = scene->slides[i].width > desc.width ? scene->slides[i].width : desc.width;
        desc.height = scene->slides[i].height > desc.height ? scene->slides[i].height : desc.height;
    }
    if (scene->slide_count == 0)
        return true;
    if (!texture_init(&gpu->slides, &desc))
        return false;
    for (int i = 0; i < scene->slide_count; i++)
        gl.TextureSubImage3D(gpu->slides.id, 0, 0, 0, i, scene->slides[i].width,
                             scene->slides[i].height, 1, GL_RGBA, GL_FLOAT,
                             scene->slides[i].texels);
    return true;
}

bool scene_gpu_init(struct scene_gpu *gpu, const struct scene *scene,
                    const struct geometry *geometry, struct levels *levels) {
    *gpu = (struct scene_gpu){.scene = scene, .panes.of_panes = true};
    bool laid = init_geometry(gpu, geometry, levels);
    levels_free_indices(levels);
    if (laid && upload_materials(gpu, scene) && make_blank(gpu) && upload_textures(gpu, scene) &&
        upload_sky(gpu, scene->environment) && upload_slides(gpu, scene) &&
        (materials_are_plain(scene) ||
         (lobes_init(&gpu->lobes) && lobe_albedos_init(&gpu->lobe_albedos))))
        return true;
    scene_gpu_free(gpu);
    return false;
}

void scene_gpu_free(struct scene_gpu *gpu) {
    free_geometry(gpu);
    caster_bvh_free(&gpu->panes);
    buffer_free(&gpu->materials);
    for (int i = 0; i < gpu->texture_count; i++)
        texture_free(&gpu->textures[i]);
    mem_free(gpu->textures, gpu->glow);
    textures_free(&gpu->blank, &gpu->sky, &gpu->slides, &gpu->lobes, &gpu->lobe_albedos);
    free(gpu->normal_room);
    *gpu = (struct scene_gpu){0};
}

/* --- what has moved --------------------------------------------------------------------------- */

static void update_vertices(struct scene_gpu *gpu, const struct geometry_part *part,
                            const struct geometry *geometry) {
    uint32_t first = part->first_vertex, count = part->vertex_count;
    if (count > gpu->normal_room_size) {
        gpu->normal_room_size = part->vertex_room;
        gpu->normal_room =
            mem_resize(gpu->normal_room, gpu->normal_room_size, sizeof *gpu->normal_room);
    }
    convert_normals(geometry->normal + first, count, gpu->normal_room);
    buffer_write(&gpu->positions, first * sizeof *geometry->position,
                 count * sizeof *geometry->position, geometry->position + first);
    buffer_write(&gpu->normals, first * sizeof *gpu->normal_room, count * sizeof *gpu->normal_room,
                 gpu->normal_room);
}

/* All but their glow. */
static void write_materials(const struct scene_gpu *gpu) {
    for (int m = 0; m < gpu->scene->material_count; m++) {
        struct material_block block = block_of(&gpu->scene->materials[m], gpu->smooth_black);
        memcpy(block.emission, gpu->glow[m], sizeof block.emission);
        buffer_write(&gpu->materials, (size_t)m * MATERIAL_STRIDE, sizeof block, &block);
    }
}

bool scene_gpu_update(struct scene_gpu *gpu, const struct geometry *geometry) {
    unsigned seen = gpu->pose;
    if (geometry->painted > seen)
        write_materials(gpu);
    if (geometry->laid_out > seen) {
        free_geometry(gpu);
        return init_geometry(gpu, geometry, NULL);
    }
    gpu->pose = geometry->pose_count;
    for (int i = 0; i < geometry->part_count; i++) {
        const struct geometry_part *part = &geometry->parts[i];
        if (part->moved > seen)
            update_vertices(gpu, part, geometry);
        if (part->rewound > seen)
            repeats_write(&gpu->repeats, geometry, part->first_index, part->index_room,
                          &gpu->indices);
        if (part->moved > seen)
            culling_measure(&gpu->culling, geometry, part->first_index, part->index_room);
    }
    if (gpu->levels)
        levels_measure(gpu->levels, geometry);
    return caster_bvh_update(&gpu->panes, gpu->scene, geometry);
}

/* --- what shines ------------------------------------------------------------------------------ */

static bool is_lit(const struct scene *scene, int material, const struct emitters *emitters) {
    for (int s = 0; s < scene->surface_count; s++) {
        const struct emissive_surface *surface = &scene->surfaces[s];
        const struct mesh *mesh = &scene->meshes[scene->nodes[surface->node].mesh];
        for (int i = 0; i < emitters->count; i++)
            if (mesh->primitives[surface->primitive].material == material &&
                emitters->items[i].lamp == surface->lamp)
                return true;
    }
    return false;
}

void scene_gpu_set_glow(struct scene_gpu *gpu, const struct emitters *emitters, bool unlit_too,
                        float scale) {
    const float most = 6e4F; /* that half floats hold: a lamp's radiance may be without bounds */
    for (int m = 0; m < gpu->scene->material_count; m++) {
        static const float one[3] = {1, 1, 1};
        bool unlit = unlit_too && gpu->scene->materials[m].unlit;
        const float *emission = unlit ? one : gpu->scene->materials[m].emission;
        float glow[3] = {0};
        bool lit =
            glm_vec3_max((float *)emission) > 0 && (unlit || is_lit(gpu->scene, m, emitters));
        for (int c = 0; c < 3 && lit; c++)
            glow[c] = fminf(scale * emission[c], most);
        if (memcmp(glow, gpu->glow[m], sizeof glow) == 0)
            continue;
        memcpy(gpu->glow[m], glow, sizeof glow);
        buffer_write(&gpu->materials,
                     (size_t)m * MATERIAL_STRIDE + offsetof(struct material_block, emission),
                     sizeof glow, glow);
    }
}

void scene_gpu_set_smooth_black(struct scene_gpu *gpu, bool black) {
    if (black == gpu->smooth_black)
        return;
    gpu->smooth_black = black;
    write_materials(gpu);
}

/* --- drawing ---------------------------------------------------------------------------------- */

/* llvmpipe keeps triangles in memory until they are drawn: so many at most. */
enum { PENDING_MOST = 3 << 18 };

struct drawing {
    const struct draw_views *views;
    GLuint numbered;  /* program that gets the number of each draw's first triangle; 0: none */
    uint64_t pending; /* indices since the last end of drawing */
};

/* triangle: number of the first one. */
static void draw_elements(const struct stored *drawn, uint32_t triangle, struct drawing *drawing) {
    uint32_t most = gl.software ? PENDING_MOST : UINT32_MAX;
    int views = drawing->views->count;
    for (uint32_t at = 0, next; at < drawn->count; at += next) {
        next = drawn->count - at < most ? drawn->count - at : most;
        if (drawing->numbered)
            gl.ProgramUniform1i(drawing->numbered, LOCATION_FIRST_TRIANGLE,
                                (GLint)(triangle + at / 3));
        gl.DrawElementsInstancedBaseVertex(
            GL_TRIANGLES, (GLsizei)next, GL_UNSIGNED_INT,
            (const void *)((drawn->first + (size_t)at) * sizeof(uint32_t)), views, drawn->base);
        drawing->pending += (uint64_t)next * (uint64_t)views;
        if (drawing->pending > most) {
            gl.Finish();
            drawing->pending = 0;
        }
    }
}

static void draw_runs(const struct scene_gpu *gpu, uint32_t first, uint32_t count,
                      struct drawing *drawing) {
    uint32_t at = first, end = first + count;
    while (culling_next(&gpu->culling, drawing->views, &at, end, &first, &count)) {
        struct stored stored;
        for (uint32_t next = first; next < at; next += stored.count) {
            stored = repeats_next(&gpu->repeats, next, at);
            draw_elements(&stored, next / 3, drawing);
        }
    }
}

/* All triangles of what the views have close by, and of each other part its level. */
static void draw_together(const struct scene_gpu *gpu, uint32_t first, uint32_t count,
                          const struct draw_views *views) {
    uint32_t end = first + count;
    struct drawing drawing = {.views = views};
    for (int i = 0; gpu->levels && i < gpu->levels->part_count; i++) {
        struct level_part *part = &gpu->levels->parts[i];
        if (part->first_index >= end)
            break;
        if (part->first_index < first)
            continue;
        int level = culling_level(views, part->box, part->error, LEVEL_COUNT);
        if (level == 0)
            continue;
        draw_runs(gpu, first, part->first_index - first, &drawing);
        if (level > 0)
            draw_elements(&(struct stored){gpu->first_level_index + part->first[level - 1],
                                           part->count[level - 1], part->base},
                          0, &drawing);
        first = part->first_index + part->index_count;
    }
    draw_runs(gpu, first, end - first, &drawing);
}

/* Least indices of a batch whose views draw separately, each with its own culling and levels.
 * Smaller batches draw all views at once. */
enum { APART = 3 << 10 };

static void draw_indices(const struct scene_gpu *gpu, uint32_t first, uint32_t count,
                         const struct draw_views *views) {
    int draws = views->program && count >= APART ? views->count : 1;
    for (int i = 0; i < draws; i++) {
        struct draw_views drawn = draws > 1 ? draw_views_only(views, i) : *views;
        if (drawn.program)
            gl.ProgramUniform1i(drawn.program, LOCATION_FIRST_VIEW, drawn.first_view);
        draw_together(gpu, first, count, &drawn);
    }
}

void scene_gpu_bind_material(const struct scene_gpu *gpu, int material) {
    const struct material *own = &gpu->scene->materials[material];
    const struct {
        GLuint unit;
        int texture;
    } textures[] = {{UNIT_BASE_COLOR, own->base_color_texture},
                    {UNIT_EMISSION, own->emission_texture},
                    {UNIT_METAL_ROUGHNESS, own->metal_roughness_texture},
                    {UNIT_NORMAL_MAP, own->normal_texture}};
    pass_bind_block(&(struct pass_block){
        .block = BLOCK_MATERIAL,
        .buffer = &gpu->materials,
        .offset = (size_t)material * MATERIAL_STRIDE,
        .size = sizeof(struct material_block),
    });
    for (size_t i = 0; i < sizeof textures / sizeof *textures; i++)
        pass_bind_texture(textures[i].unit, textures[i].texture >= 0
                                                ? gpu->textures[textures[i].texture].id
                                                : gpu->blank.id);
}

static void draw_batch(const struct scene_gpu *gpu, const struct geometry_batch *batch,
                       const struct draw_views *views) {
    const struct material *material = &gpu->scene->materials[batch->material];
    scene_gpu_bind_material(gpu, batch->material);
    if (views->without_backs)
        pass_set_cull(has_two_sides(material, gpu->smooth_black) ? PASS_CULL_NONE : PASS_CULL_BACK);
    draw_indices(gpu, batch->first_index, batch->index_count, views);
}

void scene_gpu_draw_shaded(const struct scene_gpu *gpu, const struct draw_views *views) {
    for (int i = 0; i < gpu->batch_count; i++)
        draw_batch(gpu, &gpu->batches[i], views);
}

void scene_gpu_draw_numbered(const struct scene_gpu *gpu, const struct draw_views *views,
                             GLuint program) {
    struct drawing drawing = {.views = views, .numbered = program};
    for (int i = 0; i < gpu->batch_count; i++) {
        const struct geometry_batch *batch = &gpu->batches[i];
        scene_gpu_bind_material(gpu, batch->material);
        draw_runs(gpu, batch->first_index, batch->index_count, &drawing);
    }
}

void scene_gpu_draw_masked(const struct scene_gpu *gpu, const struct draw_views *views) {
    for (int i = 0; i < gpu->batch_count; i++)
        if (gpu->batches[i].first_index >= gpu->opaque_indices)
            draw_batch(gpu, &gpu->batches[i], views);
}

void scene_gpu_draw_solid(const struct scene_gpu *gpu, bool double_sided,
                          const struct draw_views *views) {
    for (int i = 0; i < gpu->batch_count; i++) {
        const struct geometry_batch *batch = &gpu->batches[i];
        const struct material *material = &gpu->scene->materials[batch->material];
        if (!material->alpha_mask && has_two_sides(material, gpu->smooth_black) == double_sided)
            draw_indices(gpu, batch->first_index, batch->index_count, views);
    }
}

void scene_gpu_draw_opaque(const struct scene_gpu *gpu, const struct draw_views *views) {
    draw_indices(gpu, 0, gpu->opaque_indices, views);
}
