/* Emissive surfaces that become area lights: flat rectangles, and disks of eight corners or more.
 *
 * Blender and most others write lamps so, and no area light: a plane with an emissive material. The
 * front shines, and of a double-sided material the back too. Shapes that are neither, that deform,
 * or whose emission is a texture, stay dark and are named in a note.
 */
#ifndef SCENE_EMISSIVE_H
#define SCENE_EMISSIVE_H

#include "scene/scene.h"

/* So many at most, the most powerful: fewer than shine at once, as all views of lights have room. */
enum { EMISSIVE_LIGHTS_MAX = 32 };

/* Adds a node with a light below each node with such a surface, under its name. */
void emissive_add_lights(struct scene *scene);

/* A flat surface as an area light has it: the frame's third axis is its normal, size as struct
 * emitter's. */
struct flat_shape {
    float center[3], right[3], up[3], normal[3];
    float size[2];
};

/* Whether all triangles together are a rectangle or a disk. */
bool flat_shape_of(struct flat_shape *shape, const struct primitive *primitive);

#endif
