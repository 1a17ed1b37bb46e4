/* Compressed data, unpacked to where plain files have theirs. */
#include "scene/gltf/model.hpp"

extern "C" {
#include "scene/gltf/unpack.h"
}

#include <memory>

namespace gltf {
namespace {

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
                    : filter == "COLOR"       ? FILTER_COLOR
                                              : FILTER_NONE;
    if (packed.stride == 0 || packed.count > view.byteLength / packed.stride)
        return error_set("%zu elements of %zu bytes in %zu bytes", packed.count, packed.stride,
                         view.byteLength);
    if (view.byteOffset % 4 != 0)
        return error_set("it begins at %zu, no multiple of 4", view.byteOffset);
    return find_bytes(loader, from, packed) &&
           unpack_meshopt(&packed, loader.model.buffers[view.buffer].data.data() + view.byteOffset);
}

/* Gives a primitive an accessor of its own, with a buffer for `count` elements: a copy of the
 * file's, which other primitives may share; its number. -1 and an error: it holds matrices, or
 * too much. */
int make_room(Loader &loader, tinygltf::Accessor accessor, size_t count) {
    Model &model = loader.model;
    int components = tinygltf::GetNumComponentsInType(uint32_t(accessor.type));
    if (components < 1 || components > 4) {
        error_set("it holds matrices");
        return -1;
    }
    size_t element = component_size(accessor.componentType) * size_t(components);
    if (!spend(loader, count, element))
        return -1;
    tinygltf::BufferView view;
    view.buffer = int(model.buffers.size());
    view.byteLength = count * element;
    accessor.count = count;
    accessor.bufferView = int(model.bufferViews.size());
    accessor.byteOffset = 0;
    model.buffers.emplace_back();
    model.buffers.back().data.resize(view.byteLength);
    model.bufferViews.push_back(view);
    model.accessors.push_back(accessor);
    return int(model.accessors.size()) - 1;
}

/* Where its elements are to be written. */
unsigned char *room_of(Loader &loader, int index) {
    const tinygltf::Accessor &accessor = loader.model.accessors[size_t(index)];
    const tinygltf::BufferView &view = loader.model.bufferViews[size_t(accessor.bufferView)];
    return loader.model.buffers[size_t(view.buffer)].data.data();
}

/* Draco's number of elements counts. */
bool mend_count(Loader &loader, size_t there, size_t said, const std::string &object) {
    return there == said ||
           mend(loader, "accessors of another count than their Draco data have the data's",
                object + ": " + std::to_string(there) + ", not " + std::to_string(said));
}

bool unpack_attributes(Loader &loader, tinygltf::Primitive &primitive, const tinygltf::Value &ids,
                       const struct packed_mesh *mesh, const std::string &object) {
    size_t points = packed_mesh_points(mesh);
    for (const std::string &name : ids.Keys()) {
        auto found = primitive.attributes.find(name);
        if (found == primitive.attributes.end())
            continue;
        const tinygltf::Accessor accessor = loader.model.accessors[size_t(found->second)];
        int components = tinygltf::GetNumComponentsInType(uint32_t(accessor.type));
        int made = make_room(loader, accessor, points);
        if (made < 0 ||
            !packed_mesh_attribute(mesh, ids.Get(name).GetNumberAsInt(), accessor.componentType,
                                   components, room_of(loader, made)))
            return error_prefix("%s", clean(name).c_str());
        found->second = made;
        if (!mend_count(loader, points, accessor.count, object + ": " + clean(name)))
            return false;
    }
    return true;
}

/* Numbers that count all points; a primitive without indices gets some. */
bool unpack_indices(Loader &loader, tinygltf::Primitive &primitive, const struct packed_mesh *mesh,
                    size_t triangles, const std::string &object) {
    tinygltf::Accessor accessor;
    accessor.type = TINYGLTF_TYPE_SCALAR;
    accessor.componentType = COMPONENT_UINT;
    accessor.count = triangles * 3;
    if (primitive.indices >= 0)
        accessor = loader.model.accessors[size_t(primitive.indices)];
    size_t said = accessor.count, size = component_size(accessor.componentType);
    if (packed_mesh_points(mesh) > uint64_t(1) << 8 * size)
        accessor.componentType = COMPONENT_UINT;
    int made = make_room(loader, accessor, triangles * 3);
    if (made < 0 || !packed_mesh_indices(mesh, accessor.componentType, room_of(loader, made)))
        return error_prefix("indices");
    primitive.indices = made;
    return mend_count(loader, triangles * 3, said, object + ": indices");
}

/* A primitive that is in the file unpacked too is left as it is. */
bool unpack_primitive(Loader &loader, tinygltf::Primitive &primitive, const tinygltf::Value &from,
                      const std::string &object) {
    const size_t bytes_of_triangle = 64; /* that Draco takes */
    const Model &model = loader.model;
    auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end() ||
        model.accessors[size_t(position->second)].bufferView >= 0)
        return true;
    if (primitive.mode != TINYGLTF_MODE_TRIANGLES)
        return error_set("it has no triangles");
    size_t view = size_of(from, "bufferView"), size = model.bufferViews[view].byteLength, triangles;
    const unsigned char *bytes = view_bytes(model, int(view));
    if (!unpack_draco_size(bytes, size, &triangles) || !spend(loader, triangles, bytes_of_triangle))
        return false;
    std::unique_ptr<packed_mesh, decltype(&packed_mesh_free)> mesh(
        unpack_draco(bytes, size, triangles), packed_mesh_free);
    return mesh &&
           unpack_attributes(loader, primitive, from.Get("attributes"), mesh.get(), object) &&
           unpack_indices(loader, primitive, mesh.get(), triangles, object);
}

} // namespace

bool unpack_primitives(Loader &loader) {
    for (size_t m = 0; m < loader.model.meshes.size(); m++) {
        tinygltf::Mesh &mesh = loader.model.meshes[m];
        for (size_t p = 0; p < mesh.primitives.size(); p++) {
            auto found = mesh.primitives[p].extensions.find(draco);
            std::string object = label("mesh", m, mesh.name) + ": primitive " + std::to_string(p);
            if (found != mesh.primitives[p].extensions.end() &&
                !unpack_primitive(loader, mesh.primitives[p], found->second, object))
                return error_prefix("%s: %s", object.c_str(), draco);
        }
    }
    return true;
}

bool unpack_views(Loader &loader) {
    const Model &model = loader.model;
    for (size_t i = 0; i < model.bufferViews.size(); i++) {
        const tinygltf::BufferView &view = model.bufferViews[i];
        for (const char *meshopt : meshopt_names) {
            auto found = view.extensions.find(meshopt);
            if (found != view.extensions.end() && loader.is_absent[view.buffer] &&
                !unpack_view(loader, view, found->second))
                return error_prefix("buffer view %zu: %s", i, meshopt);
        }
    }
    return true;
}

} // namespace gltf
