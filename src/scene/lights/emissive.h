/* Converts emissive surfaces to lights of the scene.
 *
 * Blender and most other tools export lamps as emissive planes, not as area lights. The front
 * emits, and with a double-sided material the back too. A rectangle or disk of one colour becomes
 * one area light. For other shapes, and textured ones, a few rectangles stand in
 * (scene/lights/lamp_parts.h), as for the least powerful surfaces together. They light frames whose
 * lights need maps; others take the triangles (scene/lights/emissive_triangles.h). Surfaces that
 * deform stay dark, and a note names them.
 *
 * Islands of a primitive (scene/lights/islands.h) are separate surfaces, because tools join panels.
 * A lamp is one surface, or several that share their rectangles. */
#ifndef SCENE_LIGHTS_EMISSIVE_H
#define SCENE_LIGHTS_EMISSIVE_H

#include "scene/lights/emitter.h"
#include "scene/mesh/geometry.h"

/* Most lights in all; most rectangles of one surface; most of the least powerful together. Fewer
 * than LIGHTS_MAX, because views of lights need room. */
enum { EMISSIVE_LIGHTS_MAX = 32, STAND_INS_MAX = 6, STAND_INS_OF_REST = 8 };

/* Adds a light node below each node with an emissive surface, under its name. It fills
 * scene->surfaces. */
void emissive_add_lights(struct scene *scene);

/* Triangles of a surface in the geometry: first, one past the last. Empty if the geometry does not
 * show its primitive. */
struct emissive_span {
    uint32_t first, end;
};
struct emissive_span emissive_find(const struct geometry *geometry,
                                   const struct emissive_surface *surface);

/* Returns the spans of all surfaces of the scene, faster than one by one. The caller frees them. */
struct emissive_span *emissive_find_all(const struct geometry *geometry, const struct scene *scene);

/* Returns the states of lamps by their number, as the emitters have them. The caller frees them. */
enum lamp_state { LAMP_IS_DARK, LAMP_HAS_LIGHTS, LAMP_STOOD_IN_FOR };
enum lamp_state *emissive_lamp_states(const struct scene *scene, const struct emitters *emitters);

#endif
