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
    /* Colours may lack alpha. */
    bool good =
        load_elements(loader, found->second, Width, count, &numbers, Width == 4 ? 3 : Width);
    *out = reinterpret_cast<float(*)[Width]>(numbers);
    return good || error_prefix("%s", name.c_str());
}

/* Indices lie packed, whatever stride their buffer view has: other readers hand them to the GPU,
 * which knows none. */
bool pack_indices(Loader &loader, int index) {
    const tinygltf::Accessor &accessor = loader.model.accessors[size_t(index)];
    if (accessor.bufferView < 0)
        return true;
    tinygltf::BufferView view = loader.model.bufferViews[size_t(accessor.bufferView)];
    size_t stride = view.byteStride;
    if (stride == 0 || stride == component_size(accessor.componentType))
        return true;
    view.byteStride = 0;
    loader.model.accessors[size_t(index)].bufferView = int(loader.model.bufferViews.size());
    loader.model.bufferViews.push_back(view);
    return mend(loader, "a byteStride of indices is ignored", "accessor " + std::to_string(index));
}

bool load_indices(Loader &loader, int index, struct primitive &to) {
    struct accessor accessor = {};
    accessor.count = size_t(to.vertex_count);
    if (index >= 0 && !pack_indices(loader, index))
        return false;
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

/* The standard has clients ignore the indices of a last triangle that is not whole. */
bool mend_indices(Loader &loader, const tinygltf::Primitive &from, const std::string &object,
                  struct primitive &to) {
    int surplus = from.mode == TINYGLTF_MODE_TRIANGLES ? to.index_count % 3 : 0;
    to.index_count -= surplus;
    return surplus == 0 || mend(loader, "indices that make no whole triangle are ignored", object);
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

/* Chooses a mapping's coordinates. Some optimisers renumber sets and leave the
 * transforms' numbers. */
bool find_set(Loader &loader, const tinygltf::Primitive &from, const UvSource &mapping,
              const std::string &object, std::string &name) {
    const std::string own = "TEXCOORD_" + std::to_string(mapping.own_set);
    name = "TEXCOORD_" + std::to_string(mapping.set);
    if (from.attributes.count(name) || !from.attributes.count(own))
        return true;
    bool good = mend(loader,
                     "the texture's own texCoord replaces one of KHR_texture_transform "
                     "that the mesh lacks",
                     object + ": " + name);
    name = own;
    return good;
}

/* Of each mapping of its material. Where the file has no such coordinates, all are zero. */
bool load_uvs(Loader &loader, const tinygltf::Primitive &from, const std::string &object,
              struct primitive &to) {
    const std::vector<UvSource> &mappings = loader.mappings[size_t(to.material)];
    size_t count = size_t(to.vertex_count);
    for (size_t m = 0; m < mappings.size(); m++) {
        std::string name;
        if (!find_set(loader, from, mappings[m], object, name) ||
            !load_attribute(loader, from, name, count, &to.uv[m]))
            return false;
        if (to.uv[m])
            transform_uv(mappings[m], to.uv[m], count);
        else
            lack(loader, "texture coordinates that a material asks for and its mesh lacks (zeros)");
    }
    return true;
}

bool load_attributes(Loader &loader, const tinygltf::Primitive &from, const std::string &object,
                     struct primitive &to) {
    size_t count = size_t(to.vertex_count);
    if (!load_attribute(loader, from, "NORMAL", count, &to.normal) ||
        !load_attribute(loader, from, "COLOR_0", count, &to.color))
        return false;
    return load_uvs(loader, from, object, to);
}

bool load_primitive(Loader &loader, const tinygltf::Primitive &from, int target_count,
                    const std::string &object, struct primitive &to) {
    const Model &model = loader.model;
    to.material = material_of(loader, from);
    if (to.material < 0)
        to.material = int(model.materials.size());
    size_t count = model.accessors[from.attributes.at("POSITION")].count;
    if (!load_attribute(loader, from, "POSITION", count, &to.position))
        return false;
    to.vertex_count = int(count);
    if (!load_indices(loader, from.indices, to) || !mend_indices(loader, from, object, to) ||
        !primitive_check(&to) ||
        !primitive_unroll(&to, static_cast<enum primitive_mode>(from.mode)) ||
        !load_attributes(loader, from, object, to) || !load_joints(loader, from, object, to) ||
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

size_t count_of(const Model &model, int accessor) {
    return model.accessors[size_t(accessor)].count;
}

/* Why nothing of the primitive is drawn, or NULL: the standard has clients skip it. */
const char *find_lack(const Model &model, const tinygltf::Primitive &from) {
    auto position = from.attributes.find("POSITION");
    if (position == from.attributes.end())
        return "it has no POSITION";
    size_t count = count_of(model, position->second);
    if (from.indices >= 0 && count > 0)
        count = count_of(model, from.indices);
    return count >= 3 ? nullptr : "it has no triangle";
}

/* Whether the primitive is drawn. Lines, points and primitives without triangles are left out. */
bool keep_primitive(Loader &loader, const tinygltf::Primitive &from, const std::string &object,
                    bool &is_kept) {
    is_kept = false;
    if (from.mode < PRIMITIVE_TRIANGLES) {
        loader.scene->point_primitives += from.mode == TINYGLTF_MODE_POINTS;
        loader.scene->line_primitives += from.mode != TINYGLTF_MODE_POINTS;
        lack(loader, "points and lines");
        return true;
    }
    const char *reason = find_lack(loader.model, from);
    is_kept = !reason;
    return is_kept || mend(loader, "primitives without positions or triangles are left out",
                           object + ": " + reason);
}

/* The morph targets' number and weights at rest. The first primitive that is drawn counts. */
bool load_weights(Loader &loader, const tinygltf::Mesh &from, const std::string &object,
                  struct mesh &to) {
    for (const tinygltf::Primitive &primitive : from.primitives)
        if (primitive.mode >= PRIMITIVE_TRIANGLES && !find_lack(loader.model, primitive)) {
            to.target_count = int(primitive.targets.size());
            break;
        }
    if (to.target_count > 0)
        to.weights = allocate<float>(size_t(to.target_count));
    return from.weights.empty() ||
           copy_weights(loader, from.weights, size_t(to.target_count), object, to.weights);
}

bool load_mesh(Loader &loader, const tinygltf::Mesh &from, size_t index, struct mesh &to) {
    const std::string object = label("mesh", index, from.name);
    copy_name(to.name, from.name);
    if (!load_weights(loader, from, object, to))
        return false;
    to.primitives = allocate<struct primitive>(from.primitives.size());
    for (size_t i = 0; i < from.primitives.size(); i++) {
        const std::string part = object + ": primitive " + std::to_string(i);
        bool is_kept;
        if (!keep_primitive(loader, from.primitives[i], part, is_kept))
            return false;
        if (is_kept && !load_primitive(loader, from.primitives[i], to.target_count, part,
                                       to.primitives[to.primitive_count++]))
            return error_prefix("primitive %zu", i);
    }
    return true;
}

} // namespace

bool copy_weights(Loader &loader, const std::vector<double> &from, size_t targets,
                  const std::string &object, float *to) {
    std::vector<double> weights = from;
    weights.resize(targets);
    if (from.size() != targets &&
        !mend(loader, "weights without a morph target are ignored, and 0 where they lack",
              object + ": " + std::to_string(from.size()) + " weights for " +
                  std::to_string(targets) + " morph targets"))
        return false;
    return copy_numbers(weights, to, "weights");
}

bool load_meshes(Loader &loader) {
    const auto &from = loader.model.meshes;
    struct scene *scene = loader.scene;
    scene->meshes = allocate<struct mesh>(from.size());
    scene->mesh_count = int(from.size());
    for (size_t i = 0; i < from.size(); i++)
        if (!load_mesh(loader, from[i], i, scene->meshes[i]))
            return error_prefix("%s", label("mesh", i, from[i].name).c_str());
    return true;
}

} // namespace gltf
