/* Draws a frame by the passes that the techniques share. */
#include "techniques/many_lights.h"

#include "passes/frame.h"

/* --- passes that depend on no camera, unless VPLs are placed by importance --- */

static struct light_rays rays_of(const struct many_lights *lights, const struct frame *frame) {
    const struct caster_bvh *bvh = lights->tree ? lights->tree : lights->importance.bvh;
    return (struct light_rays){bvh ? bvh->buffer.texels : 0, lights->albedos.buffer.texels,
                               frame->sky_pieces->id};
}

static void draw_rsm(struct many_lights *lights, const struct step_inputs *inputs) {
    albedos_follow(&lights->albedos, inputs->frame->geometry);
    geometry_pass_render_lights(&lights->geometry, inputs->frame, lights->rsm);
    vpl_pass_share_out(&lights->vpl, inputs->frame);
}

static void draw_importance_map(struct many_lights *lights, const struct step_inputs *inputs) {
    const struct light_rays rays = rays_of(lights, inputs->frame);
    importance_map_pass_render(&lights->importance, inputs->frame, lights->rsm, &rays,
                               &lights->vpl.shares);
}

static void draw_vpls(struct many_lights *lights, const struct step_inputs *inputs) {
    const struct light_rays rays = rays_of(lights, inputs->frame);
    vpl_pass_render(&lights->vpl, inputs->frame, lights->rsm, &lights->importance.map, &rays,
                    &lights->vpls);
}

static void draw_near_light(struct many_lights *lights, const struct step_inputs *inputs) {
    near_field_pass_render_lights(&lights->near_field, inputs->frame, lights->rsm,
                                  &lights->vpl.shares, &lights->importance.map);
}

static void draw_bounces(struct many_lights *lights, const struct step_inputs *inputs) {
    const struct light_rays rays = rays_of(lights, inputs->frame);
    bool by_importance = many_lights_follow_camera(lights);
    if (by_importance)
        path_starts_render(&lights->path_starts, inputs->frame, lights->rsm, &rays);
    bounce_pass_render(&lights->bounce, inputs->frame,
                       by_importance ? &lights->path_starts.vpls : &lights->vpls, rays.albedos);
    vpl_pass_sum_up(&lights->vpl, &lights->bounce.vpls);
}

/* --- passes of a view --- */

static void draw_adaptive(struct many_lights *lights, const struct step_inputs *inputs) {
    adaptive_pass_render(&lights->adaptive, inputs->frame, inputs->gbuffer);
    gather_pass_clear(&lights->adaptive_gather);
}

static void gather(struct many_lights *lights, const struct step_inputs *inputs) {
    gather_pass_render(&lights->gather, inputs->frame, inputs->gbuffer, inputs->gather);
}

static void gather_adaptive(struct many_lights *lights, const struct step_inputs *inputs) {
    gather_pass_render(&lights->adaptive_gather, inputs->frame, inputs->gbuffer, inputs->gather);
}

/* Specular rays include later bounces at the surfaces that they meet. */
static void gather_specular(struct many_lights *lights, const struct step_inputs *inputs) {
    if (!inputs->gather->later || !lights->specular_rays.program)
        gather_pass_render(&lights->specular_gather, inputs->frame, inputs->gbuffer,
                           inputs->gather);
}

static void add_near_field(struct many_lights *lights, const struct step_inputs *inputs) {
    near_field_pass_render(&lights->near_field, inputs->frame, inputs->gbuffer,
                           &(struct near_field_inputs){.shares = &lights->vpl.shares,
                                                       .irradiance = &lights->gather.irradiance,
                                                       .lists = &lights->adaptive.lists});
}

static void add_adaptive_near_field(struct many_lights *lights, const struct step_inputs *inputs) {
    near_field_pass_render(
        &lights->near_field, inputs->frame, inputs->gbuffer,
        &(struct near_field_inputs){.shares = &lights->vpl.shares,
                                    .irradiance = &lights->adaptive_gather.irradiance,
                                    .lists = &lights->adaptive.lists,
                                    .of_lists = true});
}

static void add_sampled(struct many_lights *lights, const struct step_inputs *inputs) {
    const struct light_rays rays = rays_of(lights, inputs->frame);
    struct near_sampled_inputs near = {.shares = &lights->vpl.shares,
                                       .importance = &lights->importance.map,
                                       .rays = &rays,
                                       .irradiance = &lights->gather.irradiance,
                                       .lists = &lights->adaptive.lists};
    near_sampled_pass_render(&lights->near_sampled, inputs->frame, inputs->gbuffer, &near);
    near.irradiance = &lights->adaptive_gather.irradiance;
    near.of_lists = true;
    if (lights->near_sampled.adaptive_program)
        near_sampled_pass_render(&lights->near_sampled, inputs->frame, inputs->gbuffer, &near);
}

