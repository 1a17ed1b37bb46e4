/* Meshes: triangles with attributes, whatever form the file has them in. */
#include "scene/gltf_model.hpp"

#include <cmath>

namespace gltf {
namespace {

/* Reads an attribute of one element per vertex into a new array; NULL where there is none. */
template <int Width>
bool load_attribute(const Model &model, const tinygltf::Primitive &from, const std::string &name,
                    size_t count, float fill, float (**out)[Width]) {
    auto found = from.attributes.find(name);
    if (found == from.attributes.end())
        return true;
    struct accessor accessor;
    if (!resolve_accessor(model, found->second, accessor))
        return error_prefix("%s", name.c_str());
    if (count != 0 && accessor.count != count)
        return error_set("%s: %zu elements for %zu vertices", name.c_str(), accessor.count, count);
    *out = static_cast<float(*)[Width]>(mem_alloc(accessor.count, sizeof **out));
    for (size_t i = 0; i < accessor.count; i++)
        for (int c = 0; c < Width; c++)
            (*out)[i][c] = fill;
    return accessor_read_floats(&accessor, Width, **out) || error_prefix("%s", name.c_str());
}

bool load_indices(const Model &model, int index, struct primitive &to) {
    if (index < 0) {
        to.index_count = to.vertex_count;
        to.indices = allocate<uint32_t>(size_t(to.index_count));
        for (int i = 0; i < to.index_count; i++)
            to.indices[i] = uint32_t(i);
        return true;
    }
    struct accessor accessor;
    if (!resolve_accessor(model, index, accessor))
        return error_prefix("indices");
    int type = accessor.component_type;
    if (accessor.components != 1 || accessor.normalized ||
        (type != COMPONENT_UBYTE && type != COMPONENT_USHORT && type != COMPONENT_UINT))
        return error_set("indices: accessor %d does not hold unsigned numbers", index);
    to.index_count = int(accessor.count);
    to.indices = allocate<uint32_t>(accessor.count);
    return accessor_read_indices(&accessor, to.indices) || error_prefix("indices");
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

bool load_primitive(Loader &loader, const tinygltf::Primitive &from, struct primitive &to) {
    const Model &model = loader.model;
    if (from.material >= int(model.materials.size()))
        return error_set("there is no material %d", from.material);
    to.material = from.material >= 0 ? from.material : int(model.materials.size());
    if (!load_attribute(model, from, "POSITION", 0, 0, &to.position))
        return false;
    if (!to.position)
        return error_set("it has no POSITION");
    size_t count = model.accessors[from.attributes.at("POSITION")].count;
    to.vertex_count = int(count);
    if (!load_indices(model, from.indices, to) || !primitive_check(&to) ||
        !primitive_unroll(&to, static_cast<enum primitive_mode>(from.mode)))
        return false;
    if (!load_attribute(model, from, "NORMAL", count, 0, &to.normal) ||
        !load_attribute(model, from, "COLOR_0", count, 1, &to.color))
        return false;
    if (loader.scene->materials[to.material].texture >= 0) {
        const UvSource &uv = loader.uv_sources[to.material];
        if (!load_attribute(model, from, "TEXCOORD_" + std::to_string(uv.set), count, 0, &to.uv))
            return false;
        if (to.uv)
            transform_uv(uv, to);
    }
    if (to.normal)
        primitive_repair_normals(&to);
    else
        primitive_flatten(&to);
    return true;
}

/* Lines and points are left out: lines_ignored tells. */
bool load_mesh(Loader &loader, const tinygltf::Mesh &from, struct mesh &to, bool &lines_ignored) {
    copy_name(to.name, from.name);
    to.primitives = allocate<struct primitive>(from.primitives.size());
    for (size_t i = 0; i < from.primitives.size(); i++) {
        int mode = from.primitives[i].mode;
        if (mode < 0 || mode > PRIMITIVE_FAN)
            return error_set("primitive %zu: there is no mode %d", i, mode);
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
