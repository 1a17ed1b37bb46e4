/* Layout of BVHs in buffer textures. */
#ifndef SHARED_BVH_H
#define SHARED_BVH_H

/* Layout of scene/mesh/stackless_bvh.h. */
#define STACKLESS_HEADER 2 /* texels */
#define STACKLESS_TRIANGLE 3
/* Bit of a box's last number: a leaf. Then follow the triangle count and their first texel. */
#define STACKLESS_LEAF 0x80000000u
#define STACKLESS_COUNT_SHIFT 27
#define STACKLESS_COUNT_MOST 15u
#define STACKLESS_STEPS 65535.0 /* of the bounds' sides */
#define OPACITY_SIDE 8          /* parts along an edge of a triangle, 64 in all */

/* Values of a triangle in the BVH of panes. */
#define PANE_COLOR_BITS 10
#define PANE_COLOR_MOST 1023
#define PANE_BOTH 0x40000000 /* bit beside the colour: backs reflect like fronts */

#endif
