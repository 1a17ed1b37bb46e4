/* Meshes: triangles with attributes, whatever form the file has them in. */
#include "scene/gltf_model.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gltf {
namespace {

/* Takes from what one file's meshes may hold altogether: primitives that share an accessor, and
 * accessors without bytes, would let a small file fill any memory. */
bool spend(Loader &loader, size_t count) {
    if (count > loader.budget)
        return error_set("the meshes have more than %zu million vertices and indices",
                         max_elements >> 20);
    loader.budget -= count;
    return true;
}

/* Reads an attribute of one element per vertex into a new array, all ones at first; none where the
 * file has none. */
template <int Width>
bool load_attribute(Loader &loader, const tinygltf::Primitive &from, const std::string &name,
                    size_t count, float (**out)[Width]) {
    auto found = from.attributes.find(name);
    if (found == from.attributes.end())
        return true;
    struct accessor accessor;
    if (!resolve_accessor(loader.model, found->second, accessor) || !spend(loader, accessor.count))
        return error_prefix("%s", name.c_str());
    if (accessor.components != Width && !(Width == 4 && accessor.components == 3))
        return error_set("%s: accessor %d has %d numbers an element, not %d", name.c_str(),
                         found->second, accessor.components, Width);
    if (accessor.count != count)
        return error_set("%s: %zu elements for %zu vertices", name.c_str(), accessor.count, count);
    *out = static_cast<float(*)[Width]>(mem_alloc(count, sizeof **out));
    std::fill_n(**out, count * Width, 1.F);
    return accessor_read_floats(&accessor, Width, **out) || error_prefix("%s", name.c_str());
}

bool load_indices(Loader &loader, int index, struct primitive &to) {
    struct accessor accessor = {};
    accessor.count = size_t(to.vertex_count);
    if ((index >= 0 && !resolve_accessor(loader.model, index, accessor)) ||
        !spend(loader, accessor.count))
        return error_prefix("indices");
    int type = accessor.component_type;
    if (index >= 0 &&
        (accessor.components != 1 || accessor.normalized ||
         (type != COMPONENT_UBYTE && type != COMPONENT_USHORT && type != COMPONENT_UINT)))
        return error_set("indices: accessor %d does not hold unsigned numbers", index);
    to.index_count = int(accessor.count);
    to.indices = allocate<uint32_t>(accessor.count);
    std::iota(to.indices, to.indices + accessor.count, 0u);
    return index < 0 || accessor_read_indices(&accessor, to.indices) || error_prefix("indices");
}

/* KHR_texture_transform: scales, then rotates counter-clockwise as seen with v downward, then
 * offsets. */
void transform_uv(const UvSource &source, struct primitive &primitive) {
    double c = cos(source.rotation), s = sin(source.rotation);
    for (int i = 0; i < primitive.vertex_count; i++) {
        double u = primitive.uv[i][0] * source.scale[0], v = primitive.uv[i][1] * source.scale[1];
        primitive.uv[i][0] = float(c * u + s * v + source.offset[0]);
        primitive.uv[i][1] = float(c * v - s * u + source.offset[1]);
    }
}

bool load_attributes(Loader &loader, const tinygltf::Primitive &from, struct primitive &to) {
    size_t count = size_t(to.vertex_count);
    if (!load_attribute(loader, from, "NORMAL", count, &to.normal) ||
        !load_attribute(loader, from, "COLOR_0", count, &to.color))
        return false;
    if (loader.scene->materials[to.material].texture < 0)
        return true;
    const UvSource &uv = loader.uv_sources[size_t(to.material)];
    if (!load_attribute(loader, from, "TEXCOORD_" + std::to_string(uv.set), count, &to.uv))
        return false;
    if (to.uv)
        transform_uv(uv, to);
    return true;
}

bool load_primitive(Loader &loader, const tinygltf::Primitive &from, struct primitive &to) {
    const Model &model = loader.model;
    to.material = from.material >= 0 ? from.material : int(model.materials.size());
    auto position = from.attributes.find("POSITION");
    if (position == from.attributes.end())
        return error_set("it has no POSITION");
    size_t count = model.accessors[position->second].count;
    if (!load_attribute(loader, from, "POSITION", count, &to.position))
        return false;
    to.vertex_count = int(count);
    if (!load_indices(loader, from.indices, to) || !primitive_check(&to) ||
        !primitive_unroll(&to, static_cast<enum primitive_mode>(from.mode)) ||
        !load_attributes(loader, from, to))
        return false;
    if (to.normal) {
        primitive_repair_normals(&to);
        return true;
    }
    if (!spend(loader, size_t(to.index_count)))
        return false;
    primitive_flatten(&to);
    return true;
}

/* Lines and points are left out: lines_ignored tells. */
bool load_mesh(Loader &loader, const tinygltf::Mesh &from, struct mesh &to, bool &lines_ignored) {
    copy_name(to.name, from.name);
    to.primitives = allocate<struct primitive>(from.primitives.size());
    for (size_t i = 0; i < from.primitives.size(); i++) {
        int mode = from.primitives[i].mode;
        if (mode < PRIMITIVE_TRIANGLES) {
            lines_ignored = true;
            continue;
        }
        if (!load_primitive(loader, from.primitives[i], to.primitives[to.primitive_count++]))
            return error_prefix("primitive %zu", i);
    }
    return true;
}

} // namespace

bool load_meshes(Loader &loader) {
    const auto &from = loader.model.meshes;
    struct scene *scene = loader.scene;
    scene->meshes = allocate<struct mesh>(from.size());
    scene->mesh_count = int(from.size());
    bool lines_ignored = false;
    for (size_t i = 0; i < from.size(); i++)
        if (!load_mesh(loader, from[i], scene->meshes[i], lines_ignored))
            return error_prefix("%s", label("mesh", i, from[i].name).c_str());
    if (lines_ignored)
        log_warning("%s: points and lines are not drawn", scene->path);
    return true;
}

} // namespace gltf
