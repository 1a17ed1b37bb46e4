#include "library/image.h"

#include "base/error.h"
#include "base/file/image_file.h"
#include "base/file/piped_file.h"
#include "base/memory.h"
#include "library/desc.h"
#include "library/door.h"
#include "metrics/layer.h"
#include "metrics/metric.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct manylight_image {
    struct image image;
};

struct manylight_image *image_wrap(const struct image *image) {
    struct manylight_image *wrapped = mem_alloc(1, sizeof *wrapped);
    wrapped->image = *image;
    return wrapped;
}

static bool refuse(const char *reason) {
    error_set("%s", reason);
    return door_blame(MANYLIGHT_BAD_ARGUMENT);
}

/* --- making and writing ----------------------------------------------------------------------- */

/* Names with one space between, none at the ends. */
static bool channels_are_good(const char *channels) {
    size_t length = channels ? strlen(channels) : 0;
    return length > 0 && channels[0] != ' ' && channels[length - 1] != ' ' &&
           !strstr(channels, "  ");
}

static bool create(int width, int height, const char *channels, const float *pixels,
                   struct manylight_image **out) {
    struct image image;
    int count = 1;
    if (width < 1 || height < 1 || width > 1 << 20 || height > 1 << 20)
        return refuse("image: a side is not from 1 to 1048576 pixels");
    if (!channels_are_good(channels) || !pixels)
        return refuse("image: it has no pixels, or channels are not names with a space between");
    for (const char *c = channels; *c; c++)
        count += *c == ' ';
    if (!image_fits(width, height, count))
        return false;
    image_init(&image, width, height, channels);
    memcpy(image.pixels, pixels, (size_t)width * (size_t)height * (size_t)count * sizeof *pixels);
    *out = image_wrap(&image);
    return true;
}

enum manylight_status manylight_image_create(int width, int height, const char *channels,
                                             const float *pixels, struct manylight_image **image) {
    struct door door;
    *image = NULL;
    door_enter(&door);
    return door_leave(&door, create(width, height, channels, pixels, image),
                      MANYLIGHT_BAD_ARGUMENT);
}

static bool read_file(const char *path, struct manylight_image **out) {
    struct image image;
    if (piped_file_is(path))
        return refuse("image: it is a pipe, which the library does not read");
    if (!image_read(&image, path))
        return false;
    *out = image_wrap(&image);
    return true;
}

enum manylight_status manylight_image_read(const char *path, struct manylight_image **image) {
    struct door door;
    *image = NULL;
    door_enter(&door);
    return door_leave(&door, read_file(path, image), MANYLIGHT_FAILED);
}

static bool write_file(const struct image *image, const char *path) {
    bool is_float;
    if (piped_file_is(path))
        return refuse("image: the path is a stream, which the library does not write");
    if (!image_format_is_float(path, &is_float)) {
        error_set("%s: its ending is that of no format; .exr, .pfm and .hdr hold floats", path);
        return door_blame(MANYLIGHT_BAD_ARGUMENT);
    }
    if (!is_float) {
        error_set("%s: its format is for displays; .exr and .pfm hold floats", path);
        return door_blame(MANYLIGHT_BAD_ARGUMENT);
    }
    return image_write(image, path);
}

enum manylight_status manylight_image_write(const struct manylight_image *image, const char *path) {
    struct door door;
    door_enter(&door);
    return door_leave(&door, write_file(&image->image, path), MANYLIGHT_FAILED);
}

void manylight_image_free(struct manylight_image *image) {
    if (!image)
        return;
    image_free(&image->image);
    free(image);
}

/* --- looking ---------------------------------------------------------------------------------- */

int manylight_image_width(const struct manylight_image *image) {
    return image->image.width;
}

int manylight_image_height(const struct manylight_image *image) {
    return image->image.height;
}

int manylight_image_channel_count(const struct manylight_image *image) {
    return image->image.channel_count;
}

const char *manylight_image_channel(const struct manylight_image *image, int n) {
    return n >= 0 && n < image->image.channel_count ? image->image.names[n] : NULL;
}

const float *manylight_image_pixels(const struct manylight_image *image) {
    return image->image.pixels;
}

enum { LAYER_CHANNELS_MAX = 4 };

/* Whether a channel's name is the layer's and one more, "direct.R" of "direct"; of the beauty R G B
 * A. */
static bool is_of_layer(const char *name, const char *layer) {
    size_t length = strlen(layer);
    if (!*layer)
        return strlen(name) == 1 && strchr("RGBA", *name);
    return strcmp(name, layer) == 0 || (strncmp(name, layer, length) == 0 && name[length] == '.' &&
                                        !strchr(name + length + 1, '.'));
}

