/* Compressed data, unpacked to where plain files have theirs. */
#include "scene/gltf/model.hpp"

extern "C" {
#include "scene/gltf/unpack.h"
}

namespace gltf {
namespace {

const char *const meshopt = "EXT_meshopt_compression";

size_t size_of(const tinygltf::Value &object, const char *key) {
    return object.Has(key) ? size_t(object.Get(key).GetNumberAsDouble()) : 0;
}

std::string text_of(const tinygltf::Value &object, const char *key) {
    return object.Has(key) ? object.Get(key).Get<std::string>() : "";
}

/* The bytes that an extension names itself, as it is no buffer view. */
bool find_bytes(const Loader &loader, const tinygltf::Value &from, struct packed_view &to) {
    const auto &data = loader.model.buffers[size_of(from, "buffer")].data;
    size_t offset = size_of(from, "byteOffset");
    to.size = size_of(from, "byteLength");
    if (loader.is_absent[size_of(from, "buffer")])
        return error_set("packed data in a buffer that is not there");
    if (offset > data.size() || to.size > data.size() - offset)
        return error_set("%zu bytes at %zu are outside buffer %zu of %zu bytes", to.size, offset,
                         size_of(from, "buffer"), data.size());
    to.bytes = data.data() + offset;
    return true;
}

bool unpack_view(Loader &loader, const tinygltf::BufferView &view, const tinygltf::Value &from) {
    struct packed_view packed = {};
    std::string mode = text_of(from, "mode"), filter = text_of(from, "filter");
    packed.count = size_of(from, "count");
    packed.stride = size_of(from, "byteStride");
    packed.mode = mode == "ATTRIBUTES"  ? PACKED_ATTRIBUTES
                  : mode == "TRIANGLES" ? PACKED_TRIANGLES
                                        : PACKED_INDICES;
    packed.filter = filter == "OCTAHEDRAL"    ? FILTER_OCTAHEDRAL
                    : filter == "QUATERNION"  ? FILTER_QUATERNION
                    : filter == "EXPONENTIAL" ? FILTER_EXPONENTIAL
                                              : FILTER_NONE;
    if (packed.stride == 0 || packed.count > view.byteLength / packed.stride)
        return error_set("%zu elements of %zu bytes in %zu bytes", packed.count, packed.stride,
                         view.byteLength);
    if (view.byteOffset % 4 != 0)
        return error_set("it begins at %zu, no multiple of 4", view.byteOffset);
    return find_bytes(loader, from, packed) &&
           unpack_meshopt(&packed, loader.model.buffers[view.buffer].data.data() + view.byteOffset);
}

} // namespace

bool unpack_views(Loader &loader) {
    const Model &model = loader.model;
    for (size_t i = 0; i < model.bufferViews.size(); i++) {
        const tinygltf::BufferView &view = model.bufferViews[i];
        auto found = view.extensions.find(meshopt);
        if (found != view.extensions.end() && loader.is_absent[view.buffer] &&
            !unpack_view(loader, view, found->second))
            return error_prefix("buffer view %zu: %s", i, meshopt);
    }
    return true;
}

} // namespace gltf
