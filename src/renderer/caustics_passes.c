/* The passes of caustics and glass. No other file names them. */
#include "renderer/caustics.h"

#include "base/memory.h"
#include "passes/caustics/caustics.h"
#include "passes/caustics/glass.h"
#include "passes/frame.h"
#include "shared/composite.h"

struct caustics_passes {
    struct caustics_pass caustics;
    struct glass_pass glass;
};

static bool init_glass(struct caustics_passes *passes, const struct renderer *renderer, bool medium,
                       int chains) {
    const struct renderer_desc *desc = &renderer->desc;
    const struct material_settings *surface =
        settings_of(struct material_settings, &desc->settings, &material_part);
    return glass_pass_init(&passes->glass,
                           &(struct glass_desc){.width = desc->width,
                                                .height = desc->height,
                                                .chains = chains,
                                                .materials = (enum materials)surface->materials,
                                                .medium = medium,
                                                .sky = desc->scene->environment != NULL,
                                                .scene = desc->scene,
                                                .geometry = renderer_geometry(renderer)});
}

static bool init_caustics(struct caustics_passes *passes, const struct renderer *renderer,
                          bool medium, const struct caustics_settings *own) {
    const struct renderer_desc *desc = &renderer->desc;
    return caustics_pass_init(
        &passes->caustics,
        &(struct caustics_desc){.width = desc->width,
                                .height = desc->height,
                                .size = own->size,
                                .chains = own->chains,
                                .surface = own->surface != CAUSTICS_OFF,
                                .points = own->surface == CAUSTICS_POINTS,
                                .volume = own->volume != VOLUME_CAUSTICS_OFF,
                                .published = own->volume == VOLUME_CAUSTICS_PAPER,
                                .step = own->step,
                                .kernel = own->kernel,
                                .medium = medium,
                                .scene = desc->scene,
                                .geometry = renderer_geometry(renderer),
                                .casters = renderer->casters});
}

void renderer_free_caustics(struct renderer *renderer) {
    struct caustics_passes *passes = renderer->caustics.passes;
    if (passes) {
        caustics_pass_free(&passes->caustics);
        glass_pass_free(&passes->glass);
    }
    free(passes);
    renderer->caustics = (struct caustics_part){0};
}

bool renderer_init_caustics(struct renderer *renderer, bool medium) {
    struct caustics_passes *passes = mem_alloc(1, sizeof *passes);
    const struct caustics_pass *made = &passes->caustics;
    const struct caustics_settings *own =
        settings_of(struct caustics_settings, &renderer->desc.settings, &caustics_part);
    renderer->caustics.passes = passes;
    if (!init_glass(passes, renderer, medium, own->chains) ||
        !init_caustics(passes, renderer, medium, own))
        return false;
    renderer->caustics.surface = made->surface.id ? &made->surface : NULL;
    renderer->caustics.volume = made->volume.id ? &made->volume : NULL;
    return true;
}

bool renderer_resize_caustics(struct renderer *renderer, int width, int height) {
    struct caustics_passes *passes = renderer->caustics.passes;
    if (!passes)
        return true;
    int old_width = passes->glass.desc.width, old_height = passes->glass.desc.height;
    if (!glass_pass_resize(&passes->glass, width, height))
        return false;
    if (caustics_pass_resize(&passes->caustics, width, height))
        return true;
    glass_pass_resize(&passes->glass, old_width, old_height);
    return false;
}

/* What glass shows of the picture is there before the glass is. */
void renderer_render_caustics(struct renderer *renderer, const struct frame *frame) {
    struct caustics_passes *passes = renderer->caustics.passes;
    if (!passes)
        return;
    struct caustics_pass *caustics = &passes->caustics;
    struct timers untimed = {0};
    struct frame quiet = *frame;
    quiet.timers = &untimed;
    caustics_pass_render(caustics, frame, &renderer->gbuffer);
    struct composite_inputs inputs = renderer_composite_inputs(renderer);
    composite_pass_render_layer(&renderer->composite, &quiet, &inputs, LAYER_SENT,
                                passes->glass.screen_framebuffer);
    glass_pass_render(&passes->glass, frame, &renderer->gbuffer,
                      &(struct glass_inputs){.surfaces = &caustics->surfaces,
                                             .tree = caustics->tree,
                                             .sky = renderer->desc.emitters.sky,
                                             .framebuffer = caustics->surface_framebuffer});
}
