/* KHR_lights_punctual, EXT_lights_area, and cameras. */
#include "scene/gltf/model.hpp"

#include <algorithm>
#include <cmath>

namespace gltf {
namespace {

const float half_pi = 1.5707964F;
const float size_max = 1e9F; /* metres */

bool check_intensity(const float intensity[3]) {
    for (int c = 0; c < 3; c++)
        if (!(intensity[c] >= 0 && intensity[c] <= SCENE_LIGHT_MOST))
            return error_set("intensity: it is negative or above %g", double(SCENE_LIGHT_MOST));
    return true;
}

/* A length or an angle of our own extras; what is not there stays as it is. */
bool read_size(const tinygltf::Value &extras, const char *key, float most, float &to) {
    if (!extras.Has(key))
        return true;
    const tinygltf::Value &value = extras.Get(key);
    to = value.IsNumber() ? float(value.GetNumberAsDouble()) : NAN;
    return (to >= 0 && to <= most) ||
           error_set("extras: %s: it is no number from 0 to %g", key, double(most));
}

/* {"size": [width, height]} of a spot. */
bool read_sides(const tinygltf::Value &extras, float to[2]) {
    if (!extras.Has("size"))
        return true;
    const tinygltf::Value &sides = extras.Get("size");
    bool good = sides.IsArray() && sides.ArrayLen() == 2;
    for (int i = 0; good && i < 2; i++) {
        good = sides.Get(i).IsNumber();
        to[i] = good ? float(sides.Get(i).GetNumberAsDouble()) : 0;
        good = to[i] > 0 && to[i] <= size_max;
    }
    return good || error_set("extras: size: these are no two lengths");
}

/* Sizes that punctual lights have in their extras: "radius" of a point or a spot, "size" of a spot,
 * "angle" across a directional light. */
bool load_size(const tinygltf::Value &extras, struct scene_light &to) {
    if (!extras.IsObject())
        return true;
    if (to.type == EMITTER_DIRECTIONAL)
        return read_size(extras, "angle", 2 * half_pi, to.size[0]);
    if (!read_size(extras, "radius", size_max / 2, to.size[0]))
        return false;
    to.size[0] *= 2;
    return to.type == EMITTER_POINT || read_sides(extras, to.size);
}

bool load_light(const tinygltf::Light &from, struct scene_light &to) {
    copy_name(to.name, from.name);
    to.type = from.type == "spot"    ? EMITTER_SPOT
              : from.type == "point" ? EMITTER_POINT
                                     : EMITTER_DIRECTIONAL;
    float color[3] = {1, 1, 1};
    if (!copy_numbers(from.color, color, "color"))
        return false;
    for (int c = 0; c < 3; c++) {
        to.color[c] = color[c];
        to.intensity[c] = float(color[c] * from.intensity);
    }
    to.strength = float(from.intensity);
    to.scale = 1;
    if (!check_intensity(to.intensity))
        return false;
    to.range = from.range > 0 ? float(from.range) : INFINITY;
    to.inner = float(from.spot.innerConeAngle);
    to.outer = float(from.spot.outerConeAngle);
    if (to.type == EMITTER_SPOT &&
        !(to.inner >= 0 && to.inner <= to.outer && to.outer > 0 && to.outer <= half_pi))
        return error_set("a cone from %g to %g radians", to.inner, to.outer);
    return load_size(from.extras, to);
}

/* The node's extras; of a node that only turns its parent's lamp, as Blender's exporter wrote them,
 * the parent's. */
const tinygltf::Value &extras_of(const Model &model, int node, int parent) {
    const tinygltf::Node &own = model.nodes[size_t(node)];
    if (own.extras.IsObject() || parent < 0)
        return own.extras;
    const tinygltf::Node &from = model.nodes[size_t(parent)];
    bool is_lamp = from.children.size() == 1 && from.mesh < 0 && from.camera < 0;
    return is_lamp ? from.extras : own.extras;
}

double number_or(const tinygltf::Value &object, const char *key, double otherwise) {
    return object.Has(key) ? object.Get(key).GetNumberAsDouble() : otherwise;
}

/* Nits are read as W/(sr m2). */
bool load_area_light(const tinygltf::Value &from, struct scene_light &to) {
    double size = number_or(from, "size", 1), aspect = 1;
    if (from.Has("name"))
        copy_name(to.name, from.Get("name").Get<std::string>());
    to.type = EMITTER_AREA;
    to.outer = half_pi;
    to.range = INFINITY;
    to.scaling = LIGHT_SCALED_ALIKE;
    to.strength = float(number_or(from, "intensity", 1000));
    to.scale = 1;
    for (size_t c = 0; c < 3; c++) {
        double color = from.Has("color") ? from.Get("color").Get(int(c)).GetNumberAsDouble() : 1;
        to.color[c] = float(color);
        to.intensity[c] = float(color * number_or(from, "intensity", 1000));
    }
    if (!check_intensity(to.intensity))
        return false;
    if (from.Has("rect"))
        aspect = number_or(from.Get("rect"), "aspect", 1);
    bool rectangle = from.Get("type").Get<std::string>() == "rect";
    to.size[0] = float(rectangle ? size * aspect : size);
    to.size[1] = rectangle ? float(size) : 0;
    double least = rectangle ? std::min(to.size[0], to.size[1]) : to.size[0];
    return (least > 0 && std::max(to.size[0], to.size[1]) <= size_max) ||
           error_set("size: %g by %g m", double(to.size[0]),
                     double(rectangle ? to.size[1] : to.size[0]));
}

/* Numbers that mended.cpp lets pass. */
void load_range(double near, double far, struct scene_camera &to) {
    to.near = float(near);
    to.far = far <= camera_depth_most ? float(far) : 0;
}

/* One that no picture has is none. */
float aspect_of(double width, double height) {
    double aspect = width / height;
    return aspect >= 1. / 16 && aspect <= 16 ? float(aspect) : 0;
}

bool load_perspective(const tinygltf::PerspectiveCamera &from, struct scene_camera &to) {
    to.fov_y = float(from.yfov);
    to.aspect = aspect_of(from.aspectRatio, 1);
    load_range(from.znear, from.zfar, to);
    return (to.fov_y > 0 && to.fov_y < 2 * half_pi) || error_set("yfov: %g radians", to.fov_y);
}

bool load_orthographic(const tinygltf::OrthographicCamera &from, struct scene_camera &to) {
    to.orthographic = true;
    to.y_extent = float(std::fabs(from.ymag));
    to.aspect = aspect_of(std::fabs(from.xmag), std::fabs(from.ymag));
    load_range(from.znear, from.zfar, to);
    return (to.y_extent > 0 && std::isfinite(to.y_extent)) ||
           error_set("ymag: %g m", double(to.y_extent));
}

bool load_camera(const tinygltf::Camera &from, struct scene_camera &to) {
    copy_name(to.name, from.name);
    return from.type == "perspective" ? load_perspective(from.perspective, to)
                                      : load_orthographic(from.orthographic, to);
}

/* {"punctual_scale": .5}, our own extras of the scene or the asset. */
bool load_scale(Loader &loader) {
    const tinygltf::Value *extras = find_extras(loader.model, "punctual_scale");
    if (!extras)
        return true;
    const tinygltf::Value &value = extras->Get("punctual_scale");
    double scale = value.IsNumber() ? value.GetNumberAsDouble() : 0;
    loader.scene->punctual_scale = float(scale);
    return (scale >= 1e-9 && scale <= 1e9) ||
           error_set("extras: punctual_scale: it is no number from 1e-9 to 1e9");
}

} // namespace

bool load_lights(Loader &loader) {
    const auto &from = loader.model.lights;
    const auto area = loader.model.extensions.find("EXT_lights_area");
    struct scene *scene = loader.scene;
    scene->of_blender_3 = loader.model.asset.generator.rfind("Khronos glTF Blender I/O v3", 0) == 0;
    size_t areas =
        area == loader.model.extensions.end() ? 0 : area->second.Get("lights").ArrayLen();
    size_t nodes = loader.model.nodes.size(); /* may each have their own: load_node_extras */
    scene->lights = allocate<struct scene_light>(from.size() + areas + nodes);
    scene->light_count = int(from.size() + areas);
    scene->slides = allocate<struct slide>(from.size() + nodes + count_profiles(loader.model));
    if (!load_scale(loader) || !load_profiles(loader))
        return false;
    for (size_t i = 0; i < from.size(); i++)
        if (!load_light(from[i], scene->lights[i]) ||
            !load_slide(loader, from[i].extras, scene->lights[i]) ||
            !load_profile(loader, from[i].extras, scene->lights[i]))
            return error_prefix("%s", label("light", i, from[i].name).c_str());
    for (size_t i = 0; i < areas; i++) {
        struct scene_light &to = scene->lights[from.size() + i];
        if (!load_area_light(area->second.Get("lights").Get(int(i)), to))
            return error_prefix("%s", label("area light", i, to.name).c_str());
    }
    return true;
}

/* A light that other nodes have too stays as it is. */
void load_node_extras(Loader &loader, int index, int parent, struct node &node) {
    struct scene *scene = loader.scene;
    const tinygltf::Value &extras = extras_of(loader.model, index, parent);
    if (node.light < 0 || size_t(node.light) >= loader.model.lights.size() || !extras.IsObject())
        return;
    struct scene_light light = scene->lights[node.light];
    bool good = light.size[0] > 0 || load_size(extras, light);
    if (good && light.slide && light.size[0] > 0 && scene->slides[light.slide - 1].is_profile)
        good = error_set("a light with a profile has no size");
    good = good && (light.slide ||
                    (load_slide(loader, extras, light) && load_profile(loader, extras, light)));
    if (!good) {
        log_note("%s: %s: %s: its lamp is without it", scene->path,
                 label("node", size_t(index), loader.model.nodes[size_t(index)].name).c_str(),
                 error_get());
        return;
    }
    if (memcmp(&light, &scene->lights[node.light], sizeof light) == 0)
        return;
    node.light = scene->light_count;
    scene->lights[scene->light_count++] = light;
}

bool load_cameras(Loader &loader) {
    const auto &from = loader.model.cameras;
    struct scene *scene = loader.scene;
    scene->cameras = allocate<struct scene_camera>(from.size());
    scene->camera_count = int(from.size());
    for (size_t i = 0; i < from.size(); i++)
        if (!load_camera(from[i], scene->cameras[i]))
            return error_prefix("%s", label("camera", i, from[i].name).c_str());
    return true;
}

} // namespace gltf
