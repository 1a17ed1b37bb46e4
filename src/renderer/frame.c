/* Draws frames, and the mean of passes. */
#include "passes/frame.h"
#include "renderer/renderer.h"

#include "renderer/caustics.h"
#include "renderer/views.h"
#include "shared/composite.h"
#include "techniques/volume.h"

#include "parts.h"

#include <assert.h>
#include <math.h>

const char *const shown_layer_names[] = {
    [LAYER_BEAUTY] = "full", [LAYER_DIRECT] = "direct", [LAYER_INDIRECT] = "indirect", NULL};

const char *shown_layer_prefix(int layer) {
    return layer == LAYER_BEAUTY ? "" : shown_layer_names[layer];
}

/* Estimates the irradiance of a light across the scene. A narrow cone lights less than its
 * intensity suggests. */
static float typical_irradiance(const struct emitter *light, float radius) {
    float brightest = fmaxf(light->intensity[0], fmaxf(light->intensity[1], light->intensity[2]));
    float share = light->type == EMITTER_SPOT
                      ? emitter_cone(light, 1) * fminf((float)emitter_solid_angle(light), 1)
                      : 1;
    return light->type == EMITTER_DIRECTIONAL ? brightest : brightest * share / (radius * radius);
}

float renderer_irradiance_scale(const struct renderer *renderer) {
    const struct renderer_desc *desc = &renderer->desc;
    const struct light_plan *plan = &renderer->plan;
    float typical = 0;
    for (int i = 0; i < plan->sky_samples.count; i++) {
        struct emitter emitter =
            sky_group_emitter(&plan->sky, &plan->sky_samples, i, desc->emitters.sky);
        typical += typical_irradiance(&emitter, desc->geometry->radius);
    }
    for (int i = 0; i < desc->emitters.count; i++)
        typical += typical_irradiance(&desc->emitters.items[i], desc->geometry->radius);
    return typical > 0 && isfinite(typical) ? exp2f(-roundf(log2f(typical))) : 1;
}

/* Returns specular direct light; NULL if all materials are diffuse. */
static const struct texture *direct_specular(const struct renderer *renderer) {
    const struct direct_method *direct = renderer->direct;
    return renderer->gbuffer.specular.id ? direct->specular(renderer->direct_state) : NULL;
}

/* Passes after the first have one sample a pixel, at another place in each. */
static const struct antialias_pass *antialias_of(const struct renderer *renderer) {
    return renderer->pass > 0 ? &renderer->refining.centers : &renderer->antialias;
}

struct frame renderer_frame(struct renderer *renderer) {
    return (struct frame){
        .timers = &renderer->timers,
        .view = &renderer->view_buffer,
        .camera = &renderer->camera_view,
        .camera_range = renderer->camera_range,
        .sensor = renderer->desc.sensor,
        .lights = &renderer->sample_buffer,
        .direct = renderer->direct->light(renderer->direct_state),
        .medium = renderer->airlight.medium.id ? &renderer->airlight.medium : NULL,
        .scene = &renderer->scene,
        .emitters = &renderer->sample_emitters,
        .light_block = renderer->sample_block,
        .layout = renderer->plan.sample_layout,
        .groups = renderer->light_samples.groups,
        .sampled = &renderer->sampled,
        .sky_pieces = &renderer->sky_pieces,
        .geometry = renderer_geometry(renderer),
        .assignment = &antialias_of(renderer)->assignment,
        .edge_samples = &antialias_of(renderer)->edge_samples,
        .pass = renderer->pass,
        .irradiance_scale = renderer_irradiance_scale(renderer),
    };
}

/* Returns the frame with the lights of direct light. */
static struct frame frame_of_direct(const struct renderer *renderer, const struct frame *frame) {
    struct frame direct = *frame;
    direct.lights = &renderer->light_buffer;
    direct.emitters = &renderer->plan.mapped;
    direct.light_block = renderer->light_block;
    direct.layout = renderer->plan.layout;
    direct.groups = NULL;
    return direct;
}

