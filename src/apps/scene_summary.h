/* What a scene holds, in lines of text: counts, materials' textures, lights, cameras, bounds. */
#ifndef APPS_SCENE_SUMMARY_H
#define APPS_SCENE_SUMMARY_H

#include "scene/choice.h"

/* On stdout. Error: the scene cannot be loaded, or nothing in it can be drawn. */
bool scene_summary_print(const char *path, const struct scene_choice *choice);

#endif
