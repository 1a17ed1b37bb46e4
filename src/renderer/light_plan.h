/* What maps and programs are made for: by the lights, the sky and the settings that are wanted. */
#ifndef RENDERER_LIGHT_PLAN_H
#define RENDERER_LIGHT_PLAN_H

#include "renderer/renderer.h"

/* Takes what the renderer has where that is as wanted. Error: more lights than there is room for. */
bool renderer_plan_lights(struct light_plan *plan, const struct renderer *renderer,
                          const struct renderer_desc *desc);

#endif
