/* Builds primitives of scene/scene.h from the arrays of a file. */
#ifndef SCENE_MESH_PRIMITIVE_H
#define SCENE_MESH_PRIMITIVE_H

#include "scene/scene.h"

enum primitive_mode { PRIMITIVE_TRIANGLES = 4, PRIMITIVE_STRIP = 5, PRIMITIVE_FAN = 6 };

/* Error: a position that is not finite, or an index out of range. */
bool primitive_check(const struct primitive *primitive);

/* Converts a strip or fan to single triangles. Error: an index count that makes no whole
 * triangles. */
bool primitive_unroll(struct primitive *primitive, enum primitive_mode mode);

/* Gives each triangle its own vertices with the triangle's normal. */
void primitive_flatten(struct primitive *primitive, int target_count);

/* Sets the normals of each three vertices, of a flat primitive, to their triangle's. */
void primitive_flat_normals(float (*position)[3], float (*normal)[3], uint32_t vertex_count);

/* Normalises normals; one without direction becomes the mean of its faces' normals. */
void primitive_repair_normals(struct primitive *primitive);

/* Normalises joint weights to sum 1. Error: a weight that is negative or not finite. */
bool primitive_repair_weights(struct primitive *primitive);

/* Returns the diagonal of the bounding box of used vertices. */
float primitive_diagonal(const struct primitive *primitive);

void primitive_free(struct primitive *primitive, int target_count);

#endif
