/* Steps that make a primitive of scene/scene.h from the arrays of a file. */
#ifndef SCENE_MESH_PRIMITIVE_H
#define SCENE_MESH_PRIMITIVE_H

#include "scene/scene.h"

enum primitive_mode { PRIMITIVE_TRIANGLES = 4, PRIMITIVE_STRIP = 5, PRIMITIVE_FAN = 6 };

/* Refuses positions that are not finite and indices out of range. */
bool primitive_check(const struct primitive *primitive);

/* Turns the indices of a strip or fan into those of single triangles. Error: a count that makes no
 * whole triangle. */
bool primitive_unroll(struct primitive *primitive, enum primitive_mode mode);

/* Gives each triangle vertices of its own with the triangle's normal. */
void primitive_flatten(struct primitive *primitive, int target_count);

/* Sets the normals of three vertices each, as a flat primitive has them, to their triangle's. */
void primitive_flat_normals(float (*position)[3], float (*normal)[3], uint32_t vertex_count);

/* Scales the normals to unit length; one that has no direction becomes the mean of its faces'. */
void primitive_repair_normals(struct primitive *primitive);

/* Refuses joints' weights that are negative or not finite; scales their sums to 1. */
bool primitive_repair_weights(struct primitive *primitive);

void primitive_free(struct primitive *primitive, int target_count);

#endif
