#include "inspect/aov.h"

#include "base/error.h"
#include "base/names.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "inspect/lights.h"
#include "passes/frame.h"
#include "passes/gather/blur.h"
#include "passes/lights/val_light.h"
#include "passes/picture/triangles.h"
#include "passes/vpls.h"
#include "renderer/layer_target.h"
#include "shared/composite.h"
#include "shared/vpl.h"

#include <cglm/cglm.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What an output's channels are filled from. */
struct fill {
    struct renderer *renderer;
    const struct frame *frame;
    const struct layer_target *target;
    struct image *image;
    int channel; /* the output's first */
};

/* --- drawn layers --- */

/* A blur of no radius puts the tiles in order. */
static bool fill_irradiance(const struct fill *fill, const void *source) {
    struct renderer *renderer = fill->renderer;
    struct composite_inputs inputs = renderer_composite_inputs(renderer);
    struct blur_pass order;
    if (!blur_pass_init(&order, &(struct blur_desc){.width = renderer->desc.width,
                                                    .height = renderer->desc.height,
                                                    .distance = 1}))
        return false;
    blur_pass_render(&order, fill->frame, &renderer->gbuffer,
                     &(struct blur_inputs){.source = source});
    inputs.contribution.irradiance = &order.blurred;
    composite_pass_render_layer(&renderer->composite, fill->frame, &inputs, LAYER_INDIRECT,
                                fill->target->framebuffer);
    layer_target_read(fill->target, 0, 3, fill->image, fill->channel);
    blur_pass_free(&order);
    return true;
}

static bool fill_from_vals(const struct fill *fill, const struct val_output *vals, int first,
                           int count) {
    struct val_light_pass pass;
    if (!val_light_pass_init(&pass, vals->visibility))
        return false;
    val_light_pass_render(&pass, fill->frame, &fill->renderer->gbuffer, &vals->maps, vals->fluxes,
                          fill->target->framebuffer);
    layer_target_read(fill->target, first, count, fill->image, fill->channel);
    val_light_pass_free(&pass);
    return true;
}

static bool fill_strongest(const struct fill *fill, const void *source) {
    return fill_from_vals(fill, source, 0, 3);
}

static bool fill_visibility(const struct fill *fill, const void *source) {
    return fill_from_vals(fill, source, 3, 1);
}

/* The mean over a pixel's samples. */
static void draw_open(const struct fill *fill, const struct texture *open, GLuint program) {
    const struct frame *frame = fill->frame;
    const struct gbuffer *gbuffer = &fill->renderer->gbuffer;
    pass_set_state(
        &(struct pass_state){.name = "ambient occlusion",
                             .program = program,
                             .framebuffer = fill->target->framebuffer,
                             .width = gbuffer->width,
                             .height = gbuffer->height,
                             .textures = {{UNIT_GBUFFER_DEPTH, gbuffer->depth.id},
                                          {UNIT_GBUFFER_NORMAL, gbuffer->normal.id},
                                          {UNIT_IRRADIANCE, open->id},
                                          {UNIT_SAMPLE_ASSIGNMENT, frame->assignment->id},
                                          {UNIT_EDGE_SAMPLES, frame->edge_samples->id}},
                             .blocks = {{BLOCK_VIEW, frame->view}}});
    pass_draw_fullscreen(1);
}

static const struct irradiance *draw(const struct fill *fill, const struct drawn_output *output) {
    return output->draw(output->state, fill->renderer, fill->frame, &fill->renderer->gbuffer);
}

static bool fill_ambient_occlusion(const struct fill *fill, const void *source) {
    const struct irradiance *open = draw(fill, source);
    struct composite_inputs inputs = renderer_composite_inputs(fill->renderer);
    char defines[32];
    GLuint program;
    snprintf(defines, sizeof defines, "SAMPLES %d", inputs.samples);
    if (!open || !program_init(&program, &(struct program_desc){.screen = {"inspect/ao.frag"},
                                                                .defines = defines}))
        return false;
    draw_open(fill, &open->texture, program);
    layer_target_read(fill->target, 0, 1, fill->image, fill->channel);
    program_free(&program);
    return true;
}

