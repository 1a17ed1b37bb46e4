/* The scene's GPU copy and its drawing: batch by batch with materials, or for depth alone. Shadow
 * casters are separate (scene/gpu/caster_gpu.h). */
#ifndef SCENE_GPU_SCENE_GPU_H
#define SCENE_GPU_SCENE_GPU_H

#include "gl/buffer.h"
#include "gl/texture.h"
#include "scene/gpu/caster_bvh.h"
#include "scene/gpu/culling.h"
#include "scene/gpu/repeats.h"
#include "scene/lights/emitter.h"
#include "scene/mesh/geometry.h"
#include "scene/mesh/levels.h"

struct scene_gpu {
    struct buffer positions, normals, uvs[MAPPINGS_MAX], colors, indices, materials;
    struct texture *textures;
    int texture_count;
    float (*glow)[3];                   /* emission of each material, as in its block */
    bool smooth_black;                  /* smooth materials scatter no light */
    struct texture blank;               /* for textures that a material lacks */
    struct texture lobes, lobe_albedos; /* scene/gpu/lobes.h, if some material is not plain */
    struct texture slides;     /* RGBA16F, one layer each, in its upper left corner; or none */
    struct texture sky;        /* RGB32F, texels of the scene's environment; or none */
    GLuint shaded_vertices;    /* vertex array: positions, normals, uvs, colours */
    GLuint caster_vertices;    /* vertex array: positions, first uvs, for casters */
    const struct scene *scene; /* must outlive the copy */
    struct geometry_batch *batches;
    int batch_count;
    bool has_masked; /* batches with an alpha mask exist */
    uint32_t opaque_indices;
    struct culling culling;
    struct levels *levels; /* NULL: none; their indices follow all others in `indices` */
    uint32_t first_level_index;
    struct repeats repeats; /* which of the geometry's indices `indices` lacks */
    struct caster_bvh panes;
    unsigned pose;             /* pose of the geometry at the last upload */
    int16_t (*normal_room)[4]; /* conversion buffer of a part's normals */
    uint32_t normal_room_size;
};

/* Uploads, and frees the indices of the levels, which must outlive the copy. Error: out of GPU
 * memory. */
bool scene_gpu_init(struct scene_gpu *gpu, const struct scene *scene,
                    const struct geometry *geometry, struct levels *levels);

/* Uploads parts of the geometry that moved since the last upload. If its arrays were laid out
 * again, it uploads all into new buffers, without levels. Error: out of GPU memory; the caller must
 * then free the copy. */
bool scene_gpu_update(struct scene_gpu *gpu, const struct geometry *geometry);
void scene_gpu_free(struct scene_gpu *gpu);

/* Sets the emission of materials with a lamp among the emitters, and with unlit_too of unlit ones,
 * times `scale`. Other materials do not emit. */
void scene_gpu_set_glow(struct scene_gpu *gpu, const struct emitters *emitters, bool unlit_too,
                        float scale);

/* black: smooth materials (material_smooth_kind) scatter no light, because caustics carry it. */
void scene_gpu_set_smooth_black(struct scene_gpu *gpu, bool black);

/* Draw the batches that the views may see, in levels of detail, with shaded_vertices bound. In
 * order: all; masked; unmasked with one side or two; all unmasked, for depth alone. The first two
 * bind BLOCK_MATERIAL and the textures. */
void scene_gpu_draw_shaded(const struct scene_gpu *gpu, const struct draw_views *views);
void scene_gpu_draw_masked(const struct scene_gpu *gpu, const struct draw_views *views);
void scene_gpu_draw_solid(const struct scene_gpu *gpu, bool double_sided,
                          const struct draw_views *views);
void scene_gpu_draw_opaque(const struct scene_gpu *gpu, const struct draw_views *views);

/* Draws all batches that the views may see by a program that numbers triangles: it sets its uniform
 * LOCATION_FIRST_TRIANGLE to the first triangle of each draw. */
void scene_gpu_draw_numbered(const struct scene_gpu *gpu, const struct draw_views *views,
                             GLuint program);

/* Binds BLOCK_MATERIAL and the material's textures, or a blank one: UNIT_BASE_COLOR, UNIT_EMISSION,
 * UNIT_METAL_ROUGHNESS, UNIT_NORMAL_MAP. */
void scene_gpu_bind_material(const struct scene_gpu *gpu, int material);

#endif
