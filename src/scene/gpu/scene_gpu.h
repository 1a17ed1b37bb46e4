/* The scene's copy on the GPU, and how it is drawn: batch by batch with the batch's material, or
 * for depth alone. Shadow casters are apart (scene/gpu/caster_gpu.h). */
#ifndef SCENE_GPU_SCENE_GPU_H
#define SCENE_GPU_SCENE_GPU_H

#include "gl/buffer.h"
#include "gl/texture.h"
#include "scene/gpu/caster_bvh.h"
#include "scene/gpu/culling.h"
#include "scene/lights/emitter.h"
#include "scene/mesh/geometry.h"

struct scene_gpu {
    struct buffer positions, normals, uvs[MAPPINGS_MAX], colors, indices, materials;
    struct texture *textures;
    int texture_count;
    float (*glow)[3]; /* of each material: what its block has */
    bool smooth_black;
    struct texture blank;               /* for what a material has not */
    struct texture lobes, lobe_albedos; /* scene/gpu/lobes.h, where materials are not all plain */
    struct texture slides;     /* RGBA16F, a layer each, in its upper left corner; or none */
    struct texture sky;        /* RGB32F, the texels of the scene's environment; or none */
    GLuint shaded_vertices;    /* vertex array of all but the last two */
    const struct scene *scene; /* must outlive this */
    struct geometry_batch *batches;
    int batch_count;
    bool has_masked; /* batches with an alpha mask */
    uint32_t opaque_indices;
    struct culling culling;
    struct caster_bvh panes;
    unsigned pose;             /* of the geometry, that was uploaded last */
    int16_t (*normal_room)[4]; /* for the conversion of a part's */
    uint32_t normal_room_size;
};

/* Uploads. Error: out of GPU memory. */
bool scene_gpu_init(struct scene_gpu *gpu, const struct scene *scene,
                    const struct geometry *geometry);

/* Uploads the parts of the geometry that have moved since the last upload; all, into new buffers,
 * where its arrays were laid out anew. Error: out of GPU memory; the copy must then be freed. */
bool scene_gpu_update(struct scene_gpu *gpu, const struct geometry *geometry);
void scene_gpu_free(struct scene_gpu *gpu);

/* Lets those materials glow, times scale, of which a lamp is among the emitters, and perhaps those that
 * are unlit. */
void scene_gpu_set_glow(struct scene_gpu *gpu, const struct emitters *emitters, bool unlit_too,
                        float scale);

/* Whether smooth materials (material_smooth_kind) scatter no light, and send it on as caustics alone. */
void scene_gpu_set_smooth_black(struct scene_gpu *gpu, bool black);

/* With vertex array shaded_vertices, what the views may see of: all batches; those with an alpha mask;
 * the others with one side or two; all others, for depth alone. The first two bind BLOCK_MATERIAL and
 * the textures. */
void scene_gpu_draw_shaded(const struct scene_gpu *gpu, const struct draw_views *views);
void scene_gpu_draw_masked(const struct scene_gpu *gpu, const struct draw_views *views);
void scene_gpu_draw_solid(const struct scene_gpu *gpu, bool double_sided,
                          const struct draw_views *views);
void scene_gpu_draw_opaque(const struct scene_gpu *gpu, const struct draw_views *views);

/* Binds BLOCK_MATERIAL and its textures, or a blank one: UNIT_BASE_COLOR, UNIT_EMISSION,
 * UNIT_METAL_ROUGHNESS, UNIT_NORMAL_MAP. */
void scene_gpu_bind_material(const struct scene_gpu *gpu, int material);

#endif
