/* What a channel moves: a property of a node, a light, a camera or a material, by its JSON pointer
 * [KHR_animation_pointer]. */
#include "scene/gltf/model.hpp"

#include <climits>
#include <cstddef>
#include <cstring>

namespace gltf {
namespace {

/* Stars stand for numbers: first the target's. */
struct Property {
    const char *pattern;
    enum channel_path path;
    size_t offset;
    int width;
    float least, most;
};

#define LIGHTS "/extensions/KHR_lights_punctual/lights/*/"
#define AREA_LIGHTS "/extensions/EXT_lights_area/lights/*/"
#define PBR "/materials/*/pbrMetallicRoughness/"
#define OLD_PBR "/materials/*/extensions/KHR_materials_pbrSpecularGlossiness/"
#define STRENGTH "/materials/*/extensions/KHR_materials_emissive_strength/emissiveStrength"
#define LIGHT(field) CHANNEL_LIGHT, offsetof(struct scene_light, field)
#define CAMERA(field) CHANNEL_CAMERA, offsetof(struct scene_camera, field)
#define MATERIAL(field) CHANNEL_MATERIAL, offsetof(struct material, field)

const float half_pi = 1.5707964F, least_fov = 1e-3F, far_most = float(camera_depth_most);

const Property properties[] = {
    {"/nodes/*/translation", CHANNEL_TRANSLATION, 0, 3, 0, 0},
    {"/nodes/*/rotation", CHANNEL_ROTATION, 0, 4, 0, 0},
    {"/nodes/*/scale", CHANNEL_SCALE, 0, 3, 0, 0},
    {"/nodes/*/weights", CHANNEL_WEIGHTS, 0, 0, 0, 0},
    {"/nodes/*/weights/*", CHANNEL_WEIGHTS, 0, 1, 0, 0},
    {"/nodes/*/extensions/KHR_node_visibility/visible", CHANNEL_VISIBLE, 0, 1, 0, 0},
    {LIGHTS "color", LIGHT(color), 3, 0, SCENE_LIGHT_MOST},
    {LIGHTS "intensity", LIGHT(strength), 1, 0, SCENE_LIGHT_MOST},
    {LIGHTS "range", LIGHT(range), 1, 0, far_most},
    {LIGHTS "spot/innerConeAngle", LIGHT(inner), 1, 0, half_pi},
    {LIGHTS "spot/outerConeAngle", LIGHT(outer), 1, least_fov, half_pi},
    {AREA_LIGHTS "color", LIGHT(color), 3, 0, SCENE_LIGHT_MOST},
    {AREA_LIGHTS "intensity", LIGHT(strength), 1, 0, SCENE_LIGHT_MOST},
    {"/cameras/*/perspective/yfov", CAMERA(fov_y), 1, least_fov, 2 * half_pi - least_fov},
    {"/cameras/*/perspective/znear", CAMERA(near), 1, 0, far_most},
    {"/cameras/*/perspective/zfar", CAMERA(far), 1, 0, far_most},
    {"/cameras/*/orthographic/ymag", CAMERA(y_extent), 1, least_fov, far_most},
    {"/cameras/*/orthographic/znear", CAMERA(near), 1, 0, far_most},
    {"/cameras/*/orthographic/zfar", CAMERA(far), 1, 0, far_most},
    {PBR "baseColorFactor", MATERIAL(base_color), 4, 0, 1},
    {PBR "metallicFactor", MATERIAL(metalness), 1, 0, 1},
    {PBR "roughnessFactor", MATERIAL(roughness), 1, 0, 1},
    {OLD_PBR "diffuseFactor", MATERIAL(base_color), 4, 0, 1},
    {"/materials/*/alphaCutoff", MATERIAL(alpha_cutoff), 1, 0, far_most},
    {"/materials/*/normalTexture/scale", MATERIAL(normal_scale), 1, -far_most, far_most},
    {"/materials/*/emissiveFactor", MATERIAL(emissive_factor), 3, 0, SCENE_LIGHT_MOST},
    {STRENGTH, MATERIAL(emissive_strength), 1, 0, SCENE_LIGHT_MOST},
};

bool matches(const char *pattern, const char *text, int numbers[2]) {
    for (; *pattern; pattern++) {
        char *end = nullptr;
        if (*pattern != '*') {
            if (*text++ != *pattern)
                return false;
            continue;
        }
        long number = *text >= '0' && *text <= '9' ? strtol(text, &end, 10) : -1;
        if (number < 0)
            return false;
        *numbers++ = number < INT_MAX ? int(number) : INT_MAX;
        text = end;
    }
    return !*text;
}

bool is_below(const Property &property, const char *list) {
    return strncmp(property.pattern, list, strlen(list)) == 0;
}

/* The target's list: its length, and where it begins in the scene's. */
size_t count_targets(const Loader &loader, const Property &property, size_t &first) {
    const Model &model = loader.model;
    bool is_area = is_below(property, AREA_LIGHTS);
    first = is_area ? model.lights.size() : 0;
    switch (property.path) {
    case CHANNEL_LIGHT:
        return is_area ? size_t(loader.scene->light_count) - first : model.lights.size();
    case CHANNEL_CAMERA:
        return model.cameras.size();
    case CHANNEL_MATERIAL:
        return model.materials.size();
    default:
        return model.nodes.size();
    }
}

/* Whether the material has the property: unlit ones ignore all but their colour. */
bool material_has(const struct material &material, const Property &property) {
    bool is_color = property.offset == offsetof(struct material, base_color);
    bool is_old = is_below(property, OLD_PBR);
    if ((is_old || is_below(property, PBR)) && is_old != material.specular_glossiness)
        return false;
    return is_color || !material.unlit;
}

bool set_weights(const struct scene &scene, int number, struct channel &to) {
    const struct node &node = scene.nodes[to.target];
    int count = node.mesh >= 0 ? scene.meshes[node.mesh].target_count : 0;
    if (count == 0)
        return error_set("weights of a node without morph targets");
    if (to.width == 1 && number >= count)
        return error_set("weight %d, but there are %d", number, count);
    to.offset = to.width == 1 ? size_t(number) : 0;
    to.width = to.width == 1 ? 1 : count;
    return true;
}

bool set_target(const Loader &loader, const Property &property, const int numbers[2],
                struct channel &to) {
    const struct scene &scene = *loader.scene;
    size_t first, count = count_targets(loader, property, first);
    if (size_t(numbers[0]) >= count)
        return error_set("number %d, but there are %zu", numbers[0], count);
    to = {};
    to.path = property.path;
    to.offset = property.offset;
    to.width = property.width;
    to.least = property.least;
    to.most = property.most;
    to.target = numbers[0] + int(first);
    if (to.path < CHANNEL_LIGHT)
        to.target = loader.node_places[size_t(numbers[0])];
    else if (to.path == CHANNEL_MATERIAL && !material_has(scene.materials[to.target], property))
        to.target = -1;
    if (to.target < 0)
        return true;
    if (to.path == CHANNEL_WEIGHTS)
        return set_weights(scene, numbers[1], to);
    return to.path > CHANNEL_SCALE || !scene.nodes[to.target].has_matrix ||
           error_set("the node '%s' has a matrix, which cannot be animated",
                     scene.nodes[to.target].name);
}

} // namespace

std::string pointer_of(const tinygltf::AnimationChannel &from) {
    auto extension = from.target_extensions.find("KHR_animation_pointer");
    if (from.target_path == "pointer" && extension != from.target_extensions.end())
        return extension->second.Get("pointer").Get<std::string>();
    return from.target_node < 0
               ? ""
               : "/nodes/" + std::to_string(from.target_node) + "/" + from.target_path;
}

bool find_property(const Loader &loader, const std::string &pointer, struct channel &to,
                   bool &is_known) {
    int numbers[2] = {0, 0};
    for (const Property &property : properties)
        if (matches(property.pattern, pointer.c_str(), numbers)) {
            is_known = true;
            return set_target(loader, property, numbers, to);
        }
    is_known = false;
    return true;
}

} // namespace gltf
