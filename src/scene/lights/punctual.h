/* How bright the lights of KHR_lights_punctual are beside surfaces that emit. Exporters of Blender write lamps in
 * lumens and emission in watts, so one of both is 683 times off; Blender 3 has no other way. */
#ifndef SCENE_LIGHTS_PUNCTUAL_H
#define SCENE_LIGHTS_PUNCTUAL_H

#include "scene/scene.h"

/* Multiplies the intensity of these lights, animated or not, by the file's extras and by scale; 0 is 1. A note
 * where neither is there and Blender 3 wrote both kinds of light. Error: scale is given, and there is no such light. */
bool punctual_follow(struct scene *scene, float scale);

#endif
