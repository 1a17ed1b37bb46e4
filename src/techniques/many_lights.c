/* A frame of the passes that the techniques share. */
#include "techniques/many_lights.h"

#include "passes/frame.h"

void many_lights_render_vpls(struct many_lights *lights, const struct frame *frame) {
    bool by_importance = many_lights_follow_camera(lights);
    albedos_follow(&lights->albedos, frame->geometry);
    const struct light_rays rays = {by_importance ? lights->importance.bvh->buffer.texels : 0,
                                    lights->albedos.buffer.texels, frame->sky_pieces->id};
    geometry_pass_render_lights(&lights->geometry, frame, lights->rsm);
    vpl_pass_share_out(&lights->vpl, frame);
    if (by_importance)
        importance_map_pass_render(&lights->importance, frame, lights->rsm, &rays,
                                   &lights->vpl.shares);
    vpl_pass_render(&lights->vpl, frame, lights->rsm, &lights->importance.map, &rays,
                    &lights->vpls);
    if (lights->near_field.program)
        near_field_pass_render_lights(&lights->near_field, frame, lights->rsm, &lights->vpl.shares,
                                      &lights->importance.map);
    if (lights->bounces == 1)
        return;
    if (by_importance)
        path_starts_render(&lights->path_starts, frame, lights->rsm, &rays);
    bounce_pass_render(&lights->bounce, frame,
                       by_importance ? &lights->path_starts.vpls : &lights->vpls, rays.albedos);
    vpl_pass_sum_up(&lights->vpl, &lights->bounce.vpls);
}

void many_lights_begin(const struct many_lights *lights, const struct frame *frame,
                       const struct gbuffer *gbuffer) {
    gather_pass_clear(&lights->gather);
    if (lights->bounces > 1)
        bounce_pass_find_kept(&lights->bounce, frame);
    if (lights->specular_gather.program)
        gather_pass_clear(&lights->specular_gather);
    if (!lights->adaptive.program)
        return;
    adaptive_pass_render(&lights->adaptive, frame, gbuffer);
    gather_pass_clear(&lights->adaptive_gather);
}

void many_lights_gather(const struct many_lights *lights, const struct frame *frame,
                        const struct gbuffer *gbuffer, const struct gather_inputs *inputs) {
    struct gather_inputs all = *inputs;
    all.lists = &lights->adaptive.lists;
    all.kept = inputs->later ? &lights->bounce.kept : NULL;
    all.visibility.tree = lights->tree;
    gather_pass_render(&lights->gather, frame, gbuffer, &all);
    if (lights->adaptive.program)
        gather_pass_render(&lights->adaptive_gather, frame, gbuffer, &all);
    if (lights->specular_gather.program && !(inputs->later && lights->specular_rays.program))
        gather_pass_render(&lights->specular_gather, frame, gbuffer, &all);
}

static void add_near_field(const struct many_lights *lights, const struct frame *frame,
                           const struct gbuffer *gbuffer) {
    struct near_field_inputs inputs = {.shares = &lights->vpl.shares,
                                       .irradiance = &lights->gather.irradiance,
                                       .lists = &lights->adaptive.lists};
    near_field_pass_render(&lights->near_field, frame, gbuffer, &inputs);
    if (!lights->adaptive.program)
        return;
    inputs.irradiance = &lights->adaptive_gather.irradiance;
    inputs.of_lists = true;
    near_field_pass_render(&lights->near_field, frame, gbuffer, &inputs);
}

static void blur_irradiance(const struct many_lights *lights, const struct frame *frame,
                            const struct gbuffer *gbuffer) {
    struct blur_inputs inputs = {.source = &lights->gather.irradiance};
    if (lights->adaptive.program) {
        inputs.lists = &lights->adaptive.lists;
        inputs.adaptive = &lights->adaptive_gather.irradiance;
    }
    blur_pass_render(&lights->blur, frame, gbuffer, &inputs);
}

