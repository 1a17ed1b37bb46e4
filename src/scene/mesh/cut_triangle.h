/* A triangle of the geometry in parts, for rays: what its textures have varies within it.
 */
#ifndef SCENE_MESH_CUT_TRIANGLE_H
#define SCENE_MESH_CUT_TRIANGLE_H

#include "scene/mesh/bvh.h"
#include "scene/mesh/geometry.h"

struct cut_triangle {
    const struct scene *scene;
    const struct geometry *geometry;
    const struct material *material;
    const uint32_t *index; /* of its vertices: within geometry->indices */
    float decode[256];     /* texture_decode_table's */
};

/* Of its three corners the weights of the triangle's second and third corner. */
struct triangle_part {
    vec2s at[3];
};

struct triangle_parts {
    struct bvh_triangle *items; /* of the heap; its owner's */
    uint32_t count, room;
};

extern const struct triangle_part triangle_whole;

/* A place of the part, by the weights of its second and third corner. */
vec2s triangle_within(const struct triangle_part *part, float u, float v);

/* The base colour there; A is what an alpha mask compares. */
vec4s triangle_color(const struct cut_triangle *triangle, vec2s at);

void triangle_quarters(const struct triangle_part *part, struct triangle_part quarters[4]);

/* How often quarters are cut until a part has no more than so many texels of the base colour's texture; at most `most`
 * times. */
int triangle_depth(const struct cut_triangle *triangle, float texels, int most);

/* Appends the part, for the caller to fill in what it lets pass. */
struct bvh_triangle *triangle_parts_add(struct triangle_parts *parts,
                                        const struct cut_triangle *triangle,
                                        const struct triangle_part *part);

/* Appends the whole triangle. */
struct bvh_triangle *triangle_parts_add_whole(struct triangle_parts *parts,
                                              const struct geometry *geometry,
                                              const uint32_t *index);

#endif