static bool fill_voxels(const struct fill *fill, const void *source) {
    const struct irradiance *voxels = draw(fill, source);
    const struct image *image = fill->image;
    if (!voxels)
        return false;
    struct layer_target target = {voxels->texture, voxels->framebuffer, fill->target->x,
                                  fill->target->y};
    layer_target_read(&target, 0, 3, fill->image, fill->channel);
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++) {
            float *radiosity = image_at(fill->image, x, y) + fill->channel;
            glm_vec3_divs(radiosity, fill->frame->irradiance_scale, radiosity);
        }
    return true;
}

/* --- VPLs --- */

/* The pixel that a point falls on and its distance along the view's axis; false outside. */
static bool project(const struct renderer *renderer, const float position[3], int pixel[2],
                    float *depth) {
    const struct view *view = &renderer->camera_view;
    vec4 clip, point = {position[0], position[1], position[2], 1};
    vec3 from_eye;
    glm_mat4_mulv((vec4 *)view->world_to_clip, point, clip);
    if (clip[3] <= 0)
        return false;
    float x = (clip[0] / clip[3] * .5f + .5f) * (float)renderer->desc.width;
    float y = (.5f - clip[1] / clip[3] * .5f) * (float)renderer->desc.height;
    if (!(x >= 0 && y >= 0 && x < (float)renderer->desc.width && y < (float)renderer->desc.height))
        return false;
    pixel[0] = (int)x;
    pixel[1] = (int)y;
    glm_vec3_sub((float *)position, (float *)view->origin, from_eye);
    *depth = glm_vec3_dot(from_eye, (float *)renderer->desc.camera.forward);
    return true;
}

/* VPLs behind what the pixel shows are left out. */
static bool fill_flux(const struct fill *fill, const void *source) {
    const struct vpl_buffer *buffer = source;
    struct vpl *vpls = vpls_read(buffer);
    int z = image_find_channel(fill->image, "Z");
    for (int i = 0; i < buffer->count; i++) {
        struct vpl *vpl = &vpls[i];
        int pixel[2];
        float depth;
        if (vpl->reach <= 0 || !project(fill->renderer, vpl->position, pixel, &depth))
            continue;
        float *channels = image_at(fill->image, pixel[0], pixel[1]);
        if (fabsf(depth - channels[z]) < .01f * fill->renderer->desc.geometry->radius)
            glm_vec3_add(channels + fill->channel, vpl->flux, channels + fill->channel);
    }
    free(vpls);
    return true;
}

/* --- names --- */

/* Kinds that are pictures of what the camera sees; others have a shape of their own, or are layers
 * of every file. */
static const struct layer_kind {
    const char *channels; /* one character each */
    bool (*fill)(const struct fill *fill, const void *source);
} kinds[] = {
    [OUTPUT_IRRADIANCE] = {"RGB", fill_irradiance}, [OUTPUT_VPLS] = {"RGB", fill_flux},
    [OUTPUT_VALS] = {"RGB", fill_strongest},        [OUTPUT_VISIBILITY] = {"Y", fill_visibility},
    [OUTPUT_AO] = {"Y", fill_ambient_occlusion},    [OUTPUT_VOXELS] = {"RGB", fill_voxels},
};

static const struct layer_kind *kind_of(const struct output *output) {
    bool listed = output->kind < sizeof kinds / sizeof *kinds;
    return listed && kinds[output->kind].fill ? &kinds[output->kind] : NULL;
}

/* The next of "a,b"; false at the end. */
static bool next_name(const char **names, char *name, size_t size) {
    if (!*names)
        return false;
    size_t length = strcspn(*names, ",");
    snprintf(name, size, "%.*s", (int)length, *names);
    *names = (*names)[length] ? *names + length + 1 : NULL;
    return true;
}

static void add_surface_names(struct names *names) {
    for (int i = 0; surface_layer_names[i]; i++)
        names_add(names, ", ", surface_layer_names[i]);
}

static bool refuse(const struct renderer *renderer, const struct output_list *outputs,
                   const char *name) {
    struct names names = {0};
    for (int i = 0; i < outputs->count; i++)
        if (kind_of(&outputs->items[i]))
            names_add(&names, ", ", outputs->items[i].name);
    add_surface_names(&names);
    return error_set("aov: technique '%s' has no layer '%s' to add (there are %s)",
                     renderer->technique->name, name, names.text);
}

