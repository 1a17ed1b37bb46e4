/* Decoders and encoders of the quick picture bridge, without OpenImageIO. One file includes each
 * library. Errors have no path: image_file.c adds it. */
#ifndef BASE_FILE_SMALL_SMALL_H
#define BASE_FILE_SMALL_SMALL_H

#include "base/image.h"
#include "base/text.h"

#include <stdint.h>

/* A picture of integers, interleaved, row 0 at the top, colours as stored. Channels: grey, grey and
 * alpha, RGB or RGBA. */
struct raster {
    int width, height, channels;
    bool is_wide; /* true: 16 bits per sample; else 8 */
    /* True if the file has camera tags or an offset, which may turn or move the picture. */
    bool has_tags;
    uint16_t *wide; /* wide or narrow holds the samples; NULL: only the size was read */
    unsigned char *narrow;
};

void raster_free(struct raster *raster);

/* Returns the number of samples. */
size_t raster_count(const struct raster *raster);

/* Allocates the samples. Error: the size is refused, or out of memory. */
bool raster_alloc(struct raster *raster);

/* Returns the sample as 8 bits. */
unsigned char raster_byte(const struct raster *raster, size_t sample);

/* Checks the size: 1 to 2^28 pixels. Error: it is outside. */
bool check_picture_size(int64_t width, int64_t height);

/* Decode a file in memory, or only its size. */
bool png_read(struct raster *raster, const unsigned char *bytes, size_t size, bool size_only);
bool jpeg_read(struct raster *raster, const unsigned char *bytes, size_t size, bool size_only);
bool webp_read(struct raster *raster, const unsigned char *bytes, size_t size, bool size_only);

/* Appends a PNG of 8 bits with 3 or 4 channels. */
bool png_write(struct text *file, const unsigned char *samples, int width, int height,
               int channels);

/* Read and append pictures of floats: red, green and blue of the beauty layer. */
bool pfm_read(struct image *image, const unsigned char *bytes, size_t size);
bool hdr_read(struct image *image, const unsigned char *bytes, size_t size);
void pfm_write(struct text *file, const struct image *image, const int channels[3]);
void hdr_write(struct text *file, const struct image *image, const int channels[3]);

/* Read and append an EXR: all channels, or those of one layer (image_read_layer). The file has one
 * part of scan lines, and its data window is its display window. */
bool exr_read(struct image *image, const char *path, const char *layer, int channels[3]);
bool exr_read_size(const char *path, int size[2]);
bool exr_write(struct text *file, const struct image *image);

/* Decodes a file in memory to its last pixel, as a check. */
bool exr_check(const struct text *bytes, int size[2]);

/* Sorts the three channels of a layer into wanted, without repetitions, and returns their number.
 * channels become indices into wanted. */
int sort_channels(int channels[3], int wanted[3]);

/* Logs a note if the layer found has another name than the one given. */
void tell_layer(const struct image *image, const char *path, const char *layer);

#endif
