#include "apps/report/embedded.h"

#include "base/file/image_file.h"
#include "base/memory.h"
#include "metrics/colour.h"
#include "metrics/heat_map.h"
#include "metrics/layer.h"

#include <math.h>
#include <stdlib.h>

static void print_base64(FILE *out, const char *bytes, size_t size) {
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < size; i += 3) {
        unsigned left = (unsigned)(size - i < 3 ? size - i : 3), bits = 0;
        for (unsigned k = 0; k < 3; k++)
            bits = bits << 8 | (k < left ? (unsigned char)bytes[i + k] : 0u);
        for (unsigned k = 0; k < 4; k++)
            fputc(k <= left ? digits[bits >> (18 - 6 * k) & 63] : '=', out);
    }
}

/* "data:image/png;base64,...". Error: of the encoder. */
static bool print_bitmap(FILE *out, const struct bitmap *bitmap) {
    struct text bytes = {0};
    bool ok = bitmap_encode(bitmap, &bytes);
    fprintf(out, "data:image/png;base64,");
    print_base64(out, bytes.data, ok ? bytes.length : 0);
    free(bytes.data);
    return ok;
}

bool embedded_print_picture(FILE *out, const struct image *picture) {
    struct image layer;
    if (!layer_extract(&layer, picture, "beauty"))
        return false;
    struct bitmap bitmap = {.width = layer.width, .height = layer.height};
    size_t count = (size_t)layer.width * (size_t)layer.height;
    bitmap.rgba = mem_alloc(count, 4);
    for (size_t i = 0; i < count; i++) {
        for (size_t c = 0; c < 3; c++)
            bitmap.rgba[4 * i + c] =
                (unsigned char)lrintf(255 * srgb_encode(layer.pixels[3 * i + c]));
        bitmap.rgba[4 * i + 3] = 255;
    }
    bool ok = print_bitmap(out, &bitmap);
    bitmap_free(&bitmap);
    image_free(&layer);
    return ok;
}

static bool print_layers_difference(FILE *out, const struct image *a, const struct image *b,
                                    double top) {
    size_t count = (size_t)a->width * (size_t)a->height;
    double mean = image_mean(b, (int[]){0, 1, 2});
    float *values = mem_alloc(count, sizeof *values);
    for (size_t i = 0; i < count; i++)
        for (size_t c = 0; c < 3; c++)
            values[i] += (a->pixels[3 * i + c] - b->pixels[3 * i + c]) / 3;
    struct bitmap bitmap;
    heat_map_draw_values(&(struct heat_map){.title = "",
                                            .width = a->width,
                                            .height = a->height,
                                            .values = values,
                                            .top = (float)(mean > 0 ? top * mean : top),
                                            .is_signed = true},
                         &bitmap);
    bool ok = print_bitmap(out, &bitmap);
    bitmap_free(&bitmap);
    free(values);
    return ok;
}

bool embedded_print_difference(FILE *out, const struct image *picture,
                               const struct image *reference, double top) {
    struct image a, b = {0};
    bool ok = layer_extract(&a, picture, "beauty") && layer_extract(&b, reference, "beauty") &&
              print_layers_difference(out, &a, &b, top);
    images_free(&a, &b);
    return ok;
}
