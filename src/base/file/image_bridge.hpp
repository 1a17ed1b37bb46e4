/* What the parts of the bridge to OpenImageIO share. Only src/base/file/image_* name it. */
#ifndef BASE_FILE_IMAGE_BRIDGE_HPP
#define BASE_FILE_IMAGE_BRIDGE_HPP

#include "base/file/image_file.h"

extern "C" {
#include "base/error.h"
#include "base/file/file.h"
#include "base/log.h"
#include "base/memory.h"
}

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/strutil.h>

#include <string>

namespace bridge {

/* Of an EXR that is a mean of passes. */
const char passes_attribute[] = "manylight:passes", weight_attribute[] = "manylight:weight";

/* Sets the error, of the reason's first line. */
inline bool fail(const char *path, const std::string &reason) {
    std::string line = reason.empty() ? "cannot be read" : reason.substr(0, reason.find('\n'));
    return error_set("%s: %s", path, line.c_str());
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

} // namespace bridge

#endif
