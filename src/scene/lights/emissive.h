/* Emissive surfaces as lights of the scene.
 *
 * Blender and most others write lamps so, and no area light: a plane with an emissive material. The
 * front shines, and of a double-sided material the back too. What is one rectangle or disk of one
 * colour is a light that is just so. Any other shape, or one with a texture, is stood in for by a few
 * rectangles (scene/lights/lamp_parts.h), and so are together the least powerful where there are many. What deforms
 * stays dark and is named in a note.
 *
 * Islands of a primitive (scene/lights/islands.h) are surfaces of their own: tools join panels. A lamp is
 * what shines as one: a surface, or those that share their stand-ins.
 */
#ifndef SCENE_LIGHTS_EMISSIVE_H
#define SCENE_LIGHTS_EMISSIVE_H

#include "scene/mesh/geometry.h"

/* So many at most, of which these stand in for one surface at most, and for the least powerful
 * together: fewer than shine at once, as all views of lights have room. */
enum { EMISSIVE_LIGHTS_MAX = 32, STAND_INS_MAX = 6, STAND_INS_OF_REST = 8 };

/* Adds a node with a light below each node with such a surface, under its name; and fills
 * scene->surfaces. */
void emissive_add_lights(struct scene *scene);

/* The triangles that a surface has in the geometry: the first, and the one after the last; none where the
 * geometry shows none of its primitive. */
struct emissive_span {
    uint32_t first, end;
};
struct emissive_span emissive_find(const struct geometry *geometry,
                                   const struct emissive_surface *surface);

#endif
