/* The bridge to tinygltf. No exception leaves it. */
#include "scene/gltf_model.hpp"

extern "C" {
#include "scene/gltf.h"
}

#include <algorithm>
#include <cmath>
#include <cstring>

namespace gltf {

std::string label(const char *noun, size_t index, const std::string &name) {
    std::string text = noun + (" " + std::to_string(index));
    return name.empty() ? text : text + " '" + name + "'";
}

void copy_name(char to[SCENE_NAME_SIZE], const std::string &from) {
    size_t size = std::min(from.size(), size_t(SCENE_NAME_SIZE - 1));
    while (size < from.size() && size > 0 && (from[size] & 0xC0) == 0x80)
        size--;
    for (size_t i = 0; i < size; i++)
        to[i] = (unsigned char)from[i] < 32 || from[i] == 127 ? '?' : from[i];
    to[size] = 0;
}

bool copy_numbers(const std::vector<double> &from, float *to, size_t count, const char *what) {
    if (from.empty())
        return true;
    if (from.size() != count)
        return error_set("%s has %zu numbers, not %zu", what, from.size(), count);
    for (size_t i = 0; i < count; i++) {
        to[i] = float(from[i]);
        if (!std::isfinite(to[i]))
            return error_set("%s is not finite", what);
    }
    return true;
}

namespace {

/* Every extension that changes what we read. */
const char *const known_extensions[] = {"KHR_lights_punctual", "KHR_texture_transform",
                                        "KHR_mesh_quantization"};

bool is_known(const std::string &extension) {
    for (const char *known : known_extensions)
        if (extension == known)
            return true;
    return false;
}

bool check_version(const Model &model, const char *path) {
    if (model.asset.version.compare(0, 2, "2.") != 0)
        return error_set("glTF version '%.20s', not 2.0", model.asset.version.c_str());
    std::string ignored;
    for (const std::string &extension : model.extensionsRequired)
        if (!is_known(extension))
            return error_set("it requires the extension '%.80s'", extension.c_str());
    for (const std::string &extension : model.extensionsUsed)
        if (!is_known(extension))
            ignored += " " + extension;
    if (!ignored.empty())
        log_warning("%s: extensions that are ignored:%.400s", path, ignored.c_str());
    return true;
}

} // namespace
} // namespace gltf

extern "C" bool gltf_load(struct scene *scene, const char *path) try {
    using namespace gltf;
    Loader loader;
    loader.scene = scene;
    loader.folder = path;
    loader.folder.resize(loader.folder.find_last_of('/') + 1);
    scene->path = mem_strdup(path);
    if (!parse(loader, path))
        return false;
    return (check_version(loader.model, path) && load_materials(loader) && load_meshes(loader) &&
            load_lights(loader) && load_cameras(loader) && load_nodes(loader)) ||
           error_prefix("%s", path);
} catch (const std::exception &error) {
    return error_set("%s: %s", path, error.what());
}
