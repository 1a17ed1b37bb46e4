/* KHR_lights_punctual, and cameras. */
#include "scene/gltf_model.hpp"

#include <cmath>

namespace gltf {
namespace {

const float half_pi = 1.5707964F;

bool load_light(const tinygltf::Light &from, struct scene_light &to) {
    copy_name(to.name, from.name);
    if (from.type == "spot")
        to.type = LIGHT_SPOT;
    else if (from.type == "point")
        to.type = LIGHT_POINT;
    else if (from.type == "directional")
        to.type = LIGHT_DIRECTIONAL;
    else
        return error_set("there is no type '%.40s'", from.type.c_str());
    float color[3] = {1, 1, 1};
    if (!copy_numbers(from.color, color, 3, "its color"))
        return false;
    for (int c = 0; c < 3; c++) {
        to.intensity[c] = float(color[c] * from.intensity);
        if (!(to.intensity[c] >= 0) || !std::isfinite(to.intensity[c]))
            return error_set("its intensity is negative or not finite");
    }
    to.inner = float(from.spot.innerConeAngle);
    to.outer = float(from.spot.outerConeAngle);
    if (to.type == LIGHT_SPOT && !(to.inner >= 0 && to.inner < to.outer && to.outer <= half_pi))
        return error_set("a cone from %g to %g radians", to.inner, to.outer);
    return true;
}

bool load_camera(const tinygltf::Camera &from, struct scene_camera &to) {
    copy_name(to.name, from.name);
    to.orthographic = from.type == "orthographic";
    if (to.orthographic) {
        to.y_extent = float(std::fabs(from.orthographic.ymag));
        to.near = float(from.orthographic.znear);
        to.far = float(from.orthographic.zfar);
    } else {
        to.fov_y = float(from.perspective.yfov);
        to.near = float(from.perspective.znear);
        to.far = from.perspective.zfar > 0 ? float(from.perspective.zfar) : INFINITY;
    }
    if (to.orthographic ? !(to.y_extent > 0 && std::isfinite(to.y_extent))
                        : !(to.fov_y > 0 && to.fov_y < 2 * half_pi))
        return error_set("a view of %g %s", to.orthographic ? to.y_extent : to.fov_y,
                         to.orthographic ? "m" : "radians");
    return true;
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
