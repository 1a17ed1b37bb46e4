/* View frustum culling: the index array in runs of triangles, each with a box, of which a draw leaves out those that none of
 * its views sees. Files list triangles of one thing after another, so that runs are compact as they are; half of what a
 * spot in a hall is asked to draw lies beside its cone. */
#ifndef SCENE_GPU_CULLING_H
#define SCENE_GPU_CULLING_H

#include "scene/mesh/geometry.h"
#include "shared/view.h"

struct culling {
    float (*boxes)[2][3]; /* least and greatest corner, world */
    uint32_t runs;
};

/* What a draw goes to, a view an instance. */
struct draw_views {
    int count;
    const struct view *first; /* NULL = all around: nothing is left out */
    size_t stride;            /* bytes from one to the next; 0 = all are one */
    float margin;             /* how far they see beside the picture, ndc */
};

void culling_init(struct culling *culling, const struct geometry *geometry);
void culling_free(struct culling *culling);

/* Measures the runs anew that have indices of the range. */
void culling_measure(const struct culling *culling, const struct geometry *geometry, uint32_t first,
                     uint32_t count);

/* The next indices from *at on, before end, that lie in runs that a view may see; *at is where to go on then. False:
 * there are none. */
bool culling_next(const struct culling *culling, const struct draw_views *views, uint32_t *at,
                  uint32_t end, uint32_t *first, uint32_t *count);

#endif
