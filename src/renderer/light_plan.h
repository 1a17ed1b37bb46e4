/* Plans the layouts for which maps and programs are made, by lights, environment and settings. */
#ifndef RENDERER_LIGHT_PLAN_H
#define RENDERER_LIGHT_PLAN_H

#include "renderer/renderer.h"

/* Returns a copy of the lights of `desc`, divided: where lights are many and rays can test
 * visibility, few lights have maps, and all others are sampled (passes/sampled_lights.h). */
struct emitters renderer_divide_lights(const struct renderer_desc *desc);

/* Keeps the new lights if the renderer `changed`, else the old ones, and frees the others. sampled:
 * new sampled lights; NULL: as before. */
void renderer_keep_lights(struct renderer *renderer, struct emitters *old, struct emitters *fresh,
                          struct sampled_lights *sampled, bool changed);

/* Fills `plan` for `desc`, whose lights are divided. It reuses the renderer's fit where nothing
 * changed. Error: too many lights. */
bool renderer_plan_lights(struct light_plan *plan, const struct renderer *renderer,
                          const struct renderer_desc *desc);

#endif
