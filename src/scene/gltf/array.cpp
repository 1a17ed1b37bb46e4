/* Buffer views and accessors: whatever numbers a file holds, only bytes of its buffers are read. */
#include "scene/gltf/model.hpp"

#include <algorithm>
#include <cassert>

namespace gltf {

const unsigned char *view_bytes(const Model &model, int view) {
    const tinygltf::BufferView &v = model.bufferViews[view];
    const std::vector<unsigned char> &data = model.buffers[v.buffer].data;
    assert(v.byteOffset <= data.size() && v.byteLength <= data.size() - v.byteOffset);
    return data.data() + v.byteOffset;
}

namespace {

/* Elements to be found in a buffer view. */
struct Run {
    int view;
    size_t offset, count, element, stride; /* bytes but for count */
};

bool locate(const Model &model, const Run &run, const unsigned char **bytes) {
    size_t size = model.bufferViews[run.view].byteLength;
    if (run.stride < run.element)
        return error_set("a stride of %zu for elements of %zu bytes", run.stride, run.element);
    if (run.offset > size || size - run.offset < run.element ||
        run.count - 1 > (size - run.offset - run.element) / run.stride)
        return error_set("%zu elements of %zu bytes at %zu are outside buffer view %d of %zu bytes",
                         run.count, run.element, run.offset, run.view, size);
    *bytes = view_bytes(model, run.view) + run.offset;
    return true;
}

bool resolve_sparse(const Model &model, const tinygltf::Accessor &a, struct accessor &out) {
    size_t element = component_size(a.componentType) * size_t(out.components);
    const auto &sparse = a.sparse;
    if (sparse.count < 1 || size_t(sparse.count) > a.count)
        return error_set("%d elements replace %zu", sparse.count, a.count);
    out.sparse_count = size_t(sparse.count);
    out.sparse_index_type = sparse.indices.componentType;
    size_t index = component_size(out.sparse_index_type);
    Run indices = {sparse.indices.bufferView, size_t(sparse.indices.byteOffset), out.sparse_count,
                   index, index};
    Run values = {sparse.values.bufferView, size_t(sparse.values.byteOffset), out.sparse_count,
                  element, element};
    return locate(model, indices, &out.sparse_indices) && locate(model, values, &out.sparse_values);
}

} // namespace

bool resolve_accessor(const Model &model, int index, struct accessor &out) {
    const tinygltf::Accessor &a = model.accessors[index];
    out = {};
    bool matrix = a.type == TINYGLTF_TYPE_MAT4 && a.componentType == COMPONENT_FLOAT;
    out.components = matrix ? 16 : a.type == TINYGLTF_TYPE_SCALAR ? 1 : a.type;
    if (out.components > 4 && !matrix)
        return error_set("accessor %d: it holds matrices, and not of 4x4 floats", index);
    if (a.count == 0)
        return error_set("accessor %d: it has no elements", index);
    size_t element = component_size(a.componentType) * size_t(out.components);
    out.count = a.count;
    out.component_type = a.componentType;
    out.normalized = a.normalized;
    out.stride = element;
    if (a.bufferView >= 0) {
        if (model.bufferViews[a.bufferView].byteStride)
            out.stride = model.bufferViews[a.bufferView].byteStride;
        if (!locate(model, {a.bufferView, a.byteOffset, a.count, element, out.stride}, &out.bytes))
            return error_prefix("accessor %d", index);
    }
    if (a.count > max_elements)
        return error_set("accessor %d: more than %zu million elements", index, max_elements >> 20);
    return !a.sparse.isSparse || resolve_sparse(model, a, out) ||
           error_prefix("accessor %d: sparse", index);
}

void allow_memory(Loader &loader, uint64_t file_size) {
    if (!mem_is_limited())
        loader.memory += memory_of_file * file_size;
}

bool spend(Loader &loader, uint64_t count, size_t size) {
    static const double mib = 1 << 20;
    if (count > loader.memory / size)
        return error_set(
            "%.1f MiB of memory are wanted, and %.1f MiB are left of what the scene may "
            "take (ulimit -d grants more)",
            double(count) * double(size) / mib, double(loader.memory) / mib);
    loader.memory -= count * size;
    return true;
}

bool load_elements(Loader &loader, int index, int width, size_t count, float **out, int least) {
    struct accessor accessor;
    if (!resolve_accessor(loader.model, index, accessor))
        return false;
    if (accessor.components != width && accessor.components != least)
        return error_set("accessor %d has %d numbers an element, not %d", index,
                         accessor.components, width);
    if (accessor.count != count)
        return error_set("%zu elements, not %zu", accessor.count, count);
    if (!spend(loader, count, size_t(width) * sizeof **out))
        return false;
    *out = allocate<float>(count * size_t(width));
    std::fill_n(*out, count * size_t(width), 1.F);
    return accessor_read_floats(&accessor, width, *out);
}

} // namespace gltf
