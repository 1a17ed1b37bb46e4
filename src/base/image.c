#include "base/image.h"

#include "base/error.h"
#include "base/memory.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void add_names(struct image *image, const char *channel_names) {
    for (const char *name = channel_names; *name;) {
        size_t length = strcspn(name, " ");
        assert(length > 0 && length < IMAGE_NAME_SIZE);
        int i = image->channel_count++;
        image->names = mem_resize(image->names, (size_t)image->channel_count, sizeof *image->names);
        memset(image->names[i], 0, IMAGE_NAME_SIZE);
        memcpy(image->names[i], name, length);
        name += length + (name[length] == ' ');
    }
}

void image_init(struct image *image, int width, int height, const char *channel_names) {
    assert(width > 0 && height > 0);
    *image = (struct image){.width = width, .height = height};
    image_add_channels(image, channel_names);
}

void image_add_channels(struct image *image, const char *channel_names) {
    size_t old_count = (size_t)image->channel_count;
    size_t pixel_count = (size_t)image->width * (size_t)image->height;
    add_names(image, channel_names);
    size_t count = (size_t)image->channel_count;
    float *pixels = mem_alloc(pixel_count * count, sizeof *pixels);
    for (size_t i = 0; i < pixel_count && old_count; i++)
        memcpy(pixels + i * count, image->pixels + i * old_count, old_count * sizeof *pixels);
    free(image->pixels);
    image->pixels = pixels;
}

void image_free(struct image *image) {
    free(image->names);
    free(image->pixels);
    *image = (struct image){0};
}

void bitmap_free(struct bitmap *bitmap) {
    free(bitmap->rgba);
    *bitmap = (struct bitmap){0};
}

int image_find_channel(const struct image *image, const char *name) {
    for (int i = 0; i < image->channel_count; i++)
        if (strcmp(image->names[i], name) == 0)
            return i;
    return -1;
}

static void list_layers(const struct image *image, char *list, size_t size) {
    size_t used = 0;
    list[0] = '\0';
    for (int i = 0; i < image->channel_count && used < size; i++) {
        const char *name = image->names[i], *dot = strrchr(name, '.');
        bool is_red = strcmp(dot ? dot + 1 : name, "R") == 0;
        if (is_red)
            used += (size_t)snprintf(list + used, size - used, " %.*s", dot ? (int)(dot - name) : 6,
                                     dot ? name : "beauty");
    }
}

bool image_find_layer(const struct image *image, const char *layer, int channels[3]) {
    bool beauty = layer[0] == '\0' || strcmp(layer, "beauty") == 0;
    for (int i = 0; i < 3; i++) {
        char name[2 * IMAGE_NAME_SIZE];
        snprintf(name, sizeof name, "%.31s%s%c", beauty ? "" : layer, beauty ? "" : ".", "RGB"[i]);
        channels[i] = image_find_channel(image, name);
        if (channels[i] < 0 && beauty)
            channels[i] = image_find_channel(image, "Y");
        if (channels[i] < 0) {
            char list[512];
            list_layers(image, list, sizeof list);
            return error_set("no layer '%s' (there is:%s)", beauty ? "beauty" : layer, list);
        }
    }
    return true;
}
