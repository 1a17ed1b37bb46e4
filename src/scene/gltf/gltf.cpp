/* The bridge to tinygltf. No exception leaves it. */
#include "scene/gltf/model.hpp"

extern "C" {
#include "scene/gltf/gltf.h"
}

#include <cmath>
#include <cstring>

namespace gltf {

std::string clean(const std::string &text) {
    std::string out = text.substr(0, SCENE_NAME_SIZE - 1);
    while (out.size() < text.size() && !out.empty() && (text[out.size()] & 0xC0) == 0x80)
        out.pop_back();
    for (char &c : out)
        if ((unsigned char)c < 32 || c == 127)
            c = '?';
    return out;
}

std::string label(const char *noun, size_t index, const std::string &name) {
    std::string text = noun + (" " + std::to_string(index));
    return name.empty() ? text : text + " '" + clean(name) + "'";
}

void copy_name(char to[SCENE_NAME_SIZE], const std::string &from) {
    strcpy(to, clean(from).c_str());
}

bool copy_numbers(const std::vector<double> &from, float *to, const char *what) {
    for (size_t i = 0; i < from.size(); i++) {
        to[i] = float(from[i]);
        if (!std::isfinite(to[i]))
            return error_set("%s: %g is too large", what, from[i]);
    }
    return true;
}

namespace {

/* Every extension that changes what we read. */
const char *const known_extensions[] = {"KHR_lights_punctual", "EXT_lights_area",
                                        "KHR_materials_emissive_strength", "KHR_texture_transform",
                                        "KHR_mesh_quantization"};

bool is_known(const std::string &extension) {
    for (const char *known : known_extensions)
        if (extension == known)
            return true;
    return false;
}

bool check_version(const tinygltf::Asset &asset) {
    if (asset.version.compare(0, 2, "2.") != 0)
        return error_set("glTF version '%s', not 2.0", clean(asset.version).c_str());
    if (!asset.minVersion.empty() && asset.minVersion != "2.0")
        return error_set("it needs glTF version '%s'", clean(asset.minVersion).c_str());
    return true;
}

bool check_extensions(const Model &model, const char *path) {
    for (const std::string &extension : model.extensionsRequired)
        if (!is_known(extension))
            return error_set("it requires the extension '%s'", clean(extension).c_str());
    std::string ignored;
    for (const std::string &extension : model.extensionsUsed)
        if (!is_known(extension))
            ignored += " " + clean(extension);
    if (!ignored.empty())
        log_warning("%s: extensions that are ignored:%.400s", path, ignored.c_str());
    return true;
}

void list_files(Loader &loader) {
    std::vector<std::string> uris;
    for (const tinygltf::Buffer &buffer : loader.model.buffers)
        uris.push_back(buffer.uri);
    for (const tinygltf::Image &image : loader.model.images)
        uris.push_back(image.uri);
    struct scene &scene = *loader.scene;
    scene.files = allocate<char *>(uris.size());
    for (const std::string &uri : uris)
        if (!uri.empty() && uri.compare(0, 5, "data:") != 0)
            scene.files[scene.file_count++] = mem_strdup((loader.folder + decode_uri(uri)).c_str());
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
    list_files(loader);
    return (check_version(loader.model.asset) && check_extensions(loader.model, path) &&
            load_materials(loader) && load_meshes(loader) && load_lights(loader) &&
            load_cameras(loader) && load_nodes(loader) && load_skins(loader) &&
            load_clips(loader) && load_environment(loader)) ||
           error_prefix("%s", path);
} catch (const std::exception &error) {
    /* A JSON library begins with its own name in brackets. */
    const char *bracket = strstr(error.what(), "] ");
    return error_set("%s: %s", path, bracket ? bracket + 2 : error.what());
}
