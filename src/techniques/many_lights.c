#include "techniques/many_lights.h"

struct visibility_desc many_lights_lookup(const struct settings *settings,
                                          enum visibility_lookup lookup, int map_count) {
    return (struct visibility_desc){
        .lookup = lookup,
        .map_size = settings->map_size,
        .map_count = map_count,
        .basis_terms = settings->basis_terms,
        .bias = settings->bias,
        .map_bias = settings->map_bias,
        .shift = settings->shift,
        .gain = settings->gain,
        .sharpen_a = settings->sharpen_a,
        .sharpen_b = settings->sharpen_b,
        .taps = settings->taps,
        .filter_jacobian = settings->filter_jacobian,
    };
}

static bool init_gather(struct many_lights *lights, const struct technique_desc *desc,
                        const struct many_lights_visibility *visibility) {
    const struct settings *settings = desc->settings;
    return gather_pass_init(
        &lights->gather,
        &(struct gather_desc){
            .width = desc->width,
            .height = desc->height,
            .interleave = settings->interleave,
            .map_per_vpl = visibility->map_per_vpl,
            .share = visibility->share,
            .visibility = many_lights_lookup(settings, visibility->lookup, visibility->map_count),
            .clamp = (enum gather_clamp)settings->clamp,
            .clamp_value = settings->clamp_value,
            .reach = settings->near_reach,
        });
}

static bool init_near_field(struct many_lights *lights, const struct technique_desc *desc) {
    const struct settings *settings = desc->settings;
    lights->has_near_field = settings->clamp == GATHER_CLAMP_NEAR;
    return !lights->has_near_field ||
           near_field_pass_init(&lights->near_field, &(struct near_field_desc){
                                                         .samples = settings->near_samples,
                                                         .interleave = settings->interleave,
                                                         .vpl_count = settings->vpl_count,
                                                         .rsm_size = lights->rsm.width,
                                                         .light_views = desc->light_views,
                                                         .reach = settings->near_reach,
                                                     });
}

static bool init_blur(struct many_lights *lights, const struct technique_desc *desc) {
    const struct settings *settings = desc->settings;
    int radius = settings->blur_radius < 0 ? settings->interleave / 2 : settings->blur_radius;
    return blur_pass_init(&lights->blur, &(struct blur_desc){
                                             .width = desc->width,
                                             .height = desc->height,
                                             .radius = radius,
                                             .distance = settings->blur_distance,
                                             .cosine = settings->blur_cosine,
                                             .square = !settings->blur_separable,
                                         });
}

bool many_lights_init(struct many_lights *lights, const struct technique_desc *desc,
                      const struct many_lights_visibility *visibility) {
    const struct settings *settings = desc->settings;
    *lights = (struct many_lights){0};
    /* Six maps of a cube see the whole sphere: half the size a side is the same density. */
    int rsm_size = desc->light_views > 1 ? (settings->rsm_size + 1) / 2 : settings->rsm_size;
    if (gbuffer_init(&lights->rsm, "rsm", rsm_size, rsm_size, desc->light_views) &&
        geometry_pass_init(&lights->geometry) &&
        vpl_pass_init(&lights->vpl,
                      &(struct vpl_desc){.count = settings->vpl_count, .seed = settings->seed}) &&
        vpl_buffer_init(&lights->vpls, "VPLs", settings->vpl_count) &&
        init_gather(lights, desc, visibility) && init_near_field(lights, desc) &&
        init_blur(lights, desc))
        return true;
    many_lights_free(lights);
    return false;
}

void many_lights_free(struct many_lights *lights) {
    gbuffer_free(&lights->rsm);
    geometry_pass_free(&lights->geometry);
    vpl_pass_free(&lights->vpl);
    vpl_buffer_free(&lights->vpls);
    gather_pass_free(&lights->gather);
    near_field_pass_free(&lights->near_field);
    blur_pass_free(&lights->blur);
}

bool many_lights_resize(struct many_lights *lights, int width, int height) {
    struct gather_desc gather_desc = lights->gather.desc;
    struct blur_desc blur_desc = lights->blur.desc;
    struct gather_pass gather;
    struct blur_pass blur;
    gather_desc.width = blur_desc.width = width;
    gather_desc.height = blur_desc.height = height;
    if (!gather_pass_init(&gather, &gather_desc))
        return false;
    if (!blur_pass_init(&blur, &blur_desc)) {
        gather_pass_free(&gather);
        return false;
    }
    gather_pass_free(&lights->gather);
    blur_pass_free(&lights->blur);
    lights->gather = gather;
    lights->blur = blur;
    return true;
}

void many_lights_render_vpls(struct many_lights *lights, const struct frame *frame) {
    geometry_pass_render_light(&lights->geometry, frame, &lights->rsm);
    vpl_pass_render(&lights->vpl, frame, &lights->rsm, &lights->vpls);
    if (lights->has_near_field)
        near_field_pass_render_light(&lights->near_field, frame, &lights->rsm);
}

void many_lights_finish(const struct many_lights *lights, const struct frame *frame,
                        const struct gbuffer *gbuffer) {
    if (lights->has_near_field)
        near_field_pass_render(&lights->near_field, frame, gbuffer, &lights->gather.irradiance);
    blur_pass_render(&lights->blur, frame, gbuffer, &lights->gather.irradiance);
}

float many_lights_depth_range(const struct settings *settings) {
    return 1 - 1 / (2 * (float)settings->basis_terms);
}

void many_lights_outputs(const struct many_lights *lights, struct technique_outputs *outputs) {
    *outputs = (struct technique_outputs){
        .irradiance = &lights->blur.blurred,
        .gathered = &lights->gather.irradiance,
        .rsm = &lights->rsm,
        .vpls = &lights->vpls,
        .visibility = &lights->gather.desc.visibility,
    };
}
