/* Plans the layouts for which maps and programs are made, by lights, environment and settings. */
#ifndef RENDERER_LIGHT_PLAN_H
#define RENDERER_LIGHT_PLAN_H

#include "renderer/renderer.h"

/* Fills `plan` for `desc`. It reuses the renderer's fit where nothing changed. Error: too many
 * lights. */
bool renderer_plan_lights(struct light_plan *plan, const struct renderer *renderer,
                          const struct renderer_desc *desc);

#endif
