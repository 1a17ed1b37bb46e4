/* WebP by libwebp: textures. */
#include "base/file/small/small.h"

#include "base/error.h"

#include <webp/decode.h>

bool webp_read(struct raster *raster, const unsigned char *bytes, size_t size, bool size_only) {
    WebPBitstreamFeatures features;
    *raster = (struct raster){0};
    if (WebPGetFeatures(bytes, size, &features) != VP8_STATUS_OK || features.has_animation)
        return error_set("a WebP that cannot be decoded, or an animation");
    raster->width = features.width;
    raster->height = features.height;
    raster->channels = 4;
    if (!check_picture_size(raster->width, raster->height))
        return false;
    if (size_only)
        return true;
    if (raster_alloc(raster) &&
        WebPDecodeRGBAInto(bytes, size, raster->narrow, raster_count(raster), 4 * raster->width))
        return true;
    if (raster->narrow)
        error_set("a WebP that cannot be decoded");
    raster_free(raster);
    return false;
}
