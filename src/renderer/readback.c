/* Pictures of the last frame, read back from the GPU. GL's row 0 is at the bottom, a file's at the
 * top. */
#include "renderer/renderer.h"

#include "base/memory.h"
#include "gl/framebuffer.h"
#include "shared/params.h"

#include <stdlib.h>
#include <string.h>

static const struct layer_row {
    int layer;
    const char *channels; /* one character each */
    const char *prefix;
} layer_rows[] = {
    {LAYER_BEAUTY, "RGBA", ""},       {LAYER_DEPTH, "Z", ""},
    {LAYER_DIRECT, "RGB", "direct."}, {LAYER_INDIRECT, "RGB", "indirect."},
    {LAYER_ALBEDO, "RGB", "albedo."}, {LAYER_NORMAL, "XYZ", "normal."},
};

enum { LAYER_ROWS = sizeof layer_rows / sizeof *layer_rows };

static void copy_channels(struct image *image, const float *rgba, int first, int count) {
    for (int y = 0; y < image->height; y++) {
        const float *from = rgba + (size_t)(image->height - 1 - y) * (size_t)image->width * 4;
        for (int x = 0; x < image->width; x++)
            memcpy(image_at(image, x, y) + first, from + (size_t)x * 4,
                   (size_t)count * sizeof(float));
    }
}

static void read_layers(struct renderer *renderer, struct image *image,
                        const struct texture *target, GLuint framebuffer) {
    struct timers untimed = {0};
    struct frame frame = renderer_frame(renderer);
    frame.timers = &untimed;
    struct composite_inputs inputs = renderer_composite_inputs(renderer);
    size_t bytes = (size_t)image->width * (size_t)image->height * 4 * sizeof(float);
    float *rgba = mem_alloc(bytes, 1);
    int first = 0;
    for (int i = 0; i < LAYER_ROWS; i++) {
        composite_pass_render_layer(&renderer->composite, &frame, &inputs, layer_rows[i].layer,
                                    framebuffer);
        gl.GetTextureImage(target->id, 0, GL_RGBA, GL_FLOAT, (GLsizei)bytes, rgba);
        int count = (int)strlen(layer_rows[i].channels);
        copy_channels(image, rgba, first, count);
        first += count;
    }
    free(rgba);
}

bool renderer_read_layers(struct renderer *renderer, struct image *image) {
    int width = renderer->desc.width, height = renderer->desc.height;
    char names[512] = "";
    for (int i = 0; i < LAYER_ROWS; i++)
        for (const char *c = layer_rows[i].channels; *c; c++) {
            size_t used = strlen(names);
            snprintf(names + used, sizeof names - used, "%s%s%c", used ? " " : "",
                     layer_rows[i].prefix, *c);
        }
    struct texture target;
    GLuint framebuffer = 0;
    if (!texture_init(
            &target, &(struct texture_desc){
                         .label = "layer", .format = GL_RGBA32F, .width = width, .height = height}))
        return false;
    bool ok = framebuffer_init(&framebuffer,
                               &(struct framebuffer_desc){.label = "layer", .colors = {&target}});
    if (ok) {
        image_init(image, width, height, names);
        renderer_bind_frame(renderer);
        read_layers(renderer, image, &target, framebuffer);
    }
    framebuffer_free(&framebuffer);
    texture_free(&target);
    return ok;
}

void renderer_read_display(const struct renderer *renderer, struct bitmap *bitmap) {
    int width = renderer->desc.width, height = renderer->desc.height;
    size_t row = (size_t)width * 4, bytes = row * (size_t)height;
    *bitmap = (struct bitmap){.width = width, .height = height, .rgba = mem_alloc(bytes, 1)};
    unsigned char *flipped = mem_alloc(bytes, 1);
    gl.GetTextureImage(renderer->composite.display.id, 0, GL_RGBA, GL_UNSIGNED_BYTE, (GLsizei)bytes,
                       flipped);
    for (int y = 0; y < height; y++)
        memcpy(bitmap->rgba + (size_t)y * row, flipped + (size_t)(height - 1 - y) * row, row);
    free(flipped);
}
