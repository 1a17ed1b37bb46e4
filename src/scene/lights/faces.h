/* Splits emissive solids into their faces: a box that emits is six rectangles. */
#ifndef SCENE_LIGHTS_FACES_H
#define SCENE_LIGHTS_FACES_H

#include "scene/scene.h"

enum { FACES_MAX = 6 };

/* Sorts the triangles by face and writes the number of indices up to each face's end. Returns the
 * number of faces; 1, with the triangles as they were, if there are more than FACES_MAX or one is
 * neither a rectangle nor a disk. */
int faces_sort(struct primitive *primitive, int ends[FACES_MAX]);

#endif
