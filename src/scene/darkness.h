/* Whether the lights of a file leave the picture black: a model with a faint LED has a lamp, and nothing that
 * is seen gets its light. */
#ifndef SCENE_DARKNESS_H
#define SCENE_DARKNESS_H

#include "scene/mesh/geometry.h"

/* Asked of scenes whose lights are emissive surfaces alone, or have no power; false of others, and of
 * scenes without a light. A grid of rays finds what the first camera sees at time 0; paths of light through
 * the scene's triangles tell what radiance each place would have, were it white. Dark: less than a quarter of the
 * places have a 4096th of a picture's white, or less than half have a 256th of what the brightest 2 % have, at most
 * white. The scene has a camera. */
bool scene_is_dark(const struct scene *scene, const struct geometry *geometry);

/* Notes that more than half of what the first camera sees are smooth metals that mirror the emptiness around. Asked
 * of scenes whose lights are those of scene/framing.h. */
void scene_note_mirrors(const struct scene *scene, const struct geometry *geometry);

#endif
