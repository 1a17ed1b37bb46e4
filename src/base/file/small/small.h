/* Parts of the picture bridge that starts quickly, for it needs no OpenImageIO. Each library is named by one file.
 *
 * Errors carry no path: image_file.c puts it in front. */
#ifndef BASE_FILE_SMALL_SMALL_H
#define BASE_FILE_SMALL_SMALL_H

#include "base/image.h"
#include "base/text.h"

#include <stdint.h>

/* A picture of whole numbers, interleaved, row 0 at the top, colours as stored. Channels: grey, grey and alpha, RGB
 * or RGBA. */
struct raster {
    int width, height, channels;
    bool is_wide; /* 16 bits a sample; else 8 */
    bool
        has_tags; /* of a camera or an offset: they may tell that the picture is turned, or lies elsewhere */
    uint16_t *wide; /* the one of the two that is_wide tells; NULL: only the size is read */
    unsigned char *narrow;
};

void raster_free(struct raster *raster);

/* The number of samples. */
size_t raster_count(const struct raster *raster);

/* Makes room for the samples. Error: the size is refused, or memory has no room. */
bool raster_alloc(struct raster *raster);

/* The sample over [0, 1] of 8 bits. */
unsigned char raster_byte(const struct raster *raster, size_t sample);

/* Refuses pictures without pixels, and more than 2^28 of them. */
bool check_picture_size(int64_t width, int64_t height);

/* Decodes a file in memory, or its size alone. */
bool png_read(struct raster *raster, const unsigned char *bytes, size_t size, bool size_only);
bool jpeg_read(struct raster *raster, const unsigned char *bytes, size_t size, bool size_only);
bool webp_read(struct raster *raster, const unsigned char *bytes, size_t size, bool size_only);

/* Appends a PNG of 8 bits with 3 or 4 channels. */
bool png_write(struct text *file, const unsigned char *samples, int width, int height,
               int channels);

/* The same for floats: red, green and blue of the beauty layer. */
bool pfm_read(struct image *image, const unsigned char *bytes, size_t size);
bool hdr_read(struct image *image, const unsigned char *bytes, size_t size);
void pfm_write(struct text *file, const struct image *image, const int channels[3]);
void hdr_write(struct text *file, const struct image *image, const int channels[3]);

/* Channels of an EXR: all of them, or those of one layer (image_read_layer). A file has one part of scan lines,
 * whose data window is its display window. */
bool exr_read(struct image *image, const char *path, const char *layer, int channels[3]);
bool exr_read_size(const char *path, int size[2]);
bool exr_write(struct text *file, const struct image *image);

/* Decodes a file in memory to its last pixel. */
bool exr_check(const struct text *bytes, int size[2]);

/* Sorts the three channels of a layer into wanted, without repetitions, and returns how many these are. channels become
 * places in wanted. */
int sort_channels(int channels[3], int wanted[3]);

/* Notes which layer was taken where another name was asked for. */
void tell_layer(const struct image *image, const char *path, const char *layer);

#endif
