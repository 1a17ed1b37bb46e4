/* Shadow casters for paraboloid maps: simplified triangles, with long ones in separate lists.
 *
 * A paraboloid map bends straight lines, but a rasteriser draws them straight, so large triangles
 * would be misplaced. A costly shader bends the edges of long triangles as each map does
 * (paraboloid_long.geom). Long triangles are chosen by rank, not by length, so neither units nor a
 * ground plane matter.
 *
 * Maps may skip back faces of solids (solid.h), which have lists of their own. Vertices are those
 * of the geometry, so motion keeps the triangles. */
#ifndef SCENE_MESH_CASTER_H
#define SCENE_MESH_CASTER_H

#include "scene/mesh/geometry.h"

/* Triangles in the order of the geometry and its batches. */
struct caster_list {
    uint32_t *indices;
    uint32_t index_count, opaque_index_count;
    struct geometry_batch *batches; /* as many as in the geometry; some may be empty */
};

/* Triangles of solids cast only from their fronts, for views from the open. */
enum caster_kind {
    CASTER_SHORT,
    CASTER_LONG,
    CASTER_SHORT_SOLID,
    CASTER_LONG_SOLID,
    CASTER_KIND_COUNT
};

struct caster {
    struct caster_list list[CASTER_KIND_COUNT];
    float error;     /* bound of the simplification error, metres */
    float long_edge; /* all long triangles have an edge longer than this, metres; no others do */
    uint32_t vertex_count;
    int batch_count;
};

/* Default error and number of long triangles of maps. Direct and indirect light share one
 * caster. */
#define CASTER_ERROR .00055
enum { CASTER_LONG_COUNT = 500 };

struct caster_desc {
    /* Simplification error of rigid opaque parts (scene/mesh/simplify.h), over the root of the
     * total area. 0: exact. */
    float error;
    /* Most long triangles: those with the longest edges; dynamic batches have none. */
    int long_count;
    /* A point in the open of a static scene. NULL: only metaballs that may stray count as solid. */
    const float *eye;
    const struct scene *scene;   /* scene whose instances share triangles; NULL: none share */
    const struct levels *levels; /* levels of detail to start from; NULL: none */
};

/* Simplifies the geometry in its current pose, then separates long triangles. */
void caster_init(struct caster *caster, const struct geometry *geometry,
                 const struct caster_desc *desc);
void caster_free(struct caster *caster);

/* Copies the current triangles of a dynamic batch into the list of the returned kind. */
enum caster_kind caster_take_batch(struct caster *caster, const struct geometry *geometry,
                                   int batch);

/* Follows a geometry whose arrays were laid out again, with other room for dynamic batches. */
void caster_lay_out(struct caster *caster, const struct geometry *geometry);

#endif