/* True if the technique of the refinement draws this frame. */
static bool is_refined(const struct renderer *renderer) {
    return renderer->pass > 0 && renderer->refining.technique;
}

/* Returns the indirect light of the frame, and its medium without panes. */
static struct contribution contribution_behind(const struct renderer *renderer) {
    const struct refining *refining = &renderer->refining;
    struct contribution contribution = is_refined(renderer)
                                           ? refining->technique->contribution(refining->state)
                                           : renderer_contribution(renderer);
    if (renderer->airlight.pass.in_scatter.id) {
        contribution.in_scatter = &renderer->airlight.pass.in_scatter;
        contribution.transmittance = &renderer->airlight.pass.transmittance;
    }
    return contribution;
}

static struct contribution last_contribution(const struct renderer *renderer) {
    struct contribution contribution = contribution_behind(renderer);
    if (renderer->airlight.panes.program) {
        contribution.in_scatter = &renderer->airlight.panes.own;
        contribution.transmittance = &renderer->airlight.panes.transmittance;
    }
    contribution.caustic = renderer->caustics.surface;
    contribution.volume_caustic = renderer->caustics.volume;
    return contribution;
}

struct composite_inputs renderer_composite_inputs(const struct renderer *renderer) {
    const struct antialias_pass *antialias = antialias_of(renderer);
    const struct contribution contribution = last_contribution(renderer);
    bool shows_sky = renderer->desc.background.kind == BACKGROUND_SCENE;
    return (struct composite_inputs){
        .gbuffer = &renderer->gbuffer,
        .direct = renderer->direct->light(renderer->direct_state),
        .direct_specular =
            contribution.direct_specular ? contribution.direct_specular : direct_specular(renderer),
        .contribution = contribution,
        .sky = shows_sky ? renderer->desc.emitters.sky : NULL,
        .background = renderer->desc.background,
        .samples = antialias->samples,
        .exposure = renderer_exposure(renderer),
        .tone_map = (enum tone_map)renderer_picture(renderer).tone_map,
        .layer = LAYER_BEAUTY,
    };
}

/* Returns the technique that draws this frame, and its state. */
static const struct technique *current_technique(const struct renderer *renderer, void **state) {
    const struct refining *refining = &renderer->refining;
    bool refined = is_refined(renderer);
    *state = refined ? refining->state : renderer->technique_state;
    return refined ? refining->technique : renderer->technique;
}

static bool follows_camera(const struct technique *technique, const void *state) {
    return technique->follows_camera && technique->follows_camera(state);
}

/* Draws the parts that depend on no camera. Direct light and the first pass keep theirs; later
 * passes have other lights. */
static void render_lights(struct renderer *renderer, const struct frame *frame) {
    bool keeps = renderer->lights_drawn && renderer->desc.keep_lights;
    void *state;
    const struct technique *technique = current_technique(renderer, &state);
    if (!keeps && renderer->direct->render_lights) {
        struct frame direct = frame_of_direct(renderer, frame);
        renderer->direct->render_lights(renderer->direct_state, &direct);
    }
    if ((!keeps || renderer->pass > 0) && technique->render_lights &&
        !follows_camera(technique, state))
        technique->render_lights(state, frame);
    struct airlight *airlight = &renderer->airlight;
    if (airlight->pass.in_scatter.id && (!keeps || renderer->pass > 0 || airlight->maps_pass > 0)) {
        shadow_map_pass_render(&airlight->maps, frame);
        airlight->maps_pass = renderer->pass;
    }
    renderer->lights_drawn = renderer->pass == 0 || (keeps && is_refined(renderer));
}

/* Draws the lights of a technique that follows the camera, after the G-buffer. */
static void render_lights_seen(struct renderer *renderer, const struct frame *frame) {
    void *state;
    const struct technique *technique = current_technique(renderer, &state);
    struct frame seen = *frame;
    seen.gbuffer = &renderer->gbuffer;
    if (follows_camera(technique, state))
        technique->render_lights(state, &seen);
}

