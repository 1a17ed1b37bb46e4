/* KHR_lights_punctual, and cameras. */
#include "scene/gltf/model.hpp"

#include <cmath>

namespace gltf {
namespace {

const float half_pi = 1.5707964F;

bool load_light(const tinygltf::Light &from, struct scene_light &to) {
    copy_name(to.name, from.name);
    to.type = from.type == "spot"    ? EMITTER_SPOT
              : from.type == "point" ? EMITTER_POINT
                                     : EMITTER_DIRECTIONAL;
    float color[3] = {1, 1, 1};
    if (!copy_numbers(from.color, color, "color"))
        return false;
    for (int c = 0; c < 3; c++) {
        to.intensity[c] = float(color[c] * from.intensity);
        if (!(to.intensity[c] >= 0) || !std::isfinite(to.intensity[c]))
            return error_set("intensity: it is negative or too large");
    }
    to.range = from.range > 0 ? float(from.range) : INFINITY;
    to.inner = float(from.spot.innerConeAngle);
    to.outer = float(from.spot.outerConeAngle);
    if (to.type == EMITTER_SPOT &&
        !(to.inner >= 0 && to.inner <= to.outer && to.outer > 0 && to.outer <= half_pi))
        return error_set("a cone from %g to %g radians", to.inner, to.outer);
    return true;
}

bool load_perspective(const tinygltf::PerspectiveCamera &from, struct scene_camera &to) {
    to.fov_y = float(from.yfov);
    return (to.fov_y > 0 && to.fov_y < 2 * half_pi) || error_set("yfov: %g radians", to.fov_y);
}

bool load_orthographic(const tinygltf::OrthographicCamera &from, struct scene_camera &to) {
    to.orthographic = true;
    to.y_extent = float(std::fabs(from.ymag));
    return (to.y_extent > 0 && std::isfinite(to.y_extent)) ||
           error_set("ymag: %g m", double(to.y_extent));
}

bool load_camera(const tinygltf::Camera &from, struct scene_camera &to) {
    copy_name(to.name, from.name);
    return from.type == "perspective" ? load_perspective(from.perspective, to)
                                      : load_orthographic(from.orthographic, to);
}

} // namespace

bool load_lights(Loader &loader) {
    const auto &from = loader.model.lights;
    struct scene *scene = loader.scene;
    scene->lights = allocate<struct scene_light>(from.size());
    scene->light_count = int(from.size());
    for (size_t i = 0; i < from.size(); i++)
        if (!load_light(from[i], scene->lights[i]))
            return error_prefix("%s", label("light", i, from[i].name).c_str());
    return true;
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
