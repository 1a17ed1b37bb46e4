/* Trees of triangles. */
#ifndef SHARED_BVH_H
#define SHARED_BVH_H


/* scene/mesh/stackless_bvh.h to its shader. */
#define STACKLESS_HEADER 2 /* texels */
#define STACKLESS_TRIANGLE 3
/* A bit of a box's last number: the triangles' count follows, then their first texel. */
#define STACKLESS_LEAF 0x80000000u
#define STACKLESS_COUNT_SHIFT 27
#define STACKLESS_COUNT_MOST 15u
#define STACKLESS_STEPS 65535.0 /* of the bounds' sides */
#define OPACITY_SIDE 8 /* parts along an edge of a triangle: 64 bits of all */

/* What a pane's triangle has in the tree of panes. */
#define PANE_COLOR_BITS 10
#define PANE_COLOR_MOST 1023
#define PANE_BOTH 0x40000000 /* beside the colour: backs reflect as fronts do */

#endif
