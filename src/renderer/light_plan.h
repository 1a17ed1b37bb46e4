/* Plans the layouts for which maps and programs are made, by lights, environment and settings. */
#ifndef RENDERER_LIGHT_PLAN_H
#define RENDERER_LIGHT_PLAN_H

#include "renderer/renderer.h"

/* Returns a copy of the lights of `desc`, divided: where lights are many and rays can test
 * visibility, few lights have maps, and all others are sampled (passes/sampled_lights.h). */
struct emitters renderer_divide_lights(const struct renderer_desc *desc);

/* Uploads the sampled lights of `desc`. Error: out of GPU memory; renderer->sampled is unchanged.
 */
bool renderer_init_sampled(struct renderer *renderer, const struct renderer_desc *desc);

/* Moves emissive triangles among the sampled lights with the geometry. Error: that of
 * renderer_init_sampled. */
bool renderer_move_sampled(struct renderer *renderer);

/* Lights of a renderer while it follows a change. */
struct light_change {
    bool same;
    struct emitters old, fresh;
    struct sampled_lights sampled; /* old */
};

/* Divides the lights of `desc` and uploads sampled lights, unless all are the renderer's: then
 * `desc` has these. Error: that of renderer_init_sampled. */
bool renderer_begin_lights(struct light_change *change, struct renderer *renderer,
                           struct renderer_desc *desc);

/* Frees the old lights if the renderer `changed`, else the new ones. */
void renderer_end_lights(struct light_change *change, struct renderer *renderer, bool changed);

/* Fills `plan` for `desc`, whose lights are divided. It reuses the renderer's fit where nothing
 * changed. Error: too many lights. */
bool renderer_plan_lights(struct light_plan *plan, const struct renderer *renderer,
                          const struct renderer_desc *desc);

#endif
