/* Compressed data, unpacked to where plain files have theirs. */
#include "scene/gltf/model.hpp"

extern "C" {
#include "scene/gltf/unpack.h"
}

#include <memory>

namespace gltf {
namespace {

const char *const meshopt = "EXT_meshopt_compression";
const char *const draco = "KHR_draco_mesh_compression";

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

/* Gives an accessor a buffer of its own, which the caller fills; NULL and an error where it holds other
 * than so many elements, or too much. */
unsigned char *make_room(Loader &loader, int index, size_t count) {
    Model &model = loader.model;
    tinygltf::Accessor &accessor = model.accessors[index];
    int components = tinygltf::GetNumComponentsInType(uint32_t(accessor.type));
    size_t element = component_size(accessor.componentType) * size_t(components);
    if (accessor.count != count || components > 4) {
        error_set("accessor %d: %zu elements, not %zu", index, accessor.count, count);
        return nullptr;
    }
    if (!spend(loader, count, element))
        return nullptr;
    tinygltf::BufferView view;
    view.buffer = int(model.buffers.size());
    view.byteLength = count * element;
    accessor.bufferView = int(model.bufferViews.size());
    accessor.byteOffset = 0;
    model.buffers.emplace_back();
    model.buffers.back().data.resize(view.byteLength);
    model.bufferViews.push_back(view);
    return model.buffers.back().data.data();
}

bool unpack_attributes(Loader &loader, const tinygltf::Primitive &primitive,
                       const tinygltf::Value &ids, const struct packed_mesh *mesh) {
    for (const std::string &name : ids.Keys()) {
        auto found = primitive.attributes.find(name);
        if (found == primitive.attributes.end())
            continue;
        unsigned char *to = make_room(loader, found->second, packed_mesh_points(mesh));
        const tinygltf::Accessor &accessor = loader.model.accessors[found->second];
        int components = tinygltf::GetNumComponentsInType(uint32_t(accessor.type));
        if (!to || !packed_mesh_attribute(mesh, ids.Get(name).GetNumberAsInt(),
                                          accessor.componentType, components, to))
            return error_prefix("%s", clean(name).c_str());
    }
    return true;
}

/* A primitive that is in the file unpacked too is left as it is. */
bool unpack_primitive(Loader &loader, const tinygltf::Primitive &primitive,
                      const tinygltf::Value &from) {
    const size_t bytes_of_triangle = 64; /* that Draco takes */
    const Model &model = loader.model;
    auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end() || model.accessors[position->second].bufferView >= 0)
        return true;
    if (primitive.indices < 0 || primitive.mode != TINYGLTF_MODE_TRIANGLES)
        return error_set("it has no triangles with indices");
    int view = int(size_of(from, "bufferView"));
    size_t triangles = model.accessors[primitive.indices].count / 3;
    if (!spend(loader, triangles, bytes_of_triangle))
        return false;
    std::unique_ptr<packed_mesh, decltype(&packed_mesh_free)> mesh(
        unpack_draco(view_bytes(model, view), model.bufferViews[view].byteLength, triangles),
        packed_mesh_free);
    if (!mesh || !unpack_attributes(loader, primitive, from.Get("attributes"), mesh.get()))
        return false;
    unsigned char *to = make_room(loader, primitive.indices, triangles * 3);
    return to &&
           packed_mesh_indices(mesh.get(), model.accessors[primitive.indices].componentType, to);
}

} // namespace

bool unpack_primitives(Loader &loader) {
    for (size_t m = 0; m < loader.model.meshes.size(); m++) {
        const tinygltf::Mesh &mesh = loader.model.meshes[m];
        for (size_t p = 0; p < mesh.primitives.size(); p++) {
            auto found = mesh.primitives[p].extensions.find(draco);
            if (found != mesh.primitives[p].extensions.end() &&
                !unpack_primitive(loader, mesh.primitives[p], found->second))
                return error_prefix("%s: primitive %zu: %s", label("mesh", m, mesh.name).c_str(), p,
                                    draco);
        }
    }
    return true;
}

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
