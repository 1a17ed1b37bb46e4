/* What moves vertices beside their node: skins and morph targets. */
#include "scene/gltf/model.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace gltf {
namespace {

bool all_finite(const float *numbers, size_t count) {
    return std::all_of(numbers, numbers + count, [](float x) { return std::isfinite(x); });
}

/* Whole numbers as floats, which hold all 16 bits. */
bool load_joint_numbers(Loader &loader, int index, struct primitive &to) {
    const tinygltf::Accessor &accessor = loader.model.accessors[index];
    if (accessor.normalized ||
        (accessor.componentType != COMPONENT_UBYTE && accessor.componentType != COMPONENT_USHORT))
        return error_set("accessor %d does not hold unsigned numbers of 8 or 16 bits", index);
    float *numbers = nullptr;
    size_t vertices = size_t(to.vertex_count);
    bool good = load_elements(loader, index, 4, vertices, &numbers);
    if (good) {
        to.joints = static_cast<uint16_t(*)[4]>(mem_alloc(vertices, sizeof *to.joints));
        std::copy_n(numbers, vertices * 4, *to.joints);
    }
    free(numbers);
    return good;
}

/* A weight just below 0 is 0. */
bool mend_weights(Loader &loader, const std::string &object, struct primitive &primitive) {
    int mended = 0;
    for (int i = 0; i < primitive.vertex_count; i++)
        for (float &weight : primitive.weights[i]) {
            bool is_off = weight < 0 && double(weight) >= -rounding;
            weight = is_off ? 0 : weight;
            mended += is_off;
        }
    return mended == 0 ||
           mend(loader, "numbers just below 0 are taken as 0", object + ": WEIGHTS_0");
}

/* The greatest joint that moves a vertex; others may be any number. */
void bound_joints(struct primitive &primitive) {
    for (int i = 0; i < primitive.vertex_count; i++)
        for (int j = 0; j < 4; j++) {
            if (primitive.weights[i][j] > 0)
                primitive.joint_bound = std::max(primitive.joint_bound, primitive.joints[i][j] + 1);
            else
                primitive.joints[i][j] = 0;
        }
}

/* One target's displacements by name; none where it has none. */
bool load_displacement(Loader &loader, const std::map<std::string, int> &from, const char *name,
                       size_t vertices, float (**out)[3]) {
    auto found = from.find(name);
    if (found == from.end())
        return true;
    float *numbers = nullptr;
    bool good = load_elements(loader, found->second, 3, vertices, &numbers);
    *out = reinterpret_cast<float(*)[3]>(numbers);
    return (good &&
            (all_finite(numbers, vertices * 3) || error_set("a displacement is not finite"))) ||
           error_prefix("%s", name);
}

bool load_skin(Loader &loader, const tinygltf::Skin &from, struct skin &to) {
    copy_name(to.name, from.name);
    if (from.joints.empty())
        return error_set("it has no joints");
    if (!spend(loader, from.joints.size(), sizeof *to.joints + sizeof *to.inverse_bind))
        return false;
    to.joint_count = int(from.joints.size());
    to.joints = allocate<int>(from.joints.size());
    for (size_t i = 0; i < from.joints.size(); i++)
        to.joints[i] = loader.node_places[from.joints[i]];
    if (from.inverseBindMatrices < 0) {
        to.inverse_bind =
            static_cast<float(*)[16]>(mem_alloc(from.joints.size(), sizeof *to.inverse_bind));
        for (int i = 0; i < to.joint_count; i++)
            for (int k = 0; k < 16; k += 5)
                to.inverse_bind[i][k] = 1;
        return true;
    }
    /* There may be more matrices than joints. */
    size_t count = loader.model.accessors[from.inverseBindMatrices].count;
    if (count < from.joints.size())
        return error_set("inverseBindMatrices: %zu for %d joints", count, to.joint_count);
    float *numbers = nullptr;
    bool good = load_elements(loader, from.inverseBindMatrices, 16, count, &numbers);
    to.inverse_bind = reinterpret_cast<float(*)[16]>(numbers);
    return (good && (all_finite(numbers, count * 16) || error_set("one of them is not finite"))) ||
           error_prefix("inverseBindMatrices");
}

/* Whether the node's skin has the joints that its mesh follows. */
bool check_skin(const struct scene &scene, const struct node &node) {
    const struct skin &skin = scene.skins[node.skin];
    for (int i = 0; i < skin.joint_count; i++)
        if (skin.joints[i] < 0)
            return error_set("joint %d of its skin is not in the scene", i);
    for (int p = 0; node.mesh >= 0 && p < scene.meshes[node.mesh].primitive_count; p++) {
        int bound = scene.meshes[node.mesh].primitives[p].joint_bound;
        if (bound > skin.joint_count)
            return error_set("primitive %d of its mesh follows joint %d, but its skin has %d", p,
                             bound - 1, skin.joint_count);
    }
    return true;
}

} // namespace

