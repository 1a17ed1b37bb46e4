/* Cloth and plants: open, thin, seen from both sides. */
#ifndef SCENES_FURNISHING_H
#define SCENES_FURNISHING_H

#include "scene/shapes/surface.h"

/* A curtain that hangs from y = 0 in the plane z = 0, gathered by a cord at `waist` of
 * its height. */
struct curtain {
    float width, height;
    float folds, depth;  /* how many, how deep in metres */
    float waist, gather; /* where it is bound, 0 at the top; how much of the width that takes */
    float phase;         /* makes the folds of each curtain its own */
    int columns, rows;
};
void add_curtain(struct surface *surface, const struct curtain *curtain);

/* A cloth over a rail along x at y = 0, which hangs down by `drop` on both sides. */
struct rail_cloth {
    float width, drop, rail_radius;
    float folds, depth, phase;
    int columns, rows;
};
void add_rail_cloth(struct surface *surface, const struct rail_cloth *cloth);

/* A tuft of long leaves that grow from the origin. */
struct plant {
    int leaves, segments;
    float height, spread, leaf_width;
    int seed;
};
void add_plant(struct surface *surface, const struct plant *plant);

#endif
