/* Buffer views and accessors: whatever numbers a file holds, only bytes of its buffers are read. */
#include "scene/gltf_model.hpp"

namespace gltf {

/* The bytes from an offset in a buffer view to its end. */
bool view_bytes(const Model &model, int view, size_t offset, const unsigned char **bytes,
                size_t *size) {
    if (view < 0 || size_t(view) >= model.bufferViews.size())
        return error_set("there is no buffer view %d", view);
    const tinygltf::BufferView &v = model.bufferViews[view];
    if (v.buffer < 0 || size_t(v.buffer) >= model.buffers.size())
        return error_set("buffer view %d: there is no buffer %d", view, v.buffer);
    size_t available = model.buffers[v.buffer].data.size();
    if (v.byteOffset > available || v.byteLength > available - v.byteOffset)
        return error_set("buffer view %d: %zu bytes at %zu are outside buffer %d of %zu bytes",
                         view, v.byteLength, v.byteOffset, v.buffer, available);
    if (offset > v.byteLength)
        return error_set("offset %zu is outside buffer view %d of %zu bytes", offset, view,
                         v.byteLength);
    *bytes = model.buffers[v.buffer].data.data() + v.byteOffset + offset;
    *size = v.byteLength - offset;
    return true;
}

namespace {

const size_t max_elements = size_t(1) << 26;

/* Points into the view and checks that count elements at the stride fit. */
bool view_elements(const Model &model, int view, size_t offset, size_t count, size_t stride,
                   size_t element, const unsigned char **bytes) {
    size_t size;
    if (!view_bytes(model, view, offset, bytes, &size))
        return false;
    if (size < element || count - 1 > (size - element) / stride)
        return error_set("%zu elements of %zu bytes do not fit buffer view %d (%zu bytes left)",
                         count, element, view, size);
    return true;
}

bool resolve_sparse(const Model &model, const tinygltf::Accessor &a, struct accessor &out) {
    size_t element = component_size(a.componentType) * size_t(out.components);
    const auto &sparse = a.sparse;
    if (sparse.count < 1 || size_t(sparse.count) > a.count)
        return error_set("sparse: %d elements replace %zu", sparse.count, a.count);
    int type = sparse.indices.componentType;
    if (type != COMPONENT_UBYTE && type != COMPONENT_USHORT && type != COMPONENT_UINT)
        return error_set("sparse: component type %d is not for indices", type);
    if (sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0)
        return error_set("sparse: negative byte offset");
    out.sparse_count = size_t(sparse.count);
    out.sparse_index_type = type;
    size_t index = component_size(type);
    return (view_elements(model, sparse.indices.bufferView, size_t(sparse.indices.byteOffset),
                          out.sparse_count, index, index, &out.sparse_indices) &&
            view_elements(model, sparse.values.bufferView, size_t(sparse.values.byteOffset),
                          out.sparse_count, element, element, &out.sparse_values)) ||
           error_prefix("sparse");
}

} // namespace

bool resolve_accessor(const Model &model, int index, struct accessor &out) {
    out = {};
    if (index < 0 || size_t(index) >= model.accessors.size())
        return error_set("there is no accessor %d", index);
    const tinygltf::Accessor &a = model.accessors[index];
    size_t component = component_size(a.componentType);
    out.components = a.type == TINYGLTF_TYPE_SCALAR ? 1 : a.type;
    if (component == 0 || out.components < 1 || out.components > 4)
        return error_set("accessor %d: not a vector of numbers that meshes have", index);
    if (a.count < 1 || a.count > max_elements)
        return error_set("accessor %d: a count of %zu", index, a.count);
    size_t element = component * size_t(out.components);
    out.count = a.count;
    out.component_type = a.componentType;
    out.normalized = a.normalized;
    out.stride = element;
    bool good = true;
    if (a.bufferView >= 0) {
        if (size_t(a.bufferView) < model.bufferViews.size() &&
            model.bufferViews[a.bufferView].byteStride)
            out.stride = model.bufferViews[a.bufferView].byteStride;
        good = out.stride >= element
                   ? view_elements(model, a.bufferView, a.byteOffset, a.count, out.stride, element,
                                   &out.bytes)
                   : error_set("a stride of %zu for elements of %zu bytes", out.stride, element);
    }
    return (good && (!a.sparse.isSparse || resolve_sparse(model, a, out))) ||
           error_prefix("accessor %d", index);
}

} // namespace gltf
