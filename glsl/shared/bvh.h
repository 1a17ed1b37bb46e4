/* scene/mesh/stackless_bvh.h to its shader. */
#ifndef SHARED_BVH_H
#define SHARED_BVH_H

#define STACKLESS_HEADER 2 /* texels */
#define STACKLESS_TRIANGLE 3
/* A bit of a box's last number: the triangles' count follows, then their first texel. */
#define STACKLESS_LEAF 0x80000000u
#define STACKLESS_COUNT_SHIFT 27
#define STACKLESS_COUNT_MOST 15u
#define STACKLESS_STEPS 65535.0 /* of the bounds' sides */

#define OPACITY_SIDE 8 /* parts along an edge of a triangle: 64 bits of all */

#endif
