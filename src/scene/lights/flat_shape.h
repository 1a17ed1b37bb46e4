/* Flat surfaces that are one rectangle, or one disk. */
#ifndef SCENE_LIGHTS_FLAT_SHAPE_H
#define SCENE_LIGHTS_FLAT_SHAPE_H

#include "scene/scene.h"

/* As an area light has it: the frame's third axis is its normal, size as struct emitter's. */
struct flat_shape {
    float center[3], right[3], up[3], normal[3];
    float size[2];
};

/* Whether all triangles together are a rectangle, or a disk of eight corners or more. */
bool flat_shape_of(struct flat_shape *shape, const struct primitive *primitive);

#endif
