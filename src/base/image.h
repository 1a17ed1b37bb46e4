/* A picture in memory: floats in named channels, interleaved, row 0 at the top.
 *
 * Channel names follow OpenEXR: "R" "G" "B" "A" "Z" for the beauty layer, "indirect.R" for layers.
 */
#ifndef BASE_IMAGE_H
#define BASE_IMAGE_H

#include "base/memory.h"

#include <stdbool.h>
#include <stddef.h>

/* A rectangle of pixels, y down. */
struct image_window {
    int x, y, width, height;
};

/* What a file tells beside its pixels. Only EXR files get them, and image_read leaves them out. */
enum image_attribute_kind {
    IMAGE_TEXT,
    IMAGE_NUMBER,
    IMAGE_CHROMATICITIES, /* x and y of red, green, blue and white */
    IMAGE_MATRIX,         /* four rows of four, for row vectors */
};

struct image_attribute {
    const char *name; /* lives on */
    enum image_attribute_kind kind;
    char *text; /* of IMAGE_TEXT */
    float numbers[16];
};

struct image {
    int width, height, channel_count;
    char **names;  /* channel_count of them */
    float *pixels; /* height x width x channel_count */
    bool encoded;  /* sRGB over [0, 1], as integer formats store it; false = linear */
    char *passes;  /* of which it is the mean: "0..7,16"; NULL = not told */
    double weight; /* of them together */
    char *
        *parts; /* part_count names, with which channels' names begin: of an EXR of several parts */
    int part_count;
    struct image_attribute *attributes; /* attribute_count of them, to be written */
    int attribute_count;
    /* Of a file while it is read: x and y of its red, green, blue and white (IMAGE_CHROMATICITIES), and what 1 stands
     * for. Zeros are BT.709 and 1. */
    float primaries[8], unit;
    bool cube; /* of a file: faces of a cube, as its attribute says */
    /* Of a file: the whole picture, and where in it there are pixels. */
    struct image_window display, data;
};

/* An 8-bit RGBA picture, row 0 at the top: glTF textures, display-referred pictures. */
struct bitmap {
    int width, height;
    unsigned char *rgba; /* height x width x 4 */
};

/* Whether memory has room for such a picture; ask where the size comes from outside. Error: names
 * size and memory. */
bool image_fits(int width, int height, int channel_count);

/* Zero pixels; names as in "R G B direct.R direct.G direct.B". Sizes must be positive. */
void image_init(struct image *image, int width, int height, const char *channel_names);

/* The same with names that a file gives, which may be any text. */
void image_init_named(struct image *image, int width, int height, const char *const *names,
                      int count);

/* Of the same size, channels and pixels. */
struct image image_copy(const struct image *image);

/* Copies `count` channels of the image, under these names. */
struct image image_pick(const struct image *image, const int *channels, const char *const *names,
                        int count);

/* More channels, of zeros, after those that are there. */
void image_add_channels(struct image *image, const char *channel_names);

/* Adds an attribute of a name that the image does not have. The text is copied. */
void image_add_text(struct image *image, const char *name, const char *text);
void image_add_numbers(struct image *image, const char *name, enum image_attribute_kind kind,
                       const float *numbers);

/* Accepts zeroed structs. */
void image_free(struct image *image);
#define images_free(...) MEM_EACH(struct image, image_free, __VA_ARGS__)
void bitmap_free(struct bitmap *bitmap);
#define bitmaps_free(...) MEM_EACH(struct bitmap, bitmap_free, __VA_ARGS__)

static inline float *image_at(const struct image *image, int x, int y) {
    return image->pixels +
           ((size_t)y * (size_t)image->width + (size_t)x) * (size_t)image->channel_count;
}

/* The index of the channel, or -1. */
int image_find_channel(const struct image *image, const char *name);

/* The channels of a layer: R G B, red green blue, X Y Z, or one channel alone three times. The name is
 * whole (ViewLayer.Combined, a part), an end (Combined), or one channel (Z, normal.X). "" and "beauty"
 * take channels without a layer's name. Without these they take the layer or part that programs name so
 * (beauty, rgba, Combined ...), then the first part with R G B, then the only layer of three. Parts
 * named as normals and the like come last. Error: lists the layers there are. */
bool image_find_layer(const struct image *image, const char *layer, int channels[3]);

/* Multiplies R, G and B of each layer by the matrix, which is columns. Layers of normals, depths and the like stay.
 * Returns how many layers changed. */
int image_convert_colours(struct image *image, float matrix[3][3]);

/* A sentence of which layer that is, to be freed; NULL where it is the one named, or an unnamed
 * picture where none is. */
char *image_layer_note(const struct image *image, const char *layer);

/* The mean of three channels over all pixels. */
double image_mean(const struct image *image, const int channels[3]);

#endif
