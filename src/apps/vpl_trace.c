#include "apps/vpl_trace.h"

#include "base/memory.h"
#include "passes/gather.h"
#include "reference/vpl_sum.h"

#include <stdlib.h>

static bool show(void *user, double done) {
    if (user)
        progress_show(user, done, "");
    return true;
}

static enum vpl_sum_bound bound_of(const struct settings *settings) {
    switch (settings->clamp) {
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
    struct technique_outputs outputs;
    renderer_outputs(renderer, &outputs);
    int count = outputs.vpls->count;
    struct vpl *vpls = mem_alloc((size_t)count, sizeof *vpls);
    buffer_read(&outputs.vpls->buffer, 0, (size_t)count * sizeof *vpls, vpls);
    float radius = desc->geometry->radius;
    bool ok = vpl_sum_render(
        &(struct vpl_sum_desc){.scene = desc->scene,
                               .geometry = desc->geometry,
                               .camera = &desc->camera,
                               .light = &desc->light,
                               .vpls = vpls,
                               .vpl_count = count,
                               .width = width,
                               .height = height,
                               .bound = bound_of(&desc->settings),
                               .clamp_value = desc->settings.clamp_value / (radius * radius),
                               .progress = show,
                               .user = progress},
        image);
    free(vpls);
    return ok;
}