static void finish_specular(const struct many_lights *lights, const struct frame *frame,
                            const struct gbuffer *gbuffer) {
    const struct specular_rays_inputs inputs = {
        .tree = lights->tree,
        .rsm = lights->rsm,
        .shares = &lights->vpl.shares,
        .importance = &lights->importance.map,
        .albedos = lights->albedos.buffer.texels,
        .irradiance = many_lights_contribution(lights).irradiance,
        .radiance = &lights->specular_gather.irradiance,
    };
    if (lights->specular_rays.program)
        specular_rays_pass_render(&lights->specular_rays, frame, gbuffer, &inputs);
    blur_pass_render(&lights->specular_blur, frame, gbuffer,
                     &(struct blur_inputs){.source = &lights->specular_gather.irradiance});
}

void many_lights_finish(const struct many_lights *lights, const struct frame *frame,
                        const struct gbuffer *gbuffer) {
    if (lights->near_field.program)
        add_near_field(lights, frame, gbuffer);
    if (lights->blur.pack_program)
        blur_irradiance(lights, frame, gbuffer);
    if (lights->specular_gather.program)
        finish_specular(lights, frame, gbuffer);
}

void many_lights_render_view(const struct many_lights *lights, const struct frame *frame,
                             const struct gbuffer *gbuffer) {
    struct gather_inputs inputs = {.vpls = &lights->vpls};
    many_lights_begin(lights, frame, gbuffer);
    many_lights_gather(lights, frame, gbuffer, &inputs);
    inputs.vpls = &lights->bounce.vpls;
    inputs.later = true;
    if (lights->bounces > 1)
        many_lights_gather(lights, frame, gbuffer, &inputs);
    many_lights_finish(lights, frame, gbuffer);
}

bool many_lights_follow_camera(const void *state) {
    const struct many_lights *lights = state;
    return lights->importance.density_program;
}

struct contribution many_lights_contribution(const void *state) {
    const struct many_lights *lights = state;
    struct contribution contribution = {
        .irradiance =
            lights->blur.pack_program ? &lights->blur.blurred : &lights->gather.irradiance,
        .radiance = lights->specular_gather.program ? &lights->specular_blur.blurred.texture : NULL,
    };
    if (lights->adaptive.program &&
        lights->adaptive_gather.desc.list_slots[LIST_EDGE_SAMPLES] > 0) {
        contribution.edge_sample_irradiance = &lights->adaptive_gather.irradiance;
        contribution.edge_sample_texels = &lights->adaptive.lists.edge_sample_texels;
    }
    return contribution;
}

/* Those of faces have names of their own where there are both kinds. */
static void add_rsm(const struct many_lights *lights, int kind, struct output_list *outputs) {
    const struct gbuffer *rsm = &lights->rsm[kind];
    bool faces = kind == LIGHT_MAP_FACE && lights->rsm[LIGHT_MAP_SINGLE].layers > 0;
    const struct output rows[] = {
        {faces ? "rsm-faces-normal" : "rsm-normal", "reflective shadow map: what a light sees",
         OUTPUT_NORMAL, rsm},
        {faces ? "rsm-faces-albedo" : "rsm-albedo",
         "reflective shadow map: the surfaces' own colours", OUTPUT_ALBEDO, &rsm->albedo},
        {faces ? "rsm-faces-depth" : "rsm-depth",
         "reflective shadow map: near to the light is bright",
         kind == LIGHT_MAP_FACE ? OUTPUT_FACE_DEPTH : OUTPUT_SINGLE_DEPTH, &rsm->depth},
    };
    for (size_t i = 0; rsm->layers && i < sizeof rows / sizeof *rows; i++)
        output_add(outputs, &rows[i]);
}

void many_lights_outputs(const struct many_lights *lights, const struct vpl_buffer *vpls,
                         struct output_list *outputs) {
    const struct output rows[] = {
        {"vpl", "virtual point lights, in the colour of their light", OUTPUT_VPLS, vpls},
        {"gathered", "irradiance before the blur, in tiles of the pattern", OUTPUT_IRRADIANCE,
         &lights->gather.irradiance},
    };
    for (int kind = 0; kind < LIGHT_MAP_KINDS; kind++)
        add_rsm(lights, kind, outputs);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        output_add(outputs, &rows[i]);
    if (lights->bounces > 1)
        output_add(outputs, &(struct output){"bounce-vpl", "those of later bounces", OUTPUT_VPLS,
                                             &lights->bounce.vpls});
}