/* Draws direct and indirect light of a G-buffer. */
static void render_light(struct renderer *renderer, const struct frame *frame,
                         const struct gbuffer *gbuffer) {
    void *state;
    const struct technique *technique = current_technique(renderer, &state);
    struct frame direct = frame_of_direct(renderer, frame);
    renderer->direct->render_view(renderer->direct_state, &direct, gbuffer);
    technique->render_view(state, frame, gbuffer);
}

/* Draws panes before the light of all other surfaces, which then stays in its textures. */
static void render_panes(struct renderer *renderer, const struct frame *frame) {
    const struct show_panes_pass *panes = &renderer->airlight.panes;
    struct timers untimed = {0};
    struct frame of_panes = *frame;
    of_panes.timers = &untimed;
    of_panes.of_panes = true;
    if (panes->surfaces_program) {
        timer_begin(frame->timers, "light of panes");
        show_panes_pass_render_surfaces(panes, &of_panes, &renderer->gbuffer);
        render_light(renderer, &of_panes, &panes->surfaces);
        timer_end(frame->timers);
    }
    struct contribution contribution = contribution_behind(renderer);
    show_panes_pass_render(panes, frame, &renderer->gbuffer, &contribution,
                           renderer->direct->light(renderer->direct_state),
                           renderer->desc.emitters.sky);
}

/* Renders every buffer of a frame except the composite. */
static void render_frame(struct renderer *renderer, const struct frame *frame) {
    renderer->frame_count++;
    render_lights(renderer, frame);
    geometry_pass_render_camera(&renderer->geometry, frame, &renderer->gbuffer);
    if (renderer->pass == 0)
        antialias_pass_render(&renderer->antialias, frame, &renderer->gbuffer);
    render_lights_seen(renderer, frame);
    if (renderer->airlight.pass.in_scatter.id)
        airlight_pass_render(&renderer->airlight.pass, frame, &renderer->gbuffer,
                             renderer->airlight.maps.maps, &renderer->plan.mapped);
    if (renderer->airlight.panes.program && renderer->desc.sensor == 0)
        render_panes(renderer, frame);
    render_light(renderer, frame, &renderer->gbuffer);
    IF_CAUSTICS(renderer_render_caustics(renderer, frame), (void)0);
}

static void begin_pass(struct renderer *renderer, int pass) {
    if (renderer->pass == pass)
        return;
    renderer->pass = pass;
    renderer_write_views(renderer);
}

void renderer_render(struct renderer *renderer) {
    begin_pass(renderer, 0);
    renderer->refining.count = 0;
    struct frame frame = renderer_frame(renderer);
    struct composite_inputs inputs = renderer_composite_inputs(renderer);
    timer_begin(&renderer->timers, "frame");
    render_frame(renderer, &frame);
    composite_pass_render(&renderer->composite, &frame, &inputs);
    timer_end(&renderer->timers);
}

static void show_mean(struct renderer *renderer, const struct frame *frame, int layer) {
    const struct refining *refining = &renderer->refining;
    mean_pass_render_display(&refining->mean, frame, refining->weight, layer,
                             renderer_exposure(renderer),
                             renderer_picture(renderer).tone_map == TONE_MAP_FILMIC,
                             &renderer->desc.background, renderer->composite.framebuffer);
}

/* Returns the weight of a pass in the mean. */
static float pass_weight(const struct renderer *renderer) {
    const struct refinement *refinement = renderer->technique->refinement;
    return renderer->pass == 0 && refinement ? refinement->first_weight : 1;
}

static void add_to_mean(struct renderer *renderer, const struct frame *frame) {
    struct refining *refining = &renderer->refining;
    struct composite_inputs inputs = renderer_composite_inputs(renderer);
    float weight = pass_weight(renderer);
    for (int layer = 0; layer < refining->mean.layers; layer++)
        if (refining->mean.framebuffers[layer])
            composite_pass_add_layer(&renderer->composite, frame, &inputs, layer, weight,
                                     refining->mean.framebuffers[layer]);
    refining->count++;
    refining->weight += (double)weight;
}

