/* Brightness of KHR_lights_punctual relative to emissive surfaces. Blender exports lamps in lumens
 * and emission in watts, a factor of 683; Blender 3 has no other option. */
#ifndef SCENE_LIGHTS_PUNCTUAL_H
#define SCENE_LIGHTS_PUNCTUAL_H

#include "scene/scene.h"

/* Multiplies the intensity of these lights, also animated, by the file's extras and by scale
 * (0 is 1). It logs a note without either factor if Blender 3 wrote both kinds of light. Error: a
 * scale without these lights. */
bool punctual_follow(struct scene *scene, float scale);

#endif
