/* What the parts of the bridge to OpenImageIO share. They are all that names it, and lie in a
 * shared object of their own. */
#ifndef BASE_FILE_OPENIMAGEIO_BRIDGE_HPP
#define BASE_FILE_OPENIMAGEIO_BRIDGE_HPP

#include "base/file/image_plugin.h"

extern "C" {
#include "base/memory.h"
}

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/strutil.h>

#include <string>

namespace bridge {

inline std::string first_line(const std::string &reason) {
    return reason.empty() ? "cannot be read" : reason.substr(0, reason.find('\n'));
}

/* Sets the error, of the reason's first line. */
inline bool fail(const char *path, const std::string &reason) {
    return error_set("%s: %s", path, first_line(reason).c_str());
}

inline bool check_size(int width, int height, const char *path) {
    /* Beyond this a file is refused rather than read: 2^28 pixels is 16384 x 16384. */
    const uint64_t max_pixels = uint64_t(1) << 28;
    if (width < 1 || height < 1)
        return fail(path, "not a two-dimensional picture");
    return uint64_t(width) * uint64_t(height) <= max_pixels ||
           fail(path, "too large: " + std::to_string(width) + "x" + std::to_string(height));
}

inline bool check_size(const OIIO::ImageSpec &spec, const char *path) {
    if (spec.depth != 1 || spec.nchannels < 1)
        return fail(path, "not a two-dimensional picture");
    return check_size(spec.width, spec.height, path);
}

/* Colours as the file has them, not times alpha, as OpenImageIO else makes them. */
inline OIIO::ImageSpec as_stored() {
    OIIO::ImageSpec hints;
    hints.attribute("oiio:UnassociatedAlpha", 1);
    return hints;
}

/* The functions of struct image_plugin. */
bool read(struct image *image, const char *path, const char *layer, int channels[3]);
bool read_size(const char *path, int size[2]);
bool check(const char *path);
bool encode(struct file_bytes *file, const struct image *image, const char *path,
            const char *format);
bool encode_bitmap(struct file_bytes *file, const struct bitmap *bitmap, int channels,
                   const char *path, const char *format);
bool measure_texture(const void *bytes, size_t size, uint64_t *memory);
bool decode_texture(struct bitmap *bitmap, const void *bytes, size_t size);

} // namespace bridge

#endif