void renderer_add_pass(struct renderer *renderer, int pass) {
    struct refining *refining = &renderer->refining;
    assert(renderer->desc.progressive);
    if (refining->count == 0 || pass != renderer->pass + 1) {
        mean_pass_clear(&refining->mean);
        refining->count = 0;
        refining->weight = 0;
    }
    begin_pass(renderer, pass);
    struct frame frame = renderer_frame(renderer);
    timer_begin(&renderer->timers, "frame");
    render_frame(renderer, &frame);
    add_to_mean(renderer, &frame);
    show_mean(renderer, &frame, LAYER_BEAUTY);
    timer_end(&renderer->timers);
}

void renderer_forget_frame(struct renderer *renderer) {
    renderer->lights_drawn = false;
    renderer->refining.count = 0;
    renderer->frame_count++;
}

int renderer_pass_count(const struct renderer *renderer) {
    return renderer->refining.count;
}

double renderer_pass_weight(const struct renderer *renderer) {
    return renderer->refining.weight;
}

void renderer_compose(struct renderer *renderer, int layer) {
    struct timers untimed = {0};
    struct frame frame = renderer_frame(renderer);
    frame.timers = &untimed;
    struct composite_inputs inputs = renderer_composite_inputs(renderer);
    inputs.layer = layer;
    if (renderer->refining.count > 0)
        show_mean(renderer, &frame, layer);
    else
        composite_pass_render(&renderer->composite, &frame, &inputs);
}

struct contribution renderer_contribution(const struct renderer *renderer) {
    return renderer->technique->contribution(renderer->technique_state);
}

struct picture_settings renderer_picture(const struct renderer *renderer) {
    return *settings_of(struct picture_settings, &renderer->desc.settings, &picture_part);
}

float renderer_exposure(const struct renderer *renderer) {
    return renderer_picture(renderer).exposure;
}

void renderer_outputs(const struct renderer *renderer, struct output_list *outputs) {
    const struct irradiance *irradiance = renderer_contribution(renderer).irradiance;
    const struct output rows[] = {
        {"normal", "G-buffer: world normals as colours", OUTPUT_NORMAL, &renderer->gbuffer},
        {"albedo", "G-buffer: the surfaces' own colours", OUTPUT_ALBEDO, &renderer->gbuffer.albedo},
        {"depth", "G-buffer: near is bright", OUTPUT_DEPTH, &renderer->gbuffer.depth},
        {"illuminance", "light that surfaces receive, in false colours", OUTPUT_ILLUMINANCE, NULL},
        {"luminance", "light that the camera sees, in false colours", OUTPUT_LUMINANCE, NULL},
    };
    *outputs = (struct output_list){0};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        output_add(outputs, &rows[i]);
    if (renderer->technique->outputs)
        renderer->technique->outputs(renderer->technique_state, outputs);
    if (renderer->airlight.pass.in_scatter.id)
        output_add(outputs, &(struct output){"airlight", "what the medium scatters to the camera",
                                             OUTPUT_AIRLIGHT, &renderer->airlight.pass.in_scatter});
    if (renderer->caustics.surface)
        output_add(outputs,
                   &(struct output){"caustic",
                                    "light that glass and mirrors throw onto surfaces, and show",
                                    OUTPUT_RADIANCE, renderer->caustics.surface});
    if (renderer->caustics.volume)
        output_add(outputs,
                   &(struct output){"volume", "light of glass and mirrors that the medium scatters",
                                    OUTPUT_RADIANCE, renderer->caustics.volume});
    if (irradiance)
        output_add(outputs,
                   &(struct output){"irradiance", "after the blur, before the surfaces' colours",
                                    OUTPUT_IRRADIANCE, irradiance});
    IF_VOLUME(
        output_add(outputs,
                   &(struct output){"ao", "ambient occlusion by voxels: nothing near is white",
                                    OUTPUT_AO, &renderer_drawn_ao}),
        (void)0);
}

float renderer_ao_distance(const struct settings *settings, const struct geometry *geometry) {
    (void)settings, (void)geometry;
    return IF_VOLUME(volume_ao_distance(settings, geometry), 0);
}
