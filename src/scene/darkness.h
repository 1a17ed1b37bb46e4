/* Detects files whose lights leave the picture black, like a model with one faint LED. */
#ifndef SCENE_DARKNESS_H
#define SCENE_DARKNESS_H

#include "scene/mesh/geometry.h"

/* True if the first camera sees a dark picture at time 0. Only scenes with lights that are all
 * emissive surfaces, or without power, can be dark. Rays find visible places; light paths estimate
 * their radiance as if white. Dark: less than a quarter of the places have a 4096th of a picture's
 * white. Also dark: less than half have a 256th of the brightest 2 %, capped at white. The scene
 * must have a camera. */
bool scene_is_dark(const struct scene *scene, const struct geometry *geometry);

/* Logs that more than half of the first camera's view is smooth metal that mirrors empty space. For
 * scenes lit by scene/framing.h. */
void scene_note_mirrors(const struct scene *scene, const struct geometry *geometry);

#endif
