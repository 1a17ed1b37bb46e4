/* Levels of detail for views that need not show all triangles: light maps, and the antialiasing.
 *
 * Large scenes have several triangles a pixel, and drawing costs by the triangle. Each level
 * collapses edges of the level before (scene/mesh/simplify.h) within an error. A view chooses each
 * part's level by the size of its pixels there. Levels have the geometry's vertices, and keep
 * borders and seams, so that no crack opens and normals stay. A large part is cut into pieces of
 * consecutive triangles, each with its own level; vertices of several pieces stay. */
#ifndef SCENE_MESH_LEVELS_H
#define SCENE_MESH_LEVELS_H

#include "scene/mesh/geometry.h"

enum { LEVEL_COUNT = 3 };

/* A part with levels, or a piece of it: rigid, opaque, without textures and colours, of many
 * triangles. */
struct level_part {
    int part;                                        /* in the geometry */
    int piece;                                       /* of the pieces of its shape */
    uint32_t first_index, index_count;               /* of all its triangles, in the geometry */
    uint32_t first[LEVEL_COUNT], count[LEVEL_COUNT]; /* in struct levels; finest first */
    int32_t base;                                    /* to be added to these indices */
    float error[LEVEL_COUNT];                        /* metres; INFINITY: no such level */
    float box[2][3];                                 /* lower and upper corner, world, metres */
};

struct levels {
    struct level_part *parts; /* in the order of the geometry's indices */
    int part_count;
    uint32_t *indices; /* NULL after levels_free_indices */
    uint32_t index_count;
    struct level_shape *shapes; /* of each primitive (levels.c) */
    int shape_count;
    unsigned pose; /* of the geometry, when the boxes were measured */
};

/* Makes the levels of the geometry's current pose. */
void levels_init(struct levels *levels, const struct scene *scene, const struct geometry *geometry);

/* Follows the geometry's pose: the boxes. */
void levels_measure(struct levels *levels, const struct geometry *geometry);
void levels_free_indices(struct levels *levels);
void levels_free(struct levels *levels);

/* Returns for each vertex of the primitive the one it collapses onto in the coarsest level; NULL:
 * there is none of at most the error, in the primitive's space. */
const uint32_t *levels_moved(const struct levels *levels, const struct primitive *primitive,
                             float error);

#endif
