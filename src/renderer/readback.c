/* The picture, read back from the GPU. */
#include "renderer/renderer.h"

#include "gl/context/context.h"
#include "passes/frame.h"
#include "renderer/layer_target.h"
#include "shared/composite.h"

#include <stdlib.h>
#include <string.h>

static const struct layer_row {
    int layer;
    const char *channels; /* one character each */
    const char *prefix;
} layer_rows[] = {
    {LAYER_BEAUTY, "RGBA", ""},
    {LAYER_DEPTH, "Z", ""},
    {LAYER_DIRECT, "RGB", "direct."},
    {LAYER_INDIRECT, "RGB", "indirect."},
    {LAYER_ALBEDO, "RGB", "albedo."},
    {LAYER_NORMAL, "XYZ", "normal."},
    /* Where the G-buffer has a specular target: */
    {LAYER_SPECULAR, "RGB", "specular."},
    {LAYER_DIRECT_SPECULAR, "RGB", "direct.specular."},
    {LAYER_INDIRECT_SPECULAR, "RGB", "indirect.specular."},
    /* Where there is a medium: */
    {LAYER_AIRLIGHT, "RGB", "airlight."},
    /* Where the settings ask for caustics: */
    {LAYER_CAUSTIC, "RGB", "caustic."},
    {LAYER_VOLUME, "RGB", "volume."},
};

enum { ROWS = sizeof layer_rows / sizeof *layer_rows };

/* layers: bits 1 << LAYER_... of the wanted layers. */
static bool has_row(const struct renderer *renderer, int row, unsigned layers) {
    int layer = layer_rows[row].layer;
    if (!(layers >> layer & 1))
        return false;
    switch (layer) {
    case LAYER_AIRLIGHT:
        return renderer->airlight.pass.in_scatter.id != 0;
    case LAYER_CAUSTIC:
        return renderer->caustics.surface != NULL;
    case LAYER_VOLUME:
        return renderer->caustics.volume != NULL;
    default:
        return layer < LAYERS_PLAIN || renderer->gbuffer.specular.id != 0;
    }
}

unsigned renderer_layer_bit(const struct renderer *renderer, const char *name) {
    size_t length = strlen(name);
    for (int i = 0; i < ROWS; i++) {
        int layer = layer_rows[i].layer;
        const char *prefix = layer_rows[i].prefix;
        const char *plain = layer == LAYER_BEAUTY ? "beauty" : layer == LAYER_DEPTH ? "Z" : NULL;
        if ((plain ? strcmp(name, plain) == 0
                   : strncmp(prefix, name, length) == 0 && strcmp(prefix + length, ".") == 0) &&
            has_row(renderer, i, ~0U))
            return 1U << layer;
    }
    return 0;
}

static void read_layers(struct renderer *renderer, unsigned layers, struct image *image,
                        const struct layer_target *target) {
    struct timers untimed = {0};
    struct frame frame = renderer_frame(renderer);
    frame.timers = &untimed;
    struct composite_inputs inputs = renderer_composite_inputs(renderer);
    const struct refining *refining = &renderer->refining;
    int channel = 0;
    for (int i = 0; i < ROWS; i++) {
        if (!has_row(renderer, i, layers))
            continue;
        int count = (int)strlen(layer_rows[i].channels);
        if (refining->count > 0)
            mean_pass_render_layer(&refining->mean, &frame, refining->weight, layer_rows[i].layer,
                                   target->framebuffer);
        else
            composite_pass_render_layer(&renderer->composite, &frame, &inputs, layer_rows[i].layer,
                                        target->framebuffer);
        layer_target_read(target, 0, count, image, channel);
        channel += count;
    }
}

/* The image is the part of the picture from x y on, of that size. */
static bool read_part(struct renderer *renderer, unsigned layers, int x, int y, int width,
                      int height, struct image *image) {
    char names[512] = "";
    int count = 0;
    for (int i = 0; i < ROWS; i++)
        for (const char *c = layer_rows[i].channels; has_row(renderer, i, layers) && *c;
             c++, count++) {
            size_t used = strlen(names);
            snprintf(names + used, sizeof names - used, "%s%s%c", used ? " " : "",
                     layer_rows[i].prefix, *c);
        }
    struct layer_target target;
    if (!image_fits(width, height, count) ||
        !layer_target_init(&target, renderer->desc.width, renderer->desc.height))
        return false;
    target.x = x;
    target.y = y;
    image_init(image, width, height, names);
    read_layers(renderer, layers, image, &target);
    layer_target_free(&target);
    if (context_check())
        return true;
    image_free(image);
    return false;
}

bool renderer_read_some(struct renderer *renderer, unsigned layers, struct image *image) {
    return read_part(renderer, layers, 0, 0, renderer->desc.width, renderer->desc.height, image);
}

bool renderer_read_layers(struct renderer *renderer, struct image *image) {
    return renderer_read_some(renderer, ~0U, image);
}

bool renderer_read_pixel(struct renderer *renderer, int x, int y, struct image *image) {
    return read_part(renderer, ~0U, x, y, 1, 1, image);
}

bool renderer_read_display(const struct renderer *renderer, struct bitmap *bitmap) {
    texture_read_bitmap(&renderer->composite.display, bitmap);
    if (context_check())
        return true;
    bitmap_free(bitmap);
    return false;
}
