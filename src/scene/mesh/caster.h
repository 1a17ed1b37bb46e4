/* Shadow casters for paraboloid maps: few triangles, and with short edges.
 *
 * A paraboloid map bends straight lines, but a rasteriser draws them straight, so that a large
 * triangle ends up in the wrong place. Here every edge longer than a bound is split at its middle,
 * repeatedly. The decision looks at the edge's two ends alone: triangles that share an edge split
 * it alike, even where they do not share its vertices, and no crack opens.
 *
 * The result is a template: it tells of which two vertices each extra one is the midpoint. When the
 * geometry moves, only the extra positions are filled anew; the triangles stay.
 */
#ifndef SCENE_MESH_CASTER_H
#define SCENE_MESH_CASTER_H

#include "scene/mesh/geometry.h"

struct caster {
    float max_edge; /* the bound that is kept: what was asked for, or more where the limit bites */

    /* Vertices: the geometry's, then the extra ones. */
    uint32_t base_count, extra_count;
    uint32_t (*midpoint_of)[2]; /* extra vertex i lies amid these two, which come before it */
    struct caster_part {        /* the extra vertices of each of the geometry's parts */
        uint32_t first_extra, extra_count;
    } * parts;

    /* Triangles in the order of the geometry's, in its batches. */
    uint32_t *indices;
    uint32_t index_count, opaque_index_count;
    struct geometry_batch *batches;
    int batch_count;
};

/* Beside those that the geometry has, no more triangles than this are made. */
enum { CASTER_MAX_EXTRA_TRIANGLES = 2000000 };

/* Lengths over the geometry's radius. */
struct caster_desc {
    float max_edge; /* > 0 */
    float error; /* how far rigid opaque parts may stray (scene/mesh/simplify.h); 0 = not at all */
};

/* Simplifies and splits the geometry as it is posed now, but for its dynamic batches, until no edge
 * is longer than max_edge, or than the least multiple of it by a power of two that keeps the limit.
 */
void caster_init(struct caster *caster, const struct geometry *geometry,
                 const struct caster_desc *desc);
void caster_free(struct caster *caster);

/* Fills the extra_count extra positions and texture coordinates (unless NULL) from the geometry,
 * which may have moved since caster_init. */
void caster_fill(const struct caster *caster, const struct geometry *geometry, float (*position)[3],
                 float (*uv)[2]);

/* The positions of one part's alone, in the array of all extra positions. */
void caster_fill_part(const struct caster *caster, const struct geometry *geometry, int part,
                      float (*position)[3]);

/* Takes over the geometry's present triangles of a dynamic batch. The caster has the batches of the
 * geometry. */
void caster_take_batch(struct caster *caster, const struct geometry *geometry, int batch);

/* Follows a geometry whose arrays were laid out anew: the splits stay as they are. */
void caster_lay_out(struct caster *caster, const struct geometry *geometry);

#endif
