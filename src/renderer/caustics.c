#include "renderer/caustics.h"

bool renderer_has_caustics(const struct renderer_desc *desc) {
    return caustics_shown(desc->scene, &desc->settings);
}

static struct caustics_settings shown(const struct renderer_desc *desc) {
    struct caustics_settings none = {0};
    return renderer_has_caustics(desc)
               ? *settings_of(struct caustics_settings, &desc->settings, &caustics_part)
               : none;
}

unsigned renderer_caustic_kinds(const struct renderer_desc *desc, bool medium) {
    struct caustics_settings own = shown(desc);
    return (own.surface ? HAS_CAUSTICS : 0U) | (own.volume && medium ? HAS_VOLUME_CAUSTICS : 0U);
}

bool renderer_init_caustics(struct renderer *renderer, bool medium) {
    const struct renderer_desc *desc = &renderer->desc;
    struct caustics_settings own = shown(desc);
    return !renderer_has_caustics(desc) ||
           caustics_pass_init(&renderer->caustics,
                              &(struct caustics_desc){.width = desc->width,
                                                      .height = desc->height,
                                                      .size = own.size,
                                                      .chains = own.chains,
                                                      .surface = own.surface != CAUSTICS_OFF,
                                                      .points = own.surface == CAUSTICS_POINTS,
                                                      .volume = own.volume,
                                                      .medium = medium,
                                                      .scene = desc->scene,
                                                      .geometry = desc->geometry,
                                                      .casters = renderer->casters});
}
