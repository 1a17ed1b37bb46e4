#include "renderer/caustics.h"

#include "base/memory.h"
#include "passes/picture/composite.h"

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

unsigned renderer_caustic_kinds(const struct renderer_desc *desc, bool medium) {
    const struct caustics_settings *own =
        settings_of(struct caustics_settings, &desc->settings, &caustics_part);
    if (!renderer_has_caustics(desc))
        return 0;
    return HAS_CAUSTICS | (own->volume && medium ? HAS_VOLUME_CAUSTICS : 0U);
}
