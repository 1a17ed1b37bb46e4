/* Fewer triangles for the same shape: edge collapses by quadric error.
 *
 * [Garland and Heckbert 1997, "Surface Simplification Using Quadric Error Metrics"]: the edge whose
 * collapse moves the surface least goes first. The surface must be closed; it stays closed, keeps
 * its genus, and no triangle turns over.
 */
#ifndef SCENES_DECIMATE_H
#define SCENES_DECIMATE_H

#include "scene/shapes/surface.h"

/* Down to triangle_count, which must be even, or to where no edge may go any more. Vertices move,
 * so their normals are stale afterwards. */
void decimate(struct surface *surface, uint32_t triangle_count);

#endif
