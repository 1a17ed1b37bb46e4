/* Reads and writes picture files, by two bridges. The first (base/file/small/) starts quickly and
 * is tried first. It reads and writes EXR, PNG, PFM and HDR, and reads textures in PNG, JPEG and
 * WebP. OpenImageIO (base/file/image_plugin.h) takes other formats, and files with tiles, several
 * parts, windows or orientations. `make bundle` has only the first bridge, which refuses them. */
#ifndef BASE_FILE_IMAGE_FILE_H
#define BASE_FILE_IMAGE_FILE_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#include "base/image.h"
#include "base/text.h"

/* Reads a picture as floats: all channels of all parts of an EXR, the first picture of other
 * formats. Colours are not premultiplied by alpha. Integer formats stay sRGB-encoded in [0, 1],
 * with image->encoded set. The picture is the display window: pixels outside the data window are
 * black, data outside the display window is dropped. The resolution line (.hdr) or orientation tag
 * (JPEG, TIFF) turns it. Notes report windows and dropped data. Error: names file and reason. */
bool image_read(struct image *image, const char *path);

/* Reads the channels of one layer; channels receives its red, green and blue (image_find_layer). A
 * note reports a layer other than the named one. */
bool image_read_layer(struct image *image, const char *path, const char *layer, int channels[3]);

/* Writes floats in the format of the extension, by base/file/output_file.h; sRGB-encoded values are
 * decoded first. EXR: half for colour, 32 bit for Z and for layers not named in RGBA. All are 32
 * bit if a colour exceeds 65504 or image->passes is set, which adds the attributes manylight:passes
 * and manylight:weight. PFM and HDR: red, green and blue of the beauty layer. */
bool image_write(const struct image *image, const char *path);

/* Writes all channels as EXR. Other formats hold only R, G and B of the layer, "" for beauty; TIFF
 * stores beauty with A. */
bool image_write_layer(const struct image *image, const char *path, const char *layer);

/* Writes an 8-bit picture (PNG, JPEG, ...) without alpha. */
bool bitmap_write(const struct bitmap *bitmap, const char *path);

/* Writes an 8-bit picture with alpha, not premultiplied. Error: also for formats without alpha. */
bool bitmap_write_alpha(const struct bitmap *bitmap, const char *path);

/* Checks that the file opens, decodes to its last pixel and ends as its format requires. Error: the
 * reason. */
bool image_is_whole(const char *path);

/* Reads width and height in pixels. Error: the file is no picture. */
bool image_size(const char *path, int size[2]);

/* Finds whether the format stores floats (EXR, PFM, HDR, ...). Call it before long work. Error: the
 * extension is missing or unknown. */
bool image_format_is_float(const char *path, bool *is_float);

/* Check that the format is written with alpha, or holds all layers as only EXR does. Error: it does
 * not. */
bool image_format_has_alpha(const char *path);
bool image_name_holds_layers(const char *path);

/* True if the extension is known. */
bool image_name_tells_format(const char *path);

/* Sets the format of names without a known extension, such as "-" and /dev/fd/63. extension: "png".
 * Call it before threads start. Error: it is unknown. */
bool image_set_format_of_others(const char *extension);

/* Computes the bytes for bitmap_decode and for drawing with the picture: texels, and as many again
 * with MIP maps. */
bool bitmap_measure(const void *bytes, size_t size, uint64_t *memory);

/* Decodes a PNG, JPEG, ... in memory. Grey becomes RGB, missing alpha 255. */
bool bitmap_decode(struct bitmap *bitmap, const void *bytes, size_t size);

#ifdef __cplusplus
}
#endif

#endif
