/* Loads the bridge to OpenImageIO, a shared object. It is opened at first use, because its 260
 * libraries take the dynamic linker longer than the rest of the start. `make bundle` omits it.
 *
 * The object has copies of the parts of src/base/ that it calls, and so its own errors and notes.
 * image_plugin.c calls the functions below and forwards both. */
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

/* Functions of the bridge. Formats are names of OpenImageIO. After false, error and error_kind
 * return the reason. */
struct image_plugin {
    const char *version; /* MANYLIGHT_VERSION, equal on both sides */
    const char *(*error)(void);
    enum error_kind (*error_kind)(void);

    /* image_read, or image_read_layer if layer is not NULL. */
    bool (*read)(struct image *image, const char *path, const char *layer, int channels[3]);
    bool (*read_size)(const char *path, int size[2]);
    /* Decodes the file to its last pixel. */
    bool (*check)(const char *path);

    /* Encode a picture for that path and decode it as a check. The caller frees file->data. Nothing
     * is written. */
    bool (*encode)(struct file_bytes *file, const struct image *image, const char *path,
                   const char *format);
    bool (*encode_bitmap)(struct file_bytes *file, const struct bitmap *bitmap, int channels,
                          const char *path, const char *format);

    /* bitmap_measure and bitmap_decode. */
    bool (*measure_texture)(const void *bytes, size_t size, uint64_t *memory);
    bool (*decode_texture)(struct bitmap *bitmap, const void *bytes, size_t size);
};

/* The only symbol of the object. Its functions log to the sink. */
typedef const struct image_plugin *image_plugin_entry(const struct log_sink *sink);
image_plugin_entry manylight_openimageio;

/* Returns the functions. The first call, from any thread, opens the object. Error: it is missing or
 * cannot be opened. */
const struct image_plugin *image_plugin_get(void);

/* True if the object's file exists; does not open it. */
bool image_plugin_is_there(void);

/* Copies the plugin's error if ok is false. Returns ok. */
bool image_plugin_end(const struct image_plugin *plugin, bool ok);

#ifdef __cplusplus
}
#endif

#endif
