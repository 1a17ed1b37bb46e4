/* Shapes as nodes of a file, of one material each. */
#ifndef SCENES_PLACING_H
#define SCENES_PLACING_H

#include "glb.h"

/* Adds the surface and frees it. */
void place_surface(struct glb *glb, const char *name, int material, struct surface *surface);

/* Those of shapes/shapes.h. */
void place_quad(struct glb *glb, const char *name, int material, const float corners[4][3]);
void place_box(struct glb *glb, const char *name, int material, const float low[3],
               const float high[3]);

#endif
