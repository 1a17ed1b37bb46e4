/* Meshes: triangles with attributes, whatever form the file has them in. */
#include "scene/gltf/model.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gltf {
namespace {

/* Reads an attribute of one element per vertex into a new array, all ones at first; none where the
 * file has none. */
template <int Width>
bool load_attribute(Loader &loader, const tinygltf::Primitive &from, const std::string &name,
                    size_t count, float (**out)[Width]) {
    auto found = from.attributes.find(name);
    if (found == from.attributes.end())
        return true;
    float *numbers = nullptr;
    bool good = load_elements(loader, found->second, Width, count, &numbers);
    *out = reinterpret_cast<float(*)[Width]>(numbers);
    return good || error_prefix("%s", name.c_str());
}

bool load_indices(Loader &loader, int index, struct primitive &to) {
    struct accessor accessor = {};
    accessor.count = size_t(to.vertex_count);
    if ((index >= 0 && !resolve_accessor(loader.model, index, accessor)) ||
        !spend(loader, accessor.count, sizeof *to.indices))
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
void transform_uv(const UvSource &source, float (*uv)[2], size_t count) {
    double c = cos(source.rotation), s = sin(source.rotation);
    for (size_t i = 0; i < count; i++) {
        double u = uv[i][0] * source.scale[0], v = uv[i][1] * source.scale[1];
        uv[i][0] = float(c * u + s * v + source.offset[0]);
        uv[i][1] = float(c * v - s * u + source.offset[1]);
    }
}

/* Of each mapping of its material. Where the file has no such coordinates, all are zero. */
bool load_uvs(Loader &loader, const tinygltf::Primitive &from, struct primitive &to) {
    const std::vector<UvSource> &mappings = loader.mappings[size_t(to.material)];
    size_t count = size_t(to.vertex_count);
    for (size_t m = 0; m < mappings.size(); m++) {
        std::string name = "TEXCOORD_" + std::to_string(mappings[m].set);
        if (!load_attribute(loader, from, name, count, &to.uv[m]))
            return false;
        if (to.uv[m])
            transform_uv(mappings[m], to.uv[m], count);
        else
            lack(loader, "texture coordinates that a material asks for and its mesh lacks (zeros)");
    }
    return true;
}

bool load_attributes(Loader &loader, const tinygltf::Primitive &from, struct primitive &to) {
    size_t count = size_t(to.vertex_count);
    if (!load_attribute(loader, from, "NORMAL", count, &to.normal) ||
        !load_attribute(loader, from, "COLOR_0", count, &to.color))
        return false;
    return load_uvs(loader, from, to);
}

bool load_primitive(Loader &loader, const tinygltf::Primitive &from, int target_count,
                    struct primitive &to) {
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
        !load_attributes(loader, from, to) || !load_joints(loader, from, to) ||
        !load_targets(loader, from, target_count, to))
        return false;
    if (to.normal) {
        primitive_repair_normals(&to);
        return true;
    }
    size_t vertex = sizeof *to.position + sizeof *to.normal + sizeof *to.color +
                    loader.mappings[size_t(to.material)].size() * sizeof *to.uv[0];
    size_t moved =
        size_t(target_count) * (sizeof *to.targets->position + sizeof *to.targets->normal);
    if (!spend(loader, uint64_t(to.index_count), vertex + moved))
        return false;
    primitive_flatten(&to, target_count);
    return true;
}

/* The morph targets' number and weights at rest. */
bool load_weights(const tinygltf::Mesh &from, struct mesh &to) {
    to.target_count = from.primitives.empty() ? 0 : int(from.primitives[0].targets.size());
    if (to.target_count > 0)
        to.weights = allocate<float>(size_t(to.target_count));
    if (!from.weights.empty() && from.weights.size() != size_t(to.target_count))
        return error_set("%zu weights for %d morph targets", from.weights.size(), to.target_count);
    return copy_numbers(from.weights, to.weights, "weights");
}

/* Lines and points are left out. */
bool load_mesh(Loader &loader, const tinygltf::Mesh &from, struct mesh &to) {
    copy_name(to.name, from.name);
    if (!load_weights(from, to))
        return false;
    to.primitives = allocate<struct primitive>(from.primitives.size());
    for (size_t i = 0; i < from.primitives.size(); i++) {
        int mode = from.primitives[i].mode;
        if (mode < PRIMITIVE_TRIANGLES) {
            lack(loader, "points and lines");
            continue;
        }
        if (!load_primitive(loader, from.primitives[i], to.target_count,
                            to.primitives[to.primitive_count++]))
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
    for (size_t i = 0; i < from.size(); i++)
        if (!load_mesh(loader, from[i], scene->meshes[i]))
            return error_prefix("%s", label("mesh", i, from[i].name).c_str());
    return true;
}

} // namespace gltf
