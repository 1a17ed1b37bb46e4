/* Prints the contents of a scene as text or JSON: counts, textures of materials, lights,
 * cameras, bounds. */
#ifndef APPS_SCENE_SUMMARY_H
#define APPS_SCENE_SUMMARY_H

#include "base/json.h"
#include "scene/choice.h"

/* Writes members of json, or text on stdout if json->out is NULL. Error: the scene cannot be
 * loaded, or has nothing to draw. */
bool scene_summary_print(struct json *json, const char *path, const struct scene_choice *choice);

#endif
