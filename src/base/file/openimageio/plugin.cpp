/* The entry of the shared object (base/file/image_plugin.h). */
#include "base/file/openimageio/bridge.hpp"

#include "version.h"

namespace {

const struct log_sink *notes;

/* The sink is the thread's. */
bool read_telling(struct image *image, const char *path, const char *layer, int channels[3]) {
    log_set_sink(notes);
    return bridge::read(image, path, layer, channels);
}

} // namespace

__attribute__((visibility("default"))) const struct image_plugin *
manylight_openimageio(const struct log_sink *sink) {
    static const struct image_plugin plugin = {
        MANYLIGHT_VERSION,       error_get,
        error_get_kind,          read_telling,
        bridge::read_size,       bridge::check,
        bridge::encode,          bridge::encode_bitmap,
        bridge::measure_texture, bridge::decode_texture,
    };
    notes = sink;
    return &plugin;
}
