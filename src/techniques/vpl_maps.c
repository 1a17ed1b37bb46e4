#include "techniques/vpl_maps.h"

bool vpl_maps_init(struct vpl_maps *maps, const struct vpl_maps_desc *desc) {
    *maps = (struct vpl_maps){.desc = *desc};
    return vpl_views_pass_init(&maps->views, many_lights_near_clip);
}

static void render_true(void *state, const struct frame *frame, const struct map_views *views,
                        int first) {
    (void)first;
    paraboloid_pass_render(state, frame, views);
}

bool vpl_maps_init_true(struct vpl_maps *maps, struct paraboloid_pass *paraboloid,
                        const struct technique_desc *desc, int batch) {
    const struct map_settings *map = settings_of(struct map_settings, desc->settings, &map_part);
    struct caster_desc caster = many_lights_caster(desc->settings);
    caster.error = 0;
    return paraboloid_pass_init(paraboloid,
                                &(struct paraboloid_desc){
                                    .casters = desc->casters,
                                    .caster = caster,
                                    .size = map->size,
                                    .count = batch,
                                    .planes = true,
                                }) &&
           vpl_maps_init(maps, &(struct vpl_maps_desc){&paraboloid->maps, render_true, paraboloid});
}

void vpl_maps_free(struct vpl_maps *maps) {
    vpl_views_pass_free(&maps->views);
    *maps = (struct vpl_maps){0};
}

int vpl_maps_render_batch(struct vpl_maps *maps, const struct frame *frame,
                          const struct vpl_buffer *vpls, int first) {
    int rest = vpls->count - first, batch = maps->desc.maps->count;
    int count = rest < batch ? rest : batch;
    if (count <= 0 || (maps->held == vpls && maps->held_first == first))
        return count > 0 ? count : 0;
    vpl_views_pass_render(&maps->views, frame, vpls, first, count);
    maps->desc.render(maps->desc.state, frame, &maps->views.views, first);
    maps->held = vpls;
    maps->held_first = first;
    return count;
}

void vpl_maps_drop(struct vpl_maps *maps) {
    maps->held = NULL;
}

struct visibility_inputs vpl_maps_inputs(const struct vpl_maps *maps) {
    return (struct visibility_inputs){.views = &maps->views.views, .depth = maps->desc.maps};
}

void vpl_maps_render_vpls(struct vpl_maps *maps, struct many_lights *lights,
                          const struct frame *frame) {
    many_lights_render_vpls(lights, frame);
    vpl_maps_drop(maps);
}

void vpl_maps_render_lights(struct vpl_maps *maps, struct many_lights *lights,
                            const struct frame *frame) {
    vpl_maps_render_vpls(maps, lights, frame);
    if (lights->bounces == 1 && lights->vpls.count <= maps->desc.maps->count)
        vpl_maps_render_batch(maps, frame, &lights->vpls, 0);
}

void vpl_maps_gather(struct vpl_maps *maps, struct many_lights *lights,
                     const struct vpl_buffer *vpls, bool later, const struct frame *frame,
                     const struct gbuffer *gbuffer) {
    for (int first = 0, count; (count = vpl_maps_render_batch(maps, frame, vpls, first)) > 0;
         first += count)
        many_lights_gather(lights, frame, gbuffer,
                           &(struct gather_inputs){.vpls = vpls,
                                                   .first = first,
                                                   .count = count,
                                                   .later = later,
                                                   .visibility = vpl_maps_inputs(maps)});
}

void vpl_maps_render_view(struct vpl_maps *maps, struct many_lights *lights,
                          const struct frame *frame, const struct gbuffer *gbuffer) {
    many_lights_begin(lights, frame, gbuffer);
    vpl_maps_gather(maps, lights, &lights->vpls, false, frame, gbuffer);
    if (lights->bounces > 1)
        vpl_maps_gather(maps, lights, &lights->bounce.vpls, true, frame, gbuffer);
    many_lights_finish(lights, frame, gbuffer);
}
