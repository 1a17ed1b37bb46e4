/* A triangle of the geometry, cut into parts because its textures vary. For ray tracing. */
#ifndef SCENE_MESH_CUT_TRIANGLE_H
#define SCENE_MESH_CUT_TRIANGLE_H

#include "scene/mesh/bvh.h"
#include "scene/mesh/geometry.h"

struct cut_triangle {
    const struct scene *scene;
    const struct geometry *geometry;
    const struct material *material;
    const uint32_t *index; /* indices of its vertices, inside geometry->indices */
    float decode[256];     /* table of texture_decode_table */
};

/* Weights of the triangle's second and third corner, at the part's three corners. */
struct triangle_part {
    vec2s at[3];
};

struct triangle_parts {
    struct bvh_triangle *items; /* heap array, owned by the caller */
    uint32_t count, room;
};

extern const struct triangle_part triangle_whole;

/* Returns a point of the part, given by the weights of the part's second and third corner. */
vec2s triangle_within(const struct triangle_part *part, float u, float v);

/* Returns the base colour at the point; A is compared by alpha masks. */
vec4s triangle_color(const struct cut_triangle *triangle, vec2s at);

void triangle_quarters(const struct triangle_part *part, struct triangle_part quarters[4]);

/* Returns how often to cut into quarters, so that a part has at most `texels` texels of the base
 * colour's texture; at most `most`. */
int triangle_depth(const struct cut_triangle *triangle, float texels, int most);

/* Appends the part; the caller fills in its opacity. */
struct bvh_triangle *triangle_parts_add(struct triangle_parts *parts,
                                        const struct cut_triangle *triangle,
                                        const struct triangle_part *part);

/* Appends the whole triangle. */
struct bvh_triangle *triangle_parts_add_whole(struct triangle_parts *parts,
                                              const struct geometry *geometry,
                                              const uint32_t *index);

#endif
