#include "base/image.h"

#include "base/error.h"
#include "base/memory.h"

#include <assert.h>
#include <string.h>

static void add_name(struct image *image, const char *name, size_t length) {
    int i = image->channel_count++;
    image->names = mem_resize(image->names, (size_t)image->channel_count, sizeof *image->names);
    image->names[i] = mem_printf("%.*s", (int)length, name);
}

static void add_names(struct image *image, const char *channel_names) {
    for (const char *name = channel_names; *name;) {
        size_t length = strcspn(name, " ");
        assert(length > 0);
        add_name(image, name, length);
        name += length + (name[length] == ' ');
    }
}

/* Room for the channels that have been named since there were old_count. */
static void grow_pixels(struct image *image, int old_count) {
    size_t old = (size_t)old_count, count = (size_t)image->channel_count;
    size_t pixel_count = (size_t)image->width * (size_t)image->height;
    float *pixels = mem_alloc(pixel_count * count, sizeof *pixels);
    for (size_t i = 0; i < pixel_count && old; i++)
        memcpy(pixels + i * count, image->pixels + i * old, old * sizeof *pixels);
    free(image->pixels);
    image->pixels = pixels;
}

bool image_fits(int width, int height, int channel_count) {
    uint64_t pixels = (uint64_t)width * (uint64_t)height;
    uint64_t of_pixel = (uint64_t)channel_count * sizeof(float);
    return mem_check(pixels > UINT64_MAX / of_pixel ? UINT64_MAX : pixels * of_pixel) ||
           error_prefix("a picture of %dx%d with %d channels", width, height, channel_count);
}

void image_init(struct image *image, int width, int height, const char *channel_names) {
    assert(width > 0 && height > 0);
    *image = (struct image){.width = width, .height = height};
    image_add_channels(image, channel_names);
}

void image_init_named(struct image *image, int width, int height, const char *const *names,
                      int count) {
    assert(width > 0 && height > 0);
    *image = (struct image){.width = width, .height = height};
    for (int i = 0; i < count; i++)
        add_name(image, names[i], strlen(names[i]));
    grow_pixels(image, 0);
}

struct image image_copy(const struct image *image) {
    struct image copy;
    image_init_named(&copy, image->width, image->height, (const char *const *)image->names,
                     image->channel_count);
    memcpy(copy.pixels, image->pixels,
           sizeof *image->pixels * (size_t)image->width * (size_t)image->height *
               (size_t)image->channel_count);
    return copy;
}

struct image image_pick(const struct image *image, const int *channels, const char *const *names,
                        int count) {
    struct image picked;
    image_init_named(&picked, image->width, image->height, names, count);
    size_t pixels = (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; i < pixels; i++)
        for (int c = 0; c < count; c++)
            picked.pixels[i * (size_t)count + (size_t)c] =
                image->pixels[i * (size_t)image->channel_count + (size_t)channels[c]];
    return picked;
}

void image_add_channels(struct image *image, const char *channel_names) {
    int old_count = image->channel_count;
    add_names(image, channel_names);
    grow_pixels(image, old_count);
}

static struct image_attribute *add_attribute(struct image *image, const char *name,
                                             enum image_attribute_kind kind) {
    size_t count = (size_t)++image->attribute_count;
    image->attributes = mem_resize(image->attributes, count, sizeof *image->attributes);
    struct image_attribute *attribute = image->attributes + count - 1;
    *attribute = (struct image_attribute){.name = mem_strdup(name), .kind = kind};
    return attribute;
}

void image_add_text(struct image *image, const char *name, const char *text) {
    add_attribute(image, name, IMAGE_TEXT)->text = mem_strdup(text);
}

void image_add_numbers(struct image *image, const char *name, enum image_attribute_kind kind,
                       const float *numbers) {
    static const size_t counts[] = {
        [IMAGE_NUMBER] = 1, [IMAGE_CHROMATICITIES] = 8, [IMAGE_MATRIX] = 16};
    memcpy(add_attribute(image, name, kind)->numbers, numbers, counts[kind] * sizeof *numbers);
}

void image_free(struct image *image) {
    for (int i = 0; i < image->attribute_count; i++)
        mem_free(image->attributes[i].name, image->attributes[i].text);
    free(image->attributes);
    for (int i = 0; i < image->channel_count; i++)
        free(image->names[i]);
    mem_free(image->names, image->pixels, image->passes);
    for (int i = 0; i < image->part_count; i++)
        free(image->parts[i]);
    free(image->parts);
    *image = (struct image){0};
}

void bitmap_free(struct bitmap *bitmap) {
    free(bitmap->rgba);
    *bitmap = (struct bitmap){0};
}

bool image_channel_is_id(const char *name) {
    return strncmp(name, "id.", 3) == 0;
}

int image_find_channel(const struct image *image, const char *name) {
    for (int i = 0; i < image->channel_count; i++)
        if (strcmp(image->names[i], name) == 0)
            return i;
    return -1;
}

double image_mean(const struct image *image, const int channels[3]) {
    double sum = 0;
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++)
            for (int c = 0; c < 3; c++)
                sum += (double)image_at(image, x, y)[channels[c]];
    return sum / (3. * image->width * image->height);
}