static void blur_irradiance(struct many_lights *lights, const struct step_inputs *inputs) {
    struct blur_inputs blurred = {.source = &lights->gather.irradiance};
    if (lights->adaptive.program) {
        blurred.lists = &lights->adaptive.lists;
        blurred.adaptive = &lights->adaptive_gather.irradiance;
    }
    blur_pass_render(&lights->blur, inputs->frame, inputs->gbuffer, &blurred);
}

static void trace_specular(struct many_lights *lights, const struct step_inputs *inputs) {
    specular_rays_pass_render(&lights->specular_rays, inputs->frame, inputs->gbuffer,
                              &(struct specular_rays_inputs){
                                  .tree = lights->tree,
                                  .rsm = lights->rsm,
                                  .shares = &lights->vpl.shares,
                                  .importance = &lights->importance.map,
                                  .albedos = lights->albedos.buffer.texels,
                                  .irradiance = many_lights_contribution(lights).irradiance,
                                  .radiance = &lights->specular_gather.irradiance,
                              });
}

static void blur_specular(struct many_lights *lights, const struct step_inputs *inputs) {
    blur_pass_render(&lights->specular_blur, inputs->frame, inputs->gbuffer,
                     &(struct blur_inputs){.source = &lights->specular_gather.irradiance});
}

/* --- the frame --- */

#define MADE(program) offsetof(struct many_lights, program)

static const char far_light[] =
    "lights.importance, and an environment, wide lamps, lamps next door or many lights";

const struct step many_lights_steps[] = {
    {STEP_LIGHTS, "rsm", NULL, 0, draw_rsm},
    {STEP_LIGHTS, "importance map", far_light, MADE(importance.density_program),
     draw_importance_map},
    {STEP_LIGHTS, "vpls", NULL, 0, draw_vpls},
    {STEP_LIGHTS, "near light", "gather.clamp=near", MADE(near_field.program), draw_near_light},
    {STEP_LIGHTS, "bounces", "lights.bounces>1", MADE(bounce.path_program), draw_bounces},
    {STEP_BEGIN, "adaptive", "gather.adaptive>0", MADE(adaptive.program), draw_adaptive},
    {STEP_GATHER, "gather", NULL, 0, gather},
    {STEP_GATHER, "adaptive gather", "gather.adaptive>0", MADE(adaptive.program), gather_adaptive},
    {STEP_GATHER, "gather, specular", "specular surfaces", MADE(specular_gather.program),
     gather_specular},
    {STEP_FINISH, "near field", "gather.clamp=near", MADE(near_field.program), add_near_field},
    {STEP_FINISH, "adaptive near field", "gather.adaptive>0, gather.clamp=near",
     MADE(near_field.adaptive_program), add_adaptive_near_field},
    {STEP_FINISH, "near field, sampled", "gather.clamp=near, sampled lights",
     MADE(near_sampled.program), add_sampled},
    {STEP_FINISH, "blur", "gather.interleave>1", MADE(blur.pack_program), blur_irradiance},
    {STEP_FINISH, "specular rays", "gather.specular=rays, specular surfaces",
     MADE(specular_rays.program), trace_specular},
    {STEP_FINISH, "blur", "specular surfaces", MADE(specular_blur.pack_program), blur_specular},
    {0},
};

bool step_runs(const struct step *step, const void *state) {
    return !step->when || *(const GLuint *)((const char *)state + step->made);
}

static void run(struct many_lights *lights, enum step_part part, const struct step_inputs *inputs) {
    for (const struct step *step = many_lights_steps; step->timer; step++)
        if (step->part == part && step_runs(step, lights))
            step->draw(lights, inputs);
}

void many_lights_render_vpls(struct many_lights *lights, const struct frame *frame) {
    run(lights, STEP_LIGHTS, &(struct step_inputs){.frame = frame});
}

void many_lights_begin(struct many_lights *lights, const struct frame *frame,
                       const struct gbuffer *gbuffer) {
    gather_pass_clear(&lights->gather);
    if (lights->bounces > 1)
        bounce_pass_find_kept(&lights->bounce, frame);
    if (lights->specular_gather.program)
        gather_pass_clear(&lights->specular_gather);
    run(lights, STEP_BEGIN, &(struct step_inputs){frame, gbuffer, NULL});
}

void many_lights_gather(struct many_lights *lights, const struct frame *frame,
                        const struct gbuffer *gbuffer, const struct gather_inputs *inputs) {
    struct gather_inputs all = *inputs;
    all.lists = &lights->adaptive.lists;
    all.kept = inputs->later ? &lights->bounce.kept : NULL;
    all.visibility.tree = lights->tree;
    run(lights, STEP_GATHER, &(struct step_inputs){frame, gbuffer, &all});
}

void many_lights_finish(struct many_lights *lights, const struct frame *frame,
                        const struct gbuffer *gbuffer) {
    run(lights, STEP_FINISH, &(struct step_inputs){frame, gbuffer, NULL});
}

void many_lights_render_view(struct many_lights *lights, const struct frame *frame,
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

/* Adds the RSM of one kind. Maps of faces have other names if there are both kinds. */
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