/* why: the option that leaves one sample per pixel; NULL: none. */
static bool check_matte(const char *name, const char *why) {
    return !why || !surface_layer_is_matte(name) ||
           error_set("aov: %s is of several samples of a pixel, and %s has one", name, why);
}

bool aov_check_surfaces(const char *names, bool centers) {
    struct names known = {0};
    char name[64];
    add_surface_names(&known);
    while (next_name(&names, name, sizeof name)) {
        if (surface_layer_find(name) < 0)
            return error_set("aov: no layer of surfaces is called '%s' (there are %s)", name,
                             known.text);
        if (!check_matte(name, centers ? "--centers" : NULL))
            return false;
    }
    return true;
}

bool aov_needs_pass(const char *names) {
    char name[64];
    bool needs = false;
    while (next_name(&names, name, sizeof name))
        needs |= surface_layer_find(name) < 0;
    return needs;
}

bool aov_check(const struct renderer *renderer, const char *names) {
    struct output_list outputs;
    char name[64];
    renderer_outputs(renderer, &outputs);
    while (next_name(&names, name, sizeof name)) {
        const struct output *output = output_find(&outputs, name);
        if (!check_matte(name, renderer->antialias.samples == 1 ? "picture.samples=1" : NULL))
            return false;
        if (surface_layer_find(name) >= 0)
            continue;
        if (!output || !kind_of(output))
            return refuse(renderer, &outputs, name);
        const struct drawn_output *drawn = output->kind == OUTPUT_AO ? output->source : NULL;
        if (drawn && !drawn->check(renderer))
            return false;
    }
    return true;
}

static bool append(struct fill *fill, const struct output *output) {
    const struct layer_kind *kind = kind_of(output);
    char channels[256] = "";
    size_t used = 0;
    for (const char *c = kind->channels; *c; c++)
        used += (size_t)snprintf(channels + used, sizeof channels - used, "%s%s.%c",
                                 used ? " " : "", output->name, *c);
    fill->channel = fill->image->channel_count;
    image_add_channels(fill->image, channels);
    return kind->fill(fill, output->source);
}

static uint32_t *look(void *user, int i) {
    const struct fill *fill = user;
    const struct renderer_desc *desc = &fill->renderer->desc;
    float place[2];
    antialias_pass_place(&fill->renderer->antialias, i, place);
    return triangles_read(fill->frame, &desc->camera, desc->width, desc->height, place);
}

static bool append_surfaces(struct fill *fill, const char *names,
                            const struct surface_motion *motion) {
    const struct renderer_desc *desc = &fill->renderer->desc;
    uint32_t *triangles =
        triangles_read(fill->frame, &desc->camera, desc->width, desc->height, (float[2]){0});
    const struct surface_view view = {desc->scene,   desc->geometry,
                                      &desc->camera, triangles,
                                      motion,        fill->renderer->antialias.samples,
                                      look,          fill};
    bool ok = triangles && surface_layers_append(&view, names, fill->image);
    free(triangles);
    return ok;
}

bool aov_append(struct renderer *renderer, const char *names, const struct surface_motion *motion,
                struct image *image) {
    struct timers untimed = {0};
    struct frame frame = renderer_frame(renderer);
    struct output_list outputs;
    struct layer_target target;
    const char *all = names;
    char name[64];
    if (!names)
        return true;
    if (!aov_check(renderer, names) || !layer_target_init(&target, image->width, image->height))
        return false;
    renderer_outputs(renderer, &outputs);
    frame.timers = &untimed;
    struct fill fill = {renderer, &frame, &target, image, 0};
    bool ok = true, surfaces = false, added[OUTPUTS_MAX] = {false};
    while (ok && next_name(&names, name, sizeof name)) {
        if (surface_layer_find(name) >= 0) {
            surfaces = true;
            continue;
        }
        const struct output *output = output_find(&outputs, name);
        bool *done = &added[output - outputs.items];
        ok = *done || append(&fill, output);
        *done = true;
    }
    ok = ok && (!surfaces || append_surfaces(&fill, all, motion));
    layer_target_free(&target);
    return ok;
}
