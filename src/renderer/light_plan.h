/* Plans the layouts for which maps and programs are made, by lights, environment and settings. */
#ifndef RENDERER_LIGHT_PLAN_H
#define RENDERER_LIGHT_PLAN_H

#include "renderer/renderer.h"

/* Fills `plan` for `desc`. Where rays can test visibility, it divides many lights: few have maps,
 * and all others are sampled, as triangles of emissive surfaces are (passes/sampled_lights.h). The
 * caller calls light_plan_free. It reuses the renderer's fit where nothing changed. Error: too many
 * lights; `plan` has none. */
bool renderer_plan_lights(struct light_plan *plan, const struct renderer *renderer,
                          const struct renderer_desc *desc);

/* Frees the lights of a plan. */
void light_plan_free(struct light_plan *plan);

/* Uploads the sampled lights of the plan. Error: out of GPU memory; renderer->sampled is
 * unchanged. */
bool renderer_init_sampled(struct renderer *renderer, const struct light_plan *plan);

/* Moves emissive triangles among the sampled lights with the geometry. Error: that of
 * renderer_init_sampled. */
bool renderer_move_sampled(struct renderer *renderer);

/* Lights of a renderer before a change. */
struct light_change {
    bool same;
    struct light_plan old; /* its lights alone */
    struct sampled_lights sampled;
};

/* Uploads the sampled lights of the plan, unless the renderer has the same. Error: that of
 * renderer_init_sampled; frees the lights of the plan. */
bool renderer_begin_lights(struct light_change *change, struct renderer *renderer,
                           struct light_plan *plan);

/* Frees the old lights if the renderer `changed`, else those of the plan. */
void renderer_end_lights(struct light_change *change, struct renderer *renderer,
                         struct light_plan *plan, bool changed);

#endif
