/* Shadow casters for paraboloid maps: few triangles, and those with long edges apart.
 *
 * A paraboloid map bends straight lines, but a rasteriser draws them straight, so that a large
 * triangle ends up in the wrong place. Long triangles therefore are drawn by a program that bends
 * their edges as each map does (paraboloid_long.geom), which for all would cost too much. Which are long is told by rank, not by a length: it depends neither on the scene's units nor
 * on a plain that surrounds a room.
 *
 * Of what is solid (solid.h) a map need not show the faces that are turned away: such triangles have lists of their own.
 *
 * Vertices are the geometry's own: when it moves, the triangles stay.
 */
#ifndef SCENE_MESH_CASTER_H
#define SCENE_MESH_CASTER_H

#include "scene/mesh/geometry.h"

/* Triangles in the order of the geometry's, in its batches. */
struct caster_list {
    uint32_t *indices;
    uint32_t index_count, opaque_index_count;
    struct geometry_batch *batches; /* as many as the geometry has; some may be empty */
};

/* Those of a solid cast from their fronts alone, seen from the open. */
enum caster_kind {
    CASTER_SHORT,
    CASTER_LONG,
    CASTER_SHORT_SOLID,
    CASTER_LONG_SOLID,
    CASTER_KIND_COUNT
};

struct caster {
    struct caster_list list[CASTER_KIND_COUNT];
    float error;     /* how far it may stray, metres */
    float long_edge; /* each long triangle has a longer one, and no other has, metres */
    uint32_t vertex_count;
    int batch_count;
};

/* The defaults of maps' casters, so that direct and indirect light share one set. */
#define CASTER_ERROR .00055
enum { CASTER_LONG_COUNT = 500 };

struct caster_desc {
    float error;    /* how far rigid opaque parts may stray (scene/mesh/simplify.h), over the root
                    of the area of all; 0 = not at all */
    int long_count; /* no more triangles are long: those with the longest edges. Of dynamic batches
                       none is. */
    const float *eye; /* a place in the open, in a scene where nothing moves; NULL: only metaballs
                         that may stray are taken for solid */
};

/* Simplifies the geometry as it is posed now, then sorts out what is long. */
void caster_init(struct caster *caster, const struct geometry *geometry,
                 const struct caster_desc *desc);
void caster_free(struct caster *caster);

/* Takes over the geometry's present triangles of a dynamic batch, into the list of the kind that it returns. */
enum caster_kind caster_take_batch(struct caster *caster, const struct geometry *geometry,
                                   int batch);

/* Follows a geometry whose arrays were laid out anew, with other room for dynamic batches. */
void caster_lay_out(struct caster *caster, const struct geometry *geometry);

#endif
