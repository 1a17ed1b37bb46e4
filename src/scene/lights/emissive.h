/* Emissive surfaces as lights of the scene.
 *
 * Blender and most others write lamps so, and no area light: a plane with an emissive material. The
 * front shines, and of a double-sided material the back too. What is one rectangle or disk of one
 * colour is a light that is just so. Any other shape, or one with a texture, is stood in for by a few
 * rectangles (scene/lights/lamp_parts.h), and so are together the least powerful where there are many. What deforms
 * stays dark and is named in a note.
 *
 * A lamp is what shines as one: a surface, or those that share their stand-ins.
 */
#ifndef SCENE_LIGHTS_EMISSIVE_H
#define SCENE_LIGHTS_EMISSIVE_H

#include "scene/scene.h"

/* So many at most, of which these stand in for one surface at most, and for the least powerful
 * together: fewer than shine at once, as all views of lights have room. */
enum { EMISSIVE_LIGHTS_MAX = 32, STAND_INS_MAX = 6, STAND_INS_OF_REST = 8 };

/* Adds a node with a light below each node with such a surface, under its name; and fills
 * scene->surfaces. */
void emissive_add_lights(struct scene *scene);

#endif
