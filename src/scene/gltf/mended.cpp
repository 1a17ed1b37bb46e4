/* Small defects of a file that are mended, and told: what other readers open, opens here. */
#include "scene/gltf/json.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace gltf {

bool mend(Loader &loader, const std::string &what, const std::string &object) {
    if (read_rules_are_strict())
        return error_set("%s (%s, but for --strict)", object.c_str(), what.c_str());
    auto &mended = loader.mended;
    auto known = std::find_if(mended.begin(), mended.end(),
                              [&](const Mended &other) { return other.what == what; });
    if (known != mended.end())
        known->count++;
    else
        mended.push_back({what, object, 1});
    return true;
}

void tell_mended(const Loader &loader) {
    for (const Mended &mended : loader.mended) {
        std::string others;
        if (mended.count > 1)
            others = " (and " + std::to_string(mended.count - 1) + " more)";
        log_note("%s: %s: %.300s%s", loader.scene->path, mended.what.c_str(), mended.first.c_str(),
                 others.c_str());
    }
}

namespace {

bool mend_rotation(Loader &loader, json &node, const std::string &object) {
    double length = 0;
    for (const json &number : node["rotation"])
        length = std::hypot(length, number.get<double>());
    if (length >= 1e-6)
        return true;
    node.erase("rotation");
    return mend(loader, "a quaternion of length 0 turns nothing", object + ": rotation");
}

/* The standard's last row is 0 0 0 1; one that is farther off is refused later. */
bool mend_matrix(Loader &loader, json &node, const std::string &object) {
    json &matrix = node["matrix"];
    bool off = false;
    for (size_t k = 3; k < 16; k += 4) {
        double distance = std::fabs(matrix[k].get<double>() - (k == 15 ? 1 : 0));
        if (distance > rounding)
            return true;
        off |= distance > 0;
    }
    for (size_t k = 3; k < 16; k += 4)
        matrix[k] = k == 15 ? 1 : 0;
    return !off || mend(loader, "a last row of a matrix that is almost 0 0 0 1 is that",
                        object + ": matrix");
}

bool mend_nodes(Loader &loader, json &root) {
    for (size_t i = 0; i < list_size(root, "/nodes"); i++) {
        json &node = root["nodes"][i];
        std::string object = label_of("node", i, node);
        if ((node.contains("rotation") && !mend_rotation(loader, node, object)) ||
            (node.contains("matrix") && !mend_matrix(loader, node, object)))
            return false;
    }
    return true;
}

/* A number that is beyond its bound by no more than rounding, or by more where there are words for
 * it. */
bool mend_bound(Loader &loader, json &object, const char *key, double least, double most,
                const std::string &where, const char *beyond = nullptr) {
    auto found = object.find(key);
    if (found == object.end())
        return true;
    double number = found->get<double>(), clamped = std::min(std::max(number, least), most);
    bool rounded = std::fabs(clamped - number) <= rounding;
    if (clamped == number || (!rounded && !beyond))
        return true;
    *found = clamped;
    return mend(loader, rounded ? "numbers that are off by rounding are clamped" : beyond,
                where + ": " + key);
}

/* Angles of spots: from next to nothing to a half space, the inner one within the outer. */
bool mend_spots(Loader &loader, json &root) {
    const double half_pi = 1.5707963267948966, least = 1e-6;
    const char *const beyond = "angles of a spot that make no cone are clamped";
    const char *const lights = "/extensions/KHR_lights_punctual/lights";
    for (size_t i = 0; i < list_size(root, lights); i++) {
        json &light = root[json::json_pointer(lights)][i];
        if (!light.contains("spot"))
            continue;
        json &spot = light["spot"];
        std::string object = label_of("light", i, light);
        if (!mend_bound(loader, spot, "outerConeAngle", least, half_pi, object, beyond) ||
            !mend_bound(loader, spot, "innerConeAngle", 0,
                        spot.value("outerConeAngle", half_pi / 2), object, beyond))
            return false;
    }
    return true;
}

bool mend_materials(Loader &loader, json &root) {
    const json::json_pointer ior("/extensions/KHR_materials_ior");
    for (size_t i = 0; i < list_size(root, "/materials"); i++) {
        json &material = root["materials"][i];
        if (material.contains(ior) && material[ior].value("ior", 1.5) > .5 &&
            !mend_bound(loader, material[ior], "ior", 1, HUGE_VAL,
                        label_of("material", i, material)))
            return false;
    }
    return true;
}

/* The depths that a camera sees; tinygltf wants both numbers of an orthographic one. */
bool mend_depths(Loader &loader, json &depths, bool is_orthographic, const std::string &object) {
    double near = depths.value("znear", -1.), far = depths.value("zfar", HUGE_VAL);
    bool is_near_good = is_orthographic ? near >= 0 : near > 0;
    if (!is_near_good || near > camera_depth_most) {
        depths["znear"] = near = 0;
        if (!mend(loader, "a camera's znear that is missing or no distance is taken as 0",
                  object + ": znear"))
            return false;
    }
    if (!depths.contains("zfar") && !is_orthographic)
        return true;
    if (depths.contains("zfar") && far > near)
        return true;
    depths["zfar"] = 0;
    return mend(loader, "a camera's zfar that is missing or not beyond its znear is ignored",
                object + ": zfar");
}

bool mend_cameras(Loader &loader, json &root) {
    for (size_t i = 0; i < list_size(root, "/cameras"); i++) {
        json &camera = root["cameras"][i];
        bool is_orthographic = camera["type"] == "orthographic";
        if (!mend_depths(loader, camera[is_orthographic ? "orthographic" : "perspective"],
                         is_orthographic, label_of("camera", i, camera)))
            return false;
    }
    return true;
}

double number_or(const json &object, const char *key, double otherwise) {
    auto found = object.find(key);
    return found != object.end() && found->is_number() ? found->get<double>() : otherwise;
}

/* Why a light shines nowhere; NULL: it may. */
const char *darkness_of(const json &light, const char *types) {
    auto type = light.find("type");
    bool known = type == light.end() || !type->is_string() ||
                 strstr(types, (" " + type->get<std::string>() + " ").c_str());
    return !known ? "lights of an unknown type are left out"
           : number_or(light, "intensity", 1) < -rounding
               ? "lights of less than no light are left out"
               : nullptr;
}

/* Colours have no channel below 0. */
bool mend_color(Loader &loader, json &light, const std::string &object) {
    bool mended = false;
    for (json &channel : light["color"])
        if (channel.is_number() && channel.get<double>() < -rounding) {
            channel = 0;
            mended = true;
        }
    return !mended ||
           mend(loader, "channels of a light below 0 are taken as 0", object + ": color");
}

/* Takes the light from the nodes that have it. */
void leave_out(json &root, const char *extension, size_t light) {
    const json::json_pointer at(std::string("/extensions/") + extension + "/light");
    for (size_t i = 0; i < list_size(root, "/nodes"); i++) {
        json &node = root["nodes"][i];
        if (node.is_object() && node.contains(at) && node[at] == light)
            node["extensions"].erase(extension);
    }
}

bool mend_kind(Loader &loader, json &root, const char *extension, const char *types,
               const char *dark) {
    const std::string lights = std::string("/extensions/") + extension + "/lights";
    for (size_t i = 0; i < list_size(root, lights.c_str()); i++) {
        json &light = root[json::json_pointer(lights)][i];
        if (!light.is_object())
            continue;
        std::string object = label_of("light", i, light);
        const char *reason = darkness_of(light, types);
        if (!reason) {
            if (light.contains("color") && !mend_color(loader, light, object))
                return false;
            continue;
        }
        light = {{"type", dark}, {"intensity", 0}};
        leave_out(root, extension, i);
        if (!mend(loader, reason, object))
            return false;
    }
    return true;
}

} // namespace

bool mend_lights(Loader &loader, json &root) {
    return mend_kind(loader, root, "KHR_lights_punctual", " directional point spot ", "point") &&
           mend_kind(loader, root, "EXT_lights_area", " rect disk ", "disk");
}

bool mend_numbers(Loader &loader, json &root) {
    return mend_nodes(loader, root) && mend_spots(loader, root) && mend_materials(loader, root) &&
           mend_cameras(loader, root);
}

} // namespace gltf
