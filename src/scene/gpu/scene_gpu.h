/* The scene's copy on the GPU, and how it is drawn.
 *
 * Shaded draws go batch by batch with the batch's material; casters are drawn for depth alone, all
 * opaque ones at once, from triangles whose edges are short enough for a paraboloid map.
 */
#ifndef SCENE_GPU_SCENE_GPU_H
#define SCENE_GPU_SCENE_GPU_H

#include "gl/buffer.h"
#include "gl/texture.h"
#include "scene/mesh/caster.h"
#include "scene/mesh/geometry.h"

struct scene_gpu {
    struct buffer positions, normals, uvs, colors, indices, caster_indices, materials;
    struct texture *textures;
    int texture_count;
    GLuint shaded_vertices;    /* vertex arrays: position 0, normal 1, uv 2, color 3 */
    GLuint caster_vertices;    /* position 0, uv 2 */
    const struct scene *scene; /* must outlive this */
    struct geometry_batch *batches, *masked_casters;
    int batch_count, masked_caster_count;
    uint32_t opaque_indices, opaque_caster_indices;
    uint32_t vertex_count;
    unsigned pose;             /* of the geometry, that was uploaded last */
    float (*extra)[3];         /* the casters' extra positions */
    int16_t (*normal_room)[4]; /* for the conversion of a part's */
    uint32_t normal_room_size;
};

/* Uploads. Error: out of GPU memory. */
bool scene_gpu_init(struct scene_gpu *gpu, const struct scene *scene,
                    const struct geometry *geometry, const struct caster *caster);

/* Uploads the parts of the geometry that have moved since the last upload; all, into new buffers,
 * where its arrays were laid out anew, which the caster follows. Error: out of GPU
 * memory; the copy must then be freed. */
bool scene_gpu_update(struct scene_gpu *gpu, const struct geometry *geometry,
                      struct caster *caster);
void scene_gpu_free(struct scene_gpu *gpu);

/* With vertex array shaded_vertices: all batches; those with an alpha mask; the others with one
 * side or two; all others at once, for depth alone. The first two bind BLOCK_MATERIAL and texture
 * unit 0. */
void scene_gpu_draw_shaded(const struct scene_gpu *gpu, int instances);
void scene_gpu_draw_masked(const struct scene_gpu *gpu, int instances);
void scene_gpu_draw_solid(const struct scene_gpu *gpu, bool double_sided, int instances);
void scene_gpu_draw_opaque(const struct scene_gpu *gpu, int instances);

/* With vertex array caster_vertices; the masked ones bind as shaded ones do. */
void scene_gpu_draw_opaque_casters(const struct scene_gpu *gpu, int instances);
void scene_gpu_draw_masked_casters(const struct scene_gpu *gpu, int instances);

#endif
