/* scene/mesh/threaded_tree.h to its shader. */
#ifndef SHARED_TRIANGLE_TREE_H
#define SHARED_TRIANGLE_TREE_H

#define THREADED_HEADER 2 /* texels */
#define THREADED_TRIANGLE 3
/* A bit of a box's last number: the triangles' count follows, then their first texel. */
#define THREADED_LEAF 0x80000000u
#define THREADED_COUNT_SHIFT 27
#define THREADED_COUNT_MOST 15u
#define THREADED_STEPS 65535.0 /* of the bounds' sides */

#define OPACITY_SIDE 8 /* parts along an edge of a triangle: 64 bits of all */

#endif
