/* The scene's triangles in world space at one time: what the GPU draws and Embree traces.
 *
 * Vertices of all meshes lie in one set of arrays and all triangles in one index array, so that a
 * pass can draw everything at once. Triangles are sorted into batches of one material; batches
 * without alpha mask come first, so that depth passes draw all of them as one. Panes come last:
 * light goes straight through them (scene/material.h).
 */
#ifndef SCENE_MESH_GEOMETRY_H
#define SCENE_MESH_GEOMETRY_H

#include "scene/pose.h"
#include "scene/scene.h"

/* Consecutive triangles of one material. */
struct geometry_batch {
    int material;
    uint32_t first_index, index_count;
    bool dynamic; /* other triangles with each pose; room that they leave is filled with points */
};

/* What one primitive of one node has in the arrays. */
struct geometry_part {
    int node, primitive;
    uint32_t first_vertex, vertex_count, first_index, index_count;
    uint32_t vertex_room, index_room; /* at least the counts; more for dynamic parts alone */
    bool dynamic;                     /* the surface of metaballs */
    bool rigid;                       /* neither dynamic nor skinned, morphed, scaled by a clip */
    bool mirrored;                    /* the winding of its triangles is swapped */
    unsigned moved, rewound;          /* the poses that last changed vertices, and indices */
    float bounds_min[3], bounds_max[3];
    float farthest; /* vertex from the geometry's centre, metres */
};

/* What poses throughout a clip take up; empty where nothing moves. */
struct geometry_span {
    int clip_choice; /* the scene's; -1 = none was looked at */
    float bounds_min[3], bounds_max[3], radius;
};

struct geometry {
    uint32_t vertex_count, index_count;
    float (*position)[3];         /* world; one spare element, as Embree reads 16 bytes a vertex */
    float (*normal)[3];           /* world, unit */
    float (*uv[MAPPINGS_MAX])[2]; /* of the mappings that there are */
    float (*color)[4];
    uint32_t *indices;
    struct geometry_batch *batches;
    int batch_count;
    int mapping_count;             /* from 1 on */
    uint32_t opaque_index_count;   /* indices of the batches without alpha mask: [0, this) */
    uint32_t blocking_index_count; /* of all but panes: [0, this) */
    int blocking_batch_count;
    bool glass_blocks; /* in a view of another: geometry_block_glass */

    /* Bounding box and sphere of the vertices that triangles use, throughout the clip that plays:
     * lengths that are fractions of the radius would breathe with a single pose's. */
    float bounds_min[3], bounds_max[3];
    float center[3], radius; /* radius > 0 */

    struct geometry_part *parts;
    int part_count;
    unsigned pose_count; /* poses so far; geometry_init is the first */
    unsigned laid_out;   /* the pose that last laid the arrays out anew */
    unsigned painted;    /* the pose that last did so or changed materials */
    bool broken;         /* the last pose failed */

    struct geometry_span span;
    bool still; /* the bounds are those of the pose alone */
    struct pose pose, next;
    struct geometry_balls *balls; /* geometry.c: of each of the scene's metaballs */
    int balls_count;
};

/* Lays out the arrays and fills them for the time. The clip is sampled for its bounds, here and when
 * a pose finds another one to play: every tenth of a second, or at 128 steps of a longer one. A pose
 * that reaches beyond all samples widens the bounds for itself. Error: a scene without a triangle. */
bool geometry_init(struct geometry *geometry, const struct scene *scene, double time);

/* The same with the bounds of each pose alone: for those who look at one. */
bool geometry_init_still(struct geometry *geometry, const struct scene *scene, double time);
void geometry_free(struct geometry *geometry);

/* Moves everything to where it is at a time, and gives the scene its materials of that time. What stays where it is costs nothing; part->moved and
 * part->rewound tell the others. The result depends on the time alone, whatever poses came before.
 * Error: something ends up too far away; the geometry must not be used until a pose succeeds. */
bool geometry_pose(struct geometry *geometry, struct scene *scene, double time);

/* Fills a view of a geometry, with the same arrays, in which glass (SMOOTH_GLASS) counts among what blocks light,
 * as caustics need it. The view owns nothing and is old after the next pose. */
void geometry_block_glass(struct geometry *view, const struct geometry *geometry,
                          const struct scene *scene);

/* How far above a surface a ray begins that is not to meet it: about a hundred times the rounding of the scene's
 * coordinates, metres. */
float geometry_clearance(const struct geometry *geometry);

/* Whether some triangle is a pane; and whether a part's are. */
static inline bool geometry_has_panes(const struct geometry *geometry) {
    return geometry->blocking_index_count < geometry->index_count;
}
static inline bool geometry_part_is_pane(const struct geometry *geometry,
                                         const struct geometry_part *part) {
    return part->first_index >= geometry->blocking_index_count;
}

/* Triangles in use. */
uint32_t geometry_triangle_count(const struct geometry *geometry);

#endif
