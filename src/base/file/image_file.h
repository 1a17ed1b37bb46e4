/* Picture files, by two bridges. The first starts quickly and comes first (base/file/small/): it reads and writes EXR, PNG,
 * PFM and HDR, and reads textures in PNG, JPEG and WebP. Other formats go to OpenImageIO (base/file/image_plugin.h), and so
 * do files of these formats with tiles, several parts, windows, orientations and the like. `make bundle` has the first
 * bridge alone, which refuses them. */
#ifndef BASE_FILE_IMAGE_FILE_H
#define BASE_FILE_IMAGE_FILE_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#include "base/image.h"
#include "base/text.h"

/* Reads any format that OpenImageIO knows: all channels of all parts of an EXR, of other formats the
 * first picture, as floats. Colours are as stored, not times alpha. Integer formats come over [0, 1]
 * and still sRGB-encoded; image->encoded tells. The picture is its display window, black where the
 * data window has no pixels; data outside it is left out. It is turned as its resolution line (.hdr)
 * or its tag (JPEG, TIFF) says. Notes tell of windows, and of what is left out. Error: names the file
 * and the reason. */
bool image_read(struct image *image, const char *path);

/* The same with the channels of one layer alone, and which of them are its red, green and blue
 * (image_find_layer). A note tells which layer was taken where another name was asked for. */
bool image_read_layer(struct image *image, const char *path, const char *layer, int channels[3]);

/* Writes floats; the extension picks the format. EXR: half for colour, 32 bit for Z and for layers
 * named in neither RGBA, and for all where a colour is beyond 65504 or the passes are told, with the
 * attributes manylight:passes and manylight:weight. PFM and HDR get red, green and blue of the beauty layer. What was encoded is
 * decoded again, then written as base/file/output_file.h does. */
bool image_write(const struct image *image, const char *path);

/* Writes all channels as EXR; other formats hold R, G and B of the layer alone, "" for the beauty, which TIFF stores
 * with A. */
bool image_write_layer(const struct image *image, const char *path, const char *layer);

/* Writes an 8-bit picture (PNG, JPEG, ...) without its alpha. */
bool bitmap_write(const struct bitmap *bitmap, const char *path);

/* Writes an 8-bit picture with alpha, by which colours are not multiplied. Error: also of a
 * format that is written without alpha. */
bool bitmap_write_alpha(const struct bitmap *bitmap, const char *path);

/* Whether the file opens, decodes to its last pixel and ends as its format does. Error: says why
 * not. */
bool image_is_whole(const char *path);

/* Pixels across and down. Error: the file is no picture. */
bool image_size(const char *path, int size[2]);

/* Whether the extension names a format that stores floats (EXR, PFM, HDR, ...). An error where the
 * extension is missing or unknown; call it before long work. */
bool image_format_is_float(const char *path, bool *is_float);

/* Whether the format is written with alpha, and whether it holds all layers, which EXR alone does. Error: says so. */
bool image_format_has_alpha(const char *path);
bool image_name_holds_layers(const char *path);

/* Whether the extension is known. */
bool image_name_tells_format(const char *path);

/* The format, told by its extension, of names that tell none: "-", /dev/fd/63. Error: it is not known. Call it
 * before threads start. */
bool image_set_format_of_others(const char *extension);

/* The memory that bitmap_decode takes for the picture, and what draws with it: its texels, and as many
 * with their MIP maps. */
bool bitmap_measure(const void *bytes, size_t size, uint64_t *memory);

/* Decodes a PNG, JPEG, ... held in memory. Grey becomes RGB, missing alpha 255. */
bool bitmap_decode(struct bitmap *bitmap, const void *bytes, size_t size);

#ifdef __cplusplus
}
#endif

#endif
