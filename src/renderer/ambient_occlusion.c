/* Ambient occlusion of the last frame: nobody pays for it who does not ask. */
#include "renderer/views.h"

#include "base/memory.h"
#include "passes/frame.h"
#include "renderer/caustics.h"
#include "techniques/volume.h"

static struct ambient_occlusion_desc desc_of(const struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    return (struct ambient_occlusion_desc){.settings = &desc->settings,
                                           .scene = desc->scene,
                                           .geometry = renderer_geometry(renderer),
                                           .width = desc->width,
                                           .height = desc->height};
}

static bool check(const struct renderer *renderer) {
    struct ambient_occlusion_desc desc = desc_of(renderer);
    return ambient_occlusion_check(&desc);
}

static bool init(struct renderer *renderer) {
    struct ambient_occlusion_desc desc = desc_of(renderer);
    struct ambient_occlusion *made = mem_alloc(1, sizeof *made);
    if (ambient_occlusion_init(made, &desc)) {
        renderer->ambient_occlusion = made;
        renderer->occluded_frame = 0;
        return true;
    }
    free(made);
    return false;
}

const struct irradiance *renderer_ambient_occlusion(struct renderer *renderer) {
    struct timers untimed = {0};
    struct frame frame = renderer_frame(renderer);
    if (!renderer->ambient_occlusion && !init(renderer))
        return NULL;
    const struct irradiance *picture = &renderer->ambient_occlusion->light.reconstruct.irradiance;
    if (renderer->occluded_frame == renderer->frame_count)
        return picture;
    if (!volume_light_update(&renderer->ambient_occlusion->light, frame.geometry)) {
        renderer_forget_ambient_occlusion(renderer);
        return NULL;
    }
    frame.timers = &untimed;
    ambient_occlusion_render(renderer->ambient_occlusion, &frame, &renderer->gbuffer);
    renderer->occluded_frame = renderer->frame_count;
    return picture;
}

static const struct irradiance *draw(void *state, struct renderer *renderer,
                                     const struct frame *frame, const struct gbuffer *gbuffer) {
    (void)state, (void)frame, (void)gbuffer;
    return renderer_ambient_occlusion(renderer);
}

const struct drawn_output renderer_drawn_ao = {check, draw, NULL};

void renderer_forget_ambient_occlusion(struct renderer *renderer) {
    if (renderer->ambient_occlusion)
        ambient_occlusion_free(renderer->ambient_occlusion);
    free(renderer->ambient_occlusion);
    renderer->ambient_occlusion = NULL;
}
