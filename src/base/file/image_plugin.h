/* The bridge to OpenImageIO, a shared object of its own. It is opened when a picture first needs it, because the
 * dynamic linker takes longer over the 260 libraries of OpenImageIO than over everything else of a start. `make bundle`
 * leaves it out.
 *
 * The object has copies of the parts of src/base/ that it calls, so its errors and notes are its own: the functions below
 * are called through image_plugin.c, which passes both on. */
#ifndef BASE_FILE_IMAGE_PLUGIN_H
#define BASE_FILE_IMAGE_PLUGIN_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#include "base/error.h"
#include "base/file/file.h"
#include "base/image.h"
#include "base/log.h"

/* Functions of the bridge. Formats are names of OpenImageIO's. On false, error and error_kind tell the reason. */
struct image_plugin {
    const char *version; /* MANYLIGHT_VERSION of both sides must agree */
    const char *(*error)(void);
    enum error_kind (*error_kind)(void);

    /* image_read, or with a layer image_read_layer. */
    bool (*read)(struct image *image, const char *path, const char *layer, int channels[3]);
    bool (*read_size)(const char *path, int size[2]);
    /* Decodes the file to its last pixel. */
    bool (*check)(const char *path);

    /* The bytes of a file for that path, decoded again as a check; free() frees them. Nothing is written. */
    bool (*encode)(struct file_bytes *file, const struct image *image, const char *path,
                   const char *format);
    bool (*encode_bitmap)(struct file_bytes *file, const struct bitmap *bitmap, int channels,
                          const char *path, const char *format);

    /* bitmap_measure and bitmap_decode. */
    bool (*measure_texture)(const void *bytes, size_t size, uint64_t *memory);
    bool (*decode_texture)(struct bitmap *bitmap, const void *bytes, size_t size);
};

/* The one symbol of the object. What its functions tell goes to the sink. */
typedef const struct image_plugin *image_plugin_entry(const struct log_sink *sink);
image_plugin_entry manylight_openimageio;

/* The object, which is opened at the first call, from any thread. Error: it is not there, or why it does not open. */
const struct image_plugin *image_plugin_get(void);

/* Whether the object is there; it is not opened. */
bool image_plugin_is_there(void);

/* Takes the plugin's error over where ok is false. */
bool image_plugin_end(const struct image_plugin *plugin, bool ok);

#ifdef __cplusplus
}
#endif

#endif
