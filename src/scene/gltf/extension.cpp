/* Extensions: which are read, which are refused by name, and what a scene is shown without. */
#include "scene/gltf/json.hpp"

#include <algorithm>
#include <cstring>

namespace gltf {
namespace {

/* What a scene lacks where an extension is not read; NULL = nothing, as it is read or changes no
 * picture, or as textures have another picture: texture.cpp. */
const struct Known {
    const char *name, *lack;
} known[] = {
    {"EXT_lights_area", nullptr},
    {"EXT_lights_ies", nullptr},
    {"EXT_mesh_gpu_instancing", nullptr},
    {"EXT_meshopt_compression", nullptr},
    {"EXT_texture_avif", nullptr},
    {"EXT_texture_webp", nullptr},
    {"KHR_animation_pointer", nullptr},
    {"KHR_draco_mesh_compression", nullptr},
    {"KHR_lights_punctual", nullptr},
    {"KHR_materials_emissive_strength", nullptr},
    {"KHR_materials_ior", nullptr},
    {"KHR_materials_pbrSpecularGlossiness", nullptr},
    {"KHR_materials_specular", nullptr},
    {"KHR_materials_unlit", nullptr},
    {"KHR_mesh_quantization", nullptr},
    {"KHR_meshopt_compression", nullptr},
    {"KHR_node_visibility", nullptr},
    {"KHR_texture_basisu", nullptr},
    {"KHR_texture_transform", nullptr},
    {"KHR_xmp", nullptr},
    {"KHR_xmp_json_ld", nullptr},
    {"MSFT_texture_dds", nullptr},
    {"KHR_materials_anisotropy", "anisotropy"},
    {"KHR_materials_clearcoat", "clear coat"},
    {"KHR_materials_diffuse_transmission", "diffuse transmission"},
    {"KHR_materials_dispersion", "dispersion"},
    {"KHR_materials_iridescence", "iridescence"},
    {"KHR_materials_sheen", "sheen"},
    {"KHR_materials_transmission", nullptr},
    {"KHR_materials_variants", nullptr},
    {"KHR_materials_volume", nullptr},
};

const Known *find_known(const std::string &extension) {
    for (const Known &row : known)
        if (extension == row.name)
            return &row;
    return nullptr;
}

} // namespace

void lack(Loader &loader, const std::string &what) {
    auto &lacks = loader.lacks;
    if (std::find(lacks.begin(), lacks.end(), what) == lacks.end())
        lacks.push_back(what);
}

void tell_lacks(const Loader &loader) {
    std::string list;
    for (const std::string &what : loader.lacks)
        list += (list.empty() ? "" : ", ") + what;
    if (!list.empty())
        log_note("%s: shown without: %.400s", loader.scene->path, list.c_str());
}

bool check_extensions(Loader &loader) {
    for (const std::string &extension : loader.model.extensionsUsed) {
        const Known *row = find_known(extension);
        if (!row || row->lack)
            lack(loader, row ? row->lack : clean(extension));
    }
    return true;
}

namespace {

/* Of the first glTF, lists are objects, and there may be no version. */
bool check_version(Loader &loader, json &root) {
    json none, &version = root.contains("asset") && root["asset"].is_object() &&
                                  root["asset"].contains("version")
                              ? root["asset"]["version"]
                              : none;
    std::string text = version.is_string()   ? version.get<std::string>()
                       : version.is_number() ? version.dump()
                                             : "";
    if (text.empty() && root.contains("meshes") && root["meshes"].is_object())
        text = "1.0";
    if (text.empty())
        return true; /* the table says so */
    if (text != "2" && text.compare(0, 2, "2.") != 0)
        return error_set("glTF version %s; 2.0 is read", clean(text).c_str());
    if (version.is_string() && text != "2")
        return true;
    version = "2.0";
    return mend(loader, "a version that is not \"2.0\" is taken for that", "asset: " + text);
}

} // namespace

bool check_asset(Loader &loader, json &root) {
    if (!check_version(loader, root))
        return false;
    const json::json_pointer least("/asset/minVersion");
    if (root.contains("asset") && root.contains(least) && root[least] != "2.0")
        return error_set("it needs glTF version %s; 2.0 is read", quote(root[least]).c_str());
    for (size_t i = 0; i < list_size(root, "/extensionsRequired"); i++) {
        const json &name = root["extensionsRequired"][i];
        if (!name.is_string() || !find_known(name.get<std::string>()))
            return error_set("it requires the extension %s, which is not read",
                             name.is_string() ? ("'" + clean(name.get<std::string>()) + "'").c_str()
                                              : quote(name).c_str());
    }
    return true;
}

} // namespace gltf
