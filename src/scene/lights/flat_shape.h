/* Flat surfaces that form one rectangle or one disk. */
#ifndef SCENE_LIGHTS_FLAT_SHAPE_H
#define SCENE_LIGHTS_FLAT_SHAPE_H

#include "scene/scene.h"

/* Shape as of an area light: the normal is the frame's third axis; size as in struct emitter. */
struct flat_shape {
    float center[3], right[3], up[3], normal[3];
    float size[2];
};

/* True if the triangles form a rectangle, or a disk of eight or more corners. */
bool flat_shape_of(struct flat_shape *shape, const struct primitive *primitive);

#endif
