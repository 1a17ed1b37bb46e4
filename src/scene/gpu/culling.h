/* View frustum culling: runs of triangles in the index array, each with a bounding box. A draw
 * skips runs that no view sees. Files list the triangles of an object together, so runs are
 * compact. In a hall, half of the triangles are outside a spot's cone. */
#ifndef SCENE_GPU_CULLING_H
#define SCENE_GPU_CULLING_H

#include "gl/api.h"
#include "scene/mesh/geometry.h"
#include "shared/view.h"

struct culling {
    float (*boxes)[2][3]; /* lower and upper corner, world space, metres */
    uint32_t runs;
};

/* Views of a draw, one an instance. */
struct draw_views {
    int count;
    const struct view *first;
    size_t stride;      /* bytes between views; 0: all are equal */
    float margin;       /* visible margin around the picture, NDC */
    bool without_backs; /* backs of single-sided surfaces are not seen */
    float coarseness;   /* largest error of levels of detail, over half the picture's width */
    GLuint program;     /* gets LOCATION_FIRST_VIEW, the number of a draw's first view; 0: none */
    int first_view;     /* number of the first of all views */
};

/* Returns the draw of its view i alone. */
struct draw_views draw_views_only(const struct draw_views *views, int i);

void culling_init(struct culling *culling, const struct geometry *geometry);
void culling_free(struct culling *culling);

/* Recomputes the boxes of runs with indices in the range. */
void culling_measure(const struct culling *culling, const struct geometry *geometry, uint32_t first,
                     uint32_t count);

/* Finds the next run of indices from *at, before `end`, that some view may see. It moves *at past
 * the run. False: none. */
bool culling_next(const struct culling *culling, const struct draw_views *views, uint32_t *at,
                  uint32_t end, uint32_t *first, uint32_t *count);

/* Returns the coarsest level of detail for a box that no view shows the error of, from 1 on; 0: all
 * triangles; -1: no view sees the box. The errors, metres, rise; INFINITY: no such level. */
int culling_level(const struct draw_views *views, float (*box)[3], const float *errors, int count);

#endif