bool load_joints(Loader &loader, const tinygltf::Primitive &from, const std::string &object,
                 struct primitive &to) {
    auto joints = from.attributes.find("JOINTS_0"), weights = from.attributes.find("WEIGHTS_0");
    if (joints == from.attributes.end() && weights == from.attributes.end())
        return true;
    if (joints == from.attributes.end() || weights == from.attributes.end())
        return error_set("JOINTS_0 and WEIGHTS_0 go together");
    if (from.attributes.count("JOINTS_1"))
        lack(loader, "more than four joints a vertex");
    float *numbers = nullptr;
    if (!load_joint_numbers(loader, joints->second, to))
        return error_prefix("JOINTS_0");
    bool good = load_elements(loader, weights->second, 4, size_t(to.vertex_count), &numbers);
    to.weights = reinterpret_cast<float(*)[4]>(numbers);
    if (!good)
        return error_prefix("WEIGHTS_0");
    if (!mend_weights(loader, object, to))
        return false;
    if (!primitive_repair_weights(&to))
        return error_prefix("WEIGHTS_0");
    bound_joints(to);
    return true;
}

bool load_targets(Loader &loader, const tinygltf::Primitive &from, int count,
                  struct primitive &to) {
    if (from.targets.size() != size_t(count))
        return error_set("%zu morph targets, but the first primitive has %d", from.targets.size(),
                         count);
    if (count == 0)
        return true;
    size_t vertices = size_t(to.vertex_count);
    if (!spend(loader, from.targets.size(), sizeof *to.targets))
        return false;
    to.targets = allocate<struct morph_target>(from.targets.size());
    for (int i = 0; i < count; i++) {
        if (!load_displacement(loader, from.targets[i], "POSITION", vertices,
                               &to.targets[i].position) ||
            !load_displacement(loader, from.targets[i], "NORMAL", vertices, &to.targets[i].normal))
            return error_prefix("morph target %d", i);
        for (const auto &[name, accessor] : from.targets[i])
            if (name.compare(0, 9, "TEXCOORD_") == 0 || name.compare(0, 6, "COLOR_") == 0)
                lack(loader, "texture coordinates and colours of morph targets");
    }
    return true;
}

bool load_skins(Loader &loader) {
    const auto &from = loader.model.skins;
    struct scene *scene = loader.scene;
    scene->skins = allocate<struct skin>(from.size());
    scene->skin_count = int(from.size());
    for (size_t i = 0; i < from.size(); i++)
        if (!load_skin(loader, from[i], scene->skins[i]))
            return error_prefix("%s", label("skin", i, from[i].name).c_str());
    for (int i = 0; i < scene->node_count; i++)
        if (scene->nodes[i].skin >= 0 && !check_skin(*scene, scene->nodes[i]))
            return error_prefix("node '%s'", scene->nodes[i].name);
    return true;
}

} // namespace gltf
