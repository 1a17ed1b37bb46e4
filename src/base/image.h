/* A picture in memory: floats in named channels, interleaved, row 0 at the top.
 *
 * Channel names follow OpenEXR: "R" "G" "B" "A" "Z" for the beauty layer, "indirect.R"
 * for layers. Channels of "id." hold whole numbers below 2^24, which EXR stores as integers. */
#ifndef BASE_IMAGE_H
#define BASE_IMAGE_H

#include "base/memory.h"

#include <stdbool.h>
#include <stddef.h>

/* A rectangle of pixels, y down. */
struct image_window {
    int x, y, width, height;
};

/* Metadata of EXR files; other formats drop it. image_read keeps the names that this program writes
 * (is_kept in file/small/exr.c). */
enum image_attribute_kind {
    IMAGE_TEXT,
    IMAGE_NUMBER,
    IMAGE_CHROMATICITIES, /* x and y of red, green, blue and white */
    IMAGE_MATRIX,         /* four rows of four, for row vectors */
};

struct image_attribute {
    char *name; /* owned */
    enum image_attribute_kind kind;
    char *text; /* for IMAGE_TEXT, owned */
    float numbers[16];
};

struct image {
    int width, height, channel_count;
    char **names;  /* channel_count names */
    float *pixels; /* height x width x channel_count */
    bool encoded;  /* true: sRGB in [0, 1], as integer formats store it; false: linear */
    char *passes;  /* passes of which the picture is the mean: "0..7,16"; NULL: unknown */
    double weight; /* total weight of the passes */
    /* Names of the parts of a multi-part EXR, part_count of them. Names of channels begin with
     * them. */
    char **parts;
    int part_count;
    struct image_attribute *attributes; /* attribute_count attributes */
    int attribute_count;
    /* Set while a file is read: x and y of red, green, blue and white
     * (IMAGE_CHROMATICITIES), and the value that 1 stands for. Zeros: BT.709 and 1. */
    float primaries[8], unit;
    bool cube; /* the file's attribute says that it holds faces of a cube */
    /* Windows of the file: the whole picture, and the part with pixels. */
    struct image_window display, data;
};

/* An 8-bit RGBA picture, row 0 at the top: glTF textures, display-referred pictures. */
struct bitmap {
    int width, height;
    unsigned char *rgba; /* height x width x 4 */
};

/* Checks that memory has room for the picture; call it for sizes from outside. Error: names size
 * and memory. */
bool image_fits(int width, int height, int channel_count);

/* Makes a picture of zeros. channel_names: "R G B direct.R direct.G direct.B", separated by one
 * space. Sizes must be positive. */
void image_init(struct image *image, int width, int height, const char *channel_names);

/* Makes a picture of zeros with names from a file, which may be any text. */
void image_init_named(struct image *image, int width, int height, const char *const *names,
                      int count);

/* Returns a copy with size, channels and pixels, without metadata. */
struct image image_copy(const struct image *image);

/* Returns a picture with `count` channels of the image, under these names. */
struct image image_pick(const struct image *image, const int *channels, const char *const *names,
                        int count);

/* Appends channels of zeros. */
void image_add_channels(struct image *image, const char *channel_names);

/* Adds an attribute whose name the image does not have. Name and text are copied. */
void image_add_text(struct image *image, const char *name, const char *text);
void image_add_numbers(struct image *image, const char *name, enum image_attribute_kind kind,
                       const float *numbers);

/* Frees the members and zeroes the struct. Accepts zeroed structs. */
void image_free(struct image *image);
#define images_free(...) MEM_EACH(struct image, image_free, __VA_ARGS__)
void bitmap_free(struct bitmap *bitmap);
#define bitmaps_free(...) MEM_EACH(struct bitmap, bitmap_free, __VA_ARGS__)

/* Returns the channels of pixel x, y. */
static inline float *image_at(const struct image *image, int x, int y) {
    return image->pixels +
           ((size_t)y * (size_t)image->width + (size_t)x) * (size_t)image->channel_count;
}

/* Returns true for names of channels that hold whole numbers. */
bool image_channel_is_id(const char *name);

/* Returns the index of the channel, or -1. */
int image_find_channel(const struct image *image, const char *name);

/* Finds the three channels of a layer: R G B, red green blue, X Y Z, or one channel three times.
 * The name is whole (ViewLayer.Combined, a part), the end of a name (Combined), or one channel (Z,
 * normal.X). "" and "beauty" take channels without a layer name, else the layer or part with a
 * usual name (beauty, rgba, Combined ...). Without these they take the first part with R G B, then
 * the only layer of three. Parts named as normals and the like come last. Error: lists the
 * layers. */
bool image_find_layer(const struct image *image, const char *layer, int channels[3]);

/* Multiplies R, G and B of each layer by a matrix in columns. Layers of normals, depths and other
 * data stay. Returns the number of changed layers. */
int image_convert_colours(struct image *image, float matrix[3][3]);

/* Returns a sentence that names the layer found; the caller frees it. NULL if it is the named
 * layer, or the unnamed channels for an empty name. */
char *image_layer_note(const struct image *image, const char *layer);

/* Returns the mean of three channels over all pixels. */
double image_mean(const struct image *image, const int channels[3]);

#endif
