/* Estimates the brightness of a file's lights before rendering. */
#ifndef SCENE_LIGHTS_BRIGHTNESS_H
#define SCENE_LIGHTS_BRIGHTNESS_H

#include "scene/mesh/geometry.h"

/* Returns the binary logarithm of a white surface's radiance over a picture's white, unshadowed and
 * facing all lights. The surface is at the scene's centre, or a radius away from nearer lights.
 * -INFINITY: no lights. Environments do not count. */
float scene_brightness(const struct scene *scene, const struct geometry *geometry);

/* Logs a brightness outside a picture's range, for example a sun of 100,000 lux or a dim lamp, with
 * a matching exposure. */
void scene_note_brightness(const struct scene *scene, const struct geometry *geometry);

#endif
