#include "viewer/picture/reference.h"

#include "base/error.h"
#include "base/file/image_file.h"
#include "base/log.h"
#include "base/memory.h"
#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "gl/program.h"
#include "metrics/layer.h"
#include "passes/picture/composite.h"
#include "shared/composite.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool init_gpu(struct reference *reference) {
    int width = reference->picture.width, height = reference->picture.height;
    return program_init(&reference->program,
                        &(struct program_desc){.screen = {"passes/picture/reference.frag"}}) &&
           texture_init(&reference->radiance, &(struct texture_desc){.label = "reference",
                                                                     .format = GL_RGBA32F,
                                                                     .width = width,
                                                                     .height = height}) &&
           framebuffer_init_target(&reference->display, &reference->framebuffer,
                                   &(struct texture_desc){.label = "reference display",
                                                          .format = GL_RGBA8,
                                                          .width = width,
                                                          .height = height}) &&
           buffer_init(&reference->params, "reference parameters", sizeof(struct composite_params),
                       NULL);
}

/* GL's row 0 is at the bottom. */
static void upload(struct reference *reference) {
    const struct image *layer = &reference->layer;
    size_t row = (size_t)layer->width * 3;
    float *flipped = mem_alloc(row * (size_t)layer->height, sizeof *flipped);
    for (int y = 0; y < layer->height; y++)
        memcpy(flipped + (size_t)y * row, image_at(layer, 0, layer->height - 1 - y),
               row * sizeof *flipped);
    gl.TextureSubImage2D(reference->radiance.id, 0, 0, 0, layer->width, layer->height, GL_RGB,
                         GL_FLOAT, flipped);
    free(flipped);
}

static bool pick_layer(struct reference *reference, const char *name) {
    struct image layer;
    if (!layer_extract(&layer, &reference->picture, name) &&
        !layer_extract(&layer, &reference->picture, ""))
        return false;
    image_free(&reference->layer);
    reference->layer = layer;
    snprintf(reference->layer_name, sizeof reference->layer_name, "%s", name);
    upload(reference);
    return true;
}

/* Of the same size, and the same layer of it: what the GPU has is filled anew. */
static bool replace(struct reference *reference, struct image *picture) {
    image_free(&reference->picture);
    reference->picture = *picture;
    char layer[sizeof reference->layer_name];
    memcpy(layer, reference->layer_name, sizeof layer);
    return pick_layer(reference, layer);
}

bool reference_take(struct reference *reference, struct image *picture) {
    struct reference fresh = {.picture = *picture};
    const struct image *before = &reference->picture;
    if (reference->framebuffer && before->width == picture->width &&
        before->height == picture->height)
        return replace(reference, picture);
    if (init_gpu(&fresh) && pick_layer(&fresh, "")) {
        reference_free(reference);
        *reference = fresh;
        return true;
    }
    reference_free(&fresh);
    return false;
}

bool reference_load(struct reference *reference, const char *path) {
    struct image picture = {0};
    if (!image_read(&picture, path))
        return false;
    char *note = image_layer_note(&picture, "");
    bool ok = reference_take(reference, &picture) || error_prefix("%s", path);
    if (ok && note)
        log_note("%s: %s", path, note);
    free(note);
    return ok;
}

void reference_free(struct reference *reference) {
    images_free(&reference->picture, &reference->layer);
    program_free(&reference->program);
    framebuffer_free(&reference->framebuffer);
    textures_free(&reference->radiance, &reference->display);
    buffer_free(&reference->params);
    *reference = (struct reference){0};
}

bool reference_show(struct reference *reference, const char *layer,
                    const struct settings *settings) {
    const struct picture_settings *picture =
        settings_of(struct picture_settings, settings, &picture_part);
    if (strcmp(layer, reference->layer_name) != 0 && !pick_layer(reference, layer))
        return false;
    struct composite_params params = {
        .exposure = exp2f(picture->exposure),
        .filmic = picture->tone_map == TONE_MAP_FILMIC,
    };
    buffer_write(&reference->params, 0, sizeof params, &params);
    pass_set_state(&(struct pass_state){
        .name = "reference",
        .program = reference->program,
        .framebuffer = reference->framebuffer,
        .width = reference->display.desc.width,
        .height = reference->display.desc.height,
        .textures = {{UNIT_RADIANCE, reference->radiance.id}},
        .blocks = {{BLOCK_PASS, &reference->params}},
    });
    pass_draw_fullscreen(1);
    return true;
}
