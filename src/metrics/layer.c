#include "metrics/layer.h"

#include "base/error.h"
#include "base/file/piped_file.h"
#include "metrics/colour.h"

#include <math.h>
#include <string.h>

static bool check_finite(const struct image *picture, const int channels[3]) {
    for (int y = 0; y < picture->height; y++)
        for (int x = 0; x < picture->width; x++)
            for (int c = 0; c < 3; c++) {
                double value = (double)image_at(picture, x, y)[channels[c]];
                if (!isfinite(value))
                    return error_set("%s is %f at pixel %d,%d", picture->names[channels[c]], value,
                                     x, y);
            }
    return true;
}

/* Alpha, which may be asked for by its name, is never encoded. */
static bool extract(struct image *layer, const struct image *picture, const int channels[3]) {
    if (!check_finite(picture, channels) || !image_fits(picture->width, picture->height, 3))
        return false;
    bool decoded = picture->encoded && strcmp(picture->names[channels[0]], "A") != 0;
    image_init(layer, picture->width, picture->height, "R G B");
    for (int y = 0; y < picture->height; y++)
        for (int x = 0; x < picture->width; x++)
            for (int c = 0; c < 3; c++) {
                float value = image_at(picture, x, y)[channels[c]];
                image_at(layer, x, y)[c] = decoded ? srgb_decode(value) : value;
            }
    return true;
}

bool layer_extract(struct image *layer, const struct image *picture, const char *name) {
    int channels[3];
    *layer = (struct image){0};
    return image_find_layer(picture, name, channels) && extract(layer, picture, channels);
}

bool layer_extract_covered(struct image *layer, const struct image *picture, const char *name,
                           const struct image *coverage) {
    int alpha = image_find_channel(coverage, "A");
    *layer = (struct image){0};
    if (alpha < 0)
        return error_set("no channel A tells what surfaces cover");
    if (!layer_extract(layer, picture, name))
        return false;
    for (int y = 0; y < layer->height; y++)
        for (int x = 0; x < layer->width; x++)
            for (int c = 0; c < 3; c++)
                image_at(layer, x, y)[c] *= image_at(coverage, x, y)[alpha];
    return true;
}

bool layer_read(struct image *layer, const char *path, const char *name, bool *was_encoded) {
    *layer = (struct image){0};
    struct image picture;
    int channels[3];
    if (!piped_image_read_layer(&picture, path, name, channels))
        return false;
    bool ok = extract(layer, &picture, channels) || error_prefix("%s", path);
    *was_encoded = picture.encoded;
    layer->display = picture.display;
    layer->data = picture.data;
    image_free(&picture);
    return ok;
}
