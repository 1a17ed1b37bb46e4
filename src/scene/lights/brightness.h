/* How bright the lights of a file are, before anything is rendered. */
#ifndef SCENE_LIGHTS_BRIGHTNESS_H
#define SCENE_LIGHTS_BRIGHTNESS_H

#include "scene/mesh/geometry.h"

/* How many times, as a power of two, brighter than a picture's white a white surface is that all lights
 * of the scene face unhindered; its middle, or a radius from lights that are nearer. -INFINITY: no
 * lights. Skies do not count. */
float scene_brightness(const struct scene *scene, const struct geometry *geometry);

/* A note where that is more than a picture can show: files give a sun 100,000 lux. */
void scene_note_brightness(const struct scene *scene, const struct geometry *geometry);

#endif