static bool refuse_layer(const struct image *image, const char *layer) {
    char names[1024] = "";
    size_t used = 0;
    for (int i = 0; i < image->channel_count && used < sizeof names; i++)
        used += (size_t)snprintf(names + used, sizeof names - used, " %s", image->names[i]);
    error_set("no layer is called '%s' (channels are:%s)", layer, names);
    return door_blame(MANYLIGHT_BAD_ARGUMENT);
}

/* R or r before G, X before Y, A last; other letters before them. */
static long rank_of(const char *name) {
    static const char order[] = "XYZRGBA";
    const char *found = strchr(order, toupper((unsigned char)name[strlen(name) - 1]));
    return found ? found - order : -1;
}

static int find_layer(const struct image *image, const char *layer, int found[LAYER_CHANNELS_MAX]) {
    int count = 0;
    for (int i = 0; i < image->channel_count && count < LAYER_CHANNELS_MAX; i++) {
        int at = count;
        if (!is_of_layer(image->names[i], layer))
            continue;
        for (; at > 0 && rank_of(image->names[found[at - 1]]) > rank_of(image->names[i]); at--)
            found[at] = found[at - 1];
        found[at] = i;
        count++;
    }
    return count;
}

static bool copy_layer(const struct image *image, const char *layer, float *pixels, size_t room,
                       int *channels) {
    int from[LAYER_CHANNELS_MAX];
    const char *name = !layer || strcmp(layer, "beauty") == 0 ? "" : layer;
    int count = find_layer(image, name, from);
    size_t pixel_count = (size_t)image->width * (size_t)image->height;
    if (count == 0)
        return refuse_layer(image, layer ? layer : "beauty");
    if (channels)
        *channels = count;
    if (!pixels)
        return true;
    if (room < pixel_count * (size_t)count) {
        error_set("layer: %dx%dx%d floats have no room in %zu", image->height, image->width, count,
                  room);
        return door_blame(MANYLIGHT_BAD_ARGUMENT);
    }
    for (size_t i = 0; i < pixel_count; i++)
        for (int c = 0; c < count; c++)
            *pixels++ = image->pixels[i * (size_t)image->channel_count + (size_t)from[c]];
    return true;
}

enum manylight_status manylight_image_layer(const struct manylight_image *image, const char *layer,
                                            float *pixels, size_t count, int *channels) {
    struct door door;
    door_enter(&door);
    return door_leave(&door, copy_layer(&image->image, layer, pixels, count, channels),
                      MANYLIGHT_BAD_ARGUMENT);
}

/* --- comparing -------------------------------------------------------------------------------- */

static bool measure(const struct image *test, const struct image *reference,
                    const struct manylight_compare_desc *desc, double *value, float *map) {
    const struct metric *metric = metric_find(desc->metric ? desc->metric : "relative-rmse");
    if (!metric)
        return false;
    if (test->width != reference->width || test->height != reference->height)
        return error_set("test is %dx%d, but reference is %dx%d", test->width, test->height,
                         reference->width, reference->height);
    const struct comparison comparison = {
        .test = test,
        .reference = reference,
        .pixels_per_degree = desc->pixels_per_degree > 0 ? desc->pixels_per_degree
                                                         : (float)DEFAULT_PIXELS_PER_DEGREE,
        .threads = desc->threads};
    *value = metric_measure(metric, &comparison, map);
    return true;
}

static bool compare(const struct image *test, const struct image *reference,
                    const struct manylight_compare_desc *given, double *value, float *map) {
    struct manylight_compare_desc desc;
    struct image layer = {0}, of_reference = {0};
    if (!desc_take(&desc, sizeof desc, given, "manylight_compare_desc"))
        return false;
    const char *name = desc.layer ? desc.layer : "beauty";
    bool ok = (layer_extract(&layer, test, name) || error_prefix("test")) &&
              (layer_extract(&of_reference, reference,
                             desc.reference_layer ? desc.reference_layer : name) ||
               error_prefix("reference")) &&
              measure(&layer, &of_reference, &desc, value, map);
    images_free(&layer, &of_reference);
    return ok;
}

enum manylight_status manylight_compare(const struct manylight_image *test,
                                        const struct manylight_image *reference,
                                        const struct manylight_compare_desc *desc, double *value,
                                        float *map) {
    struct door door;
    door_enter(&door);
    return door_leave(&door, compare(&test->image, &reference->image, desc, value, map),
                      MANYLIGHT_BAD_ARGUMENT);
}
