/* What a scene holds, as text or JSON: counts, materials' textures, lights, cameras, bounds. */
#ifndef APPS_SCENE_SUMMARY_H
#define APPS_SCENE_SUMMARY_H

#include "base/json.h"
#include "scene/choice.h"

/* Members of json, or text on stdout where json->out is NULL. Error: the scene cannot be loaded, or
 * nothing in it can be drawn. */
bool scene_summary_print(struct json *json, const char *path, const struct scene_choice *choice);

#endif
