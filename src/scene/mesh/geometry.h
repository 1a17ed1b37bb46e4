/* The scene's triangles in world space at one time, for OpenGL and Embree.
 *
 * Vertices of all meshes share one set of arrays and all triangles one index array, so that a pass
 * can draw everything at once. Triangles are sorted into batches of one material. Batches without
 * alpha mask come first, so that depth passes draw them together. Panes come last: light passes
 * straight through them (scene/material.h). */
#ifndef SCENE_MESH_GEOMETRY_H
#define SCENE_MESH_GEOMETRY_H

#include "scene/pose.h"
#include "scene/scene.h"

/* Consecutive triangles of one material. */
struct geometry_batch {
    int material;
    uint32_t first_index, index_count;
    bool dynamic; /* triangles change with each pose; unused room holds degenerate ones */
};

/* Ranges of one primitive of one node in the arrays. */
struct geometry_part {
    int node, primitive;
    uint32_t first_vertex, vertex_count, first_index, index_count;
    uint32_t vertex_room, index_room; /* at least the counts; more only for dynamic parts */
    bool dynamic;                     /* surface of metaballs */
    bool rigid;                       /* neither dynamic, skinned, morphed nor scaled by a clip */
    bool mirrored;                    /* winding of its triangles is swapped */
    int twin;      /* first part of the same primitive and winding; itself if it is the first */
    bool has_twin; /* another part has the same `twin` */
    unsigned moved, rewound; /* pose of the last change of vertices; of indices */
    float bounds_min[3], bounds_max[3];
    float farthest; /* greatest distance of a vertex from the geometry's centre, metres */
};

/* Bounds of all poses of a clip; empty if nothing moves. */
struct geometry_span {
    int clip_choice; /* clip choice of the scene; -1: none */
    float bounds_min[3], bounds_max[3], radius;
};

struct geometry {
    uint32_t vertex_count, index_count;
    float (*position)[3]; /* world; one spare element, because Embree reads 16 bytes a vertex */
    float (*normal)[3];   /* world, unit */
    float (*uv[MAPPINGS_MAX])[2]; /* by mapping, mapping_count of them */
    bool has_uv[MAPPINGS_MAX];    /* false: all are zero, and the untouched pages take no memory */
    bool has_color;
    float (*color)[4]; /* NULL without has_color: all are white */
    uint32_t *indices;
    struct geometry_batch *batches;
    int batch_count;
    int mapping_count;             /* at least 1 */
    uint32_t opaque_index_count;   /* indices of batches without alpha mask: [0, this) */
    uint32_t blocking_index_count; /* indices of all triangles except panes: [0, this) */
    int blocking_batch_count;
    bool glass_blocks; /* in a view made by geometry_block_glass */

    /* Bounding box and sphere of used vertices over the whole playing clip. With bounds of a single
     * pose, lengths relative to the radius would vary over time. */
    float bounds_min[3], bounds_max[3];
    float center[3], radius; /* radius > 0 */

    struct geometry_part *parts;
    int part_count;
    unsigned pose_count; /* number of poses, including that of geometry_init */
    unsigned laid_out;   /* pose of the last layout of the arrays */
    unsigned painted;    /* pose of the last layout or change of materials */
    unsigned changed;    /* pose of the last geometry_follow with other triangles */
    bool broken;         /* the last pose failed */

    struct geometry_span span;
    bool still; /* bounds are those of the current pose */
    struct pose pose, next;
    struct geometry_balls *balls; /* data of each of the scene's metaballs (geometry.c) */
    int balls_count;
};

/* Lays out the arrays and fills them for the time, seconds. The clip is sampled for its bounds
 * every tenth of a second, or in 128 steps of a longer clip; again when another clip plays. A pose
 * beyond the samples widens the bounds for itself. Error: a scene without triangles. */
bool geometry_init(struct geometry *geometry, const struct scene *scene, double time);

/* Makes a geometry with the bounds of each pose alone, for users of single poses. */
bool geometry_init_still(struct geometry *geometry, const struct scene *scene, double time);
void geometry_free(struct geometry *geometry);

/* Moves everything, and the scene's materials, to a time, seconds. Static parts cost nothing;
 * part->moved and part->rewound mark the others. The result depends only on the time. Error: a
 * vertex is too far away; the geometry is unusable until a pose succeeds. */
bool geometry_pose(struct geometry *geometry, struct scene *scene, double time);

/* Counts on from the geometry before meshes, nodes or colours of the scene changed, and marks the
 * parts that differ. What is made of a pose's triangles is to be made anew after `changed`. */
void geometry_follow(struct geometry *geometry, const struct geometry *before);

/* Fills a view with the arrays of `geometry` in which glass (SMOOTH_GLASS) blocks light, as
 * caustics need it. The view owns nothing and is invalid after the next pose. */
void geometry_block_glass(struct geometry *view, const struct geometry *geometry,
                          const struct scene *scene);

/* Returns the primitive of a part. */
static inline const struct primitive *geometry_primitive(const struct scene *scene,
                                                         const struct geometry_part *part) {
    return &scene->meshes[scene->nodes[part->node].mesh].primitives[part->primitive];
}

/* Returns the offset of ray origins above surfaces, metres: about 100 times the rounding error of
 * coordinates. */
float geometry_clearance(const struct geometry *geometry);

/* True if some triangle is a pane; if a part's triangles are. */
static inline bool geometry_has_panes(const struct geometry *geometry) {
    return geometry->blocking_index_count < geometry->index_count;
}
static inline bool geometry_part_is_pane(const struct geometry *geometry,
                                         const struct geometry_part *part) {
    return part->first_index >= geometry->blocking_index_count;
}

/* Returns the colour of a vertex, linear RGBA. */
static inline const float *geometry_color(const struct geometry *geometry, uint32_t vertex) {
    static const float white[4] = {1, 1, 1, 1};
    return geometry->color ? geometry->color[vertex] : white;
}

/* Returns the number of triangles in use. */
uint32_t geometry_triangle_count(const struct geometry *geometry);

#endif
