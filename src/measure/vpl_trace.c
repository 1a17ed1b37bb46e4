#include "measure/vpl_trace.h"

#include "measure/lights.h"
#include "reference/vpl_sum.h"
#include "techniques/many_lights.h"

static bool show(void *user, double done) {
    if (user)
        progress_show(user, done, "");
    return true;
}

static enum vpl_sum_bound bound_of(const struct gather_settings *settings) {
    switch ((enum gather_clamp)settings->clamp) {
    case GATHER_CLAMP_NONE:
        return VPL_SUM_UNBOUNDED;
    case GATHER_CLAMP_VALUE:
        return VPL_SUM_CLAMPED;
    default:
        return VPL_SUM_DISK;
    }
}

bool vpl_trace(struct renderer *renderer, int width, int height, struct progress *progress,
               struct image *image) {
    const struct renderer_desc *desc = &renderer->desc;
    struct emitter emitter = desc->light;
    struct lights lights;
    *image = (struct image){0};
    if (!lights_read(&lights, renderer))
        return false;
    const struct gather_settings *gather = settings_of(&desc->settings, &gather_part);
    float radius = desc->geometry->radius;
    bool ok = vpl_sum_render(
        &(struct vpl_sum_desc){.scene = desc->scene,
                               .geometry = desc->geometry,
                               .camera = &desc->camera,
                               .emitters = {&emitter, 1},
                               .vpls = lights.vpls,
                               .vpl_count = lights.vpl_count,
                               .width = width,
                               .height = height,
                               .bound = bound_of(gather),
                               .clamp_value = gather->clamp_value / (radius * radius),
                               .progress = show,
                               .user = progress},
        image);
    lights_free(&lights);
    return ok;
}
