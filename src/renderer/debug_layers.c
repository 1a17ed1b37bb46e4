#include "renderer/debug_layers.h"

#include "base/error.h"
#include "base/memory.h"
#include "passes/gather/blur.h"
#include "passes/lights/val_light.h"
#include "renderer/layer_target.h"
#include "shared/composite.h"
#include "shared/vpl.h"

#include <cglm/cglm.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const struct debug_row {
    const char *name, *channels, *needs;
} rows[DEBUG_LAYER_COUNT] = {
    [DEBUG_GATHERED] = {"gathered", "gathered.R gathered.G gathered.B", "gather"},
    [DEBUG_VAL] = {"val", "val.R val.G val.B", "VALs"},
    [DEBUG_VISIBILITY] = {"visibility", "visibility.Y", "VALs"},
    [DEBUG_VPL] = {"vpl", "vpl.R vpl.G vpl.B", "VPLs"},
};

static bool parse_name(unsigned *layers, const char *name, size_t length) {
    for (int i = 0; i < DEBUG_LAYER_COUNT; i++)
        if (strlen(rows[i].name) == length && strncmp(rows[i].name, name, length) == 0) {
            *layers |= 1U << i;
            return true;
        }
    return error_set("no layer is called '%.*s' (there is: gathered, val, visibility, vpl)",
                     (int)length, name);
}

bool debug_layers_parse(unsigned *layers, const char *names) {
    *layers = 0;
    for (const char *name = names;; name++) {
        size_t length = strcspn(name, ",");
        if (!parse_name(layers, name, length))
            return false;
        name += length;
        if (!*name)
            return true;
    }
}

static bool has(const struct technique_outputs *outputs, enum debug_layer layer) {
    switch (layer) {
    case DEBUG_GATHERED:
        return outputs->gathered;
    case DEBUG_VPL:
        return outputs->vpls;
    default:
        return outputs->val_views;
    }
}

bool debug_layers_check(const struct renderer *renderer, unsigned layers) {
    struct technique_outputs outputs = {0};
    renderer_outputs(renderer, &outputs);
    for (int i = 0; i < DEBUG_LAYER_COUNT; i++)
        if (layers >> i & 1 && !has(&outputs, (enum debug_layer)i))
            return error_set("layer '%s': technique '%s' has no %s", rows[i].name,
                             renderer->technique->name, rows[i].needs);
    return true;
}

/* --- drawn layers --- */

/* A blur of no radius puts the tiles in order. */
static bool draw_gathered(struct renderer *renderer, const struct frame *frame,
                          const struct layer_target *target) {
    struct technique_outputs outputs;
    struct blur_pass order;
    renderer_outputs(renderer, &outputs);
    if (!blur_pass_init(&order, &(struct blur_desc){.width = renderer->desc.width,
                                                    .height = renderer->desc.height,
                                                    .distance = 1}))
        return false;
    blur_pass_render(&order, frame, &renderer->gbuffer, outputs.gathered);
    struct composite_inputs inputs = renderer_composite_inputs(renderer);
    inputs.contribution.irradiance = &order.blurred;
    composite_pass_render_layer(&renderer->composite, frame, &inputs, LAYER_INDIRECT,
                                target->framebuffer);
    blur_pass_free(&order);
    return true;
}

static bool draw_val_light(const struct renderer *renderer, const struct frame *frame,
                           const struct layer_target *target) {
    struct technique_outputs outputs;
    struct val_light_pass pass;
    renderer_outputs(renderer, &outputs);
    if (!val_light_pass_init(&pass, outputs.visibility))
        return false;
    val_light_pass_render(&pass, frame, &renderer->gbuffer,
                          &(struct visibility_inputs){.views = outputs.val_views,
                                                      .depth = outputs.depth_maps,
                                                      .bases = outputs.basis_maps},
                          outputs.val_fluxes, target->framebuffer);
    val_light_pass_free(&pass);
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
    *depth = glm_vec3_dot(from_eye, (float *)view->forward);
    return true;
}

/* VPLs behind what the pixel shows are left out. */
static void add_vpls(const struct renderer *renderer, struct image *image) {
    struct technique_outputs outputs;
    renderer_outputs(renderer, &outputs);
    size_t bytes = (size_t)outputs.vpls->count * sizeof(struct vpl);
    struct vpl *vpls = mem_alloc(bytes, 1);
    buffer_read(&outputs.vpls->buffer, 0, bytes, vpls);
    int to = image_find_channel(image, "vpl.R"), z = image_find_channel(image, "Z");
    for (int i = 0; i < outputs.vpls->count; i++) {
        int pixel[2];
        float depth;
        if (vpls[i].emits <= 0 || !project(renderer, vpls[i].position, pixel, &depth))
            continue;
        float *channels = image_at(image, pixel[0], pixel[1]);
        if (fabsf(depth - channels[z]) < .01f * renderer->desc.geometry->radius)
            glm_vec3_add(channels + to, vpls[i].flux, channels + to);
    }
    free(vpls);
}

static bool draw_layers(struct renderer *renderer, unsigned layers, struct image *image,
                        const struct layer_target *target) {
    struct timers untimed = {0};
    struct frame frame = renderer_frame(renderer);
    frame.timers = &untimed;
    if (layers & 1U << DEBUG_GATHERED) {
        if (!draw_gathered(renderer, &frame, target))
            return false;
        layer_target_read(target, 0, 3, image, image_find_channel(image, "gathered.R"));
    }
    if (layers & (1U << DEBUG_VAL | 1U << DEBUG_VISIBILITY)) {
        if (!draw_val_light(renderer, &frame, target))
            return false;
        if (layers & 1U << DEBUG_VAL)
            layer_target_read(target, 0, 3, image, image_find_channel(image, "val.R"));
        if (layers & 1U << DEBUG_VISIBILITY)
            layer_target_read(target, 3, 1, image, image_find_channel(image, "visibility.Y"));
    }
    if (layers & 1U << DEBUG_VPL)
        add_vpls(renderer, image);
    return true;
}

bool debug_layers_append(struct renderer *renderer, unsigned layers, struct image *image) {
    if (!debug_layers_check(renderer, layers))
        return false;
    for (int i = 0; i < DEBUG_LAYER_COUNT; i++)
        if (layers >> i & 1)
            image_add_channels(image, rows[i].channels);
    struct layer_target target;
    if (!layer_target_init(&target, image->width, image->height))
        return false;
    bool ok = draw_layers(renderer, layers, image, &target);
    layer_target_free(&target);
    return ok;
}
