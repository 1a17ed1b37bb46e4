#include "renderer/caustics.h"

#include "base/memory.h"
#include "passes/frame.h"
#include "shared/composite.h"

bool renderer_has_caustics(const struct renderer_desc *desc) {
    return caustics_shown(desc->scene, &desc->settings);
}

void renderer_view_geometry(struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    if (!renderer_has_caustics(desc))
        return;
    if (!renderer->glass_view)
        renderer->glass_view = mem_alloc(1, sizeof *renderer->glass_view);
    geometry_block_glass(renderer->glass_view, desc->geometry, desc->scene);
}

const struct geometry *renderer_geometry(const struct renderer *renderer) {
    return renderer->glass_view ? renderer->glass_view : renderer->desc.geometry;
}

static struct caustics_settings shown(const struct renderer_desc *desc) {
    struct caustics_settings none = {0};
    return renderer_has_caustics(desc)
               ? *settings_of(struct caustics_settings, &desc->settings, &caustics_part)
               : none;
}

unsigned renderer_caustic_kinds(const struct renderer_desc *desc, bool medium) {
    return (renderer_has_caustics(desc) ? HAS_CAUSTICS : 0U) |
           (shown(desc).volume && medium ? HAS_VOLUME_CAUSTICS : 0U);
}

static bool init_glass(struct renderer *renderer, bool medium, int chains) {
    const struct renderer_desc *desc = &renderer->desc;
    const struct material_settings *surface =
        settings_of(struct material_settings, &desc->settings, &material_part);
    return glass_pass_init(&renderer->glass,
                           &(struct glass_desc){.width = desc->width,
                                                .height = desc->height,
                                                .chains = chains,
                                                .materials = (enum materials)surface->materials,
                                                .medium = medium,
                                                .sky = desc->scene->environment != NULL,
                                                .scene = desc->scene,
                                                .geometry = renderer_geometry(renderer)});
}

bool renderer_init_caustics(struct renderer *renderer, bool medium) {
    const struct renderer_desc *desc = &renderer->desc;
    struct caustics_settings own = shown(desc);
    return !renderer_has_caustics(desc) ||
           (init_glass(renderer, medium, own.chains) &&
            caustics_pass_init(
                &renderer->caustics,
                &(struct caustics_desc){.width = desc->width,
                                        .height = desc->height,
                                        .size = own.size,
                                        .chains = own.chains,
                                        .surface = own.surface != CAUSTICS_OFF,
                                        .points = own.surface == CAUSTICS_POINTS,
                                        .volume = own.volume != VOLUME_CAUSTICS_OFF,
                                        .published = own.volume == VOLUME_CAUSTICS_PAPER,
                                        .step = own.step,
                                        .kernel = own.kernel,
                                        .medium = medium,
                                        .scene = desc->scene,
                                        .geometry = renderer_geometry(renderer),
                                        .casters = renderer->casters}));
}

bool renderer_resize_caustics(struct renderer *renderer, int width, int height) {
    const struct glass_desc *old = &renderer->glass.desc;
    int old_width = old->width, old_height = old->height;
    if (!renderer->caustics.tree)
        return true;
    if (!glass_pass_resize(&renderer->glass, width, height))
        return false;
    if (caustics_pass_resize(&renderer->caustics, width, height))
        return true;
    glass_pass_resize(&renderer->glass, old_width, old_height);
    return false;
}

/* What glass shows of the picture is there before the glass is. */
void renderer_render_caustics(struct renderer *renderer, const struct frame *frame) {
    struct caustics_pass *caustics = &renderer->caustics;
    struct timers untimed = {0};
    struct frame quiet = *frame;
    quiet.timers = &untimed;
    if (!caustics->tree)
        return;
    caustics_pass_render(caustics, frame, &renderer->gbuffer);
    struct composite_inputs inputs = renderer_composite_inputs(renderer);
    composite_pass_render_layer(&renderer->composite, &quiet, &inputs, LAYER_SENT,
                                renderer->glass.screen_framebuffer);
    glass_pass_render(&renderer->glass, frame, &renderer->gbuffer,
                      &(struct glass_inputs){.surfaces = &caustics->surfaces,
                                             .tree = caustics->tree,
                                             .sky = renderer->desc.emitters.sky,
                                             .framebuffer = caustics->surface_framebuffer});
}
