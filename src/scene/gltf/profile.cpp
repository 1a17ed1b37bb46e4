/* EXT_lights_ies, and our own extras of a point light: {"profile": "lamp.ies"}, the file of a light
 * profile (scene/lights/profile.h). */
#include "scene/gltf/model.hpp"

extern "C" {
#include "scene/gltf/data_uri.h"
#include "scene/lights/profile.h"
}

namespace gltf {
namespace {

/* Takes a slide from the file's text; `mean` is the profile's intensity. */
bool add_slide(Loader &loader, const std::string &text, float &mean) {
    struct scene *scene = loader.scene;
    struct profile profile;
    if (!profile_parse(&profile, text.c_str()))
        return false;
    bool good = spend(loader, uint64_t(slide_profile_size(&profile)), 4 * sizeof(float));
    if (good) {
        struct slide *slide = &scene->slides[scene->slide_count];
        mean = slide_init_profile(slide, scene->slide_count++, &profile);
    }
    profile_free(&profile);
    return good;
}

bool add_uri(Loader &loader, const std::string &uri, float &mean) {
    OwnedBytes bytes;
    enum file_lack lack;
    bool is_data = data_uri_is(uri.c_str());
    if (is_data ? !data_uri_decode(&bytes, uri.c_str()) : !read_uri(loader, uri, bytes, lack))
        return false;
    return add_slide(loader, std::string(bytes.data, bytes.data + bytes.size), mean) ||
           error_prefix("%s", is_data ? "data" : clean(uri).c_str());
}

bool add_view(Loader &loader, int view, float &mean) {
    const unsigned char *bytes = view_bytes(loader.model, view);
    return add_slide(loader,
                     std::string(bytes, bytes + loader.model.bufferViews[size_t(view)].byteLength),
                     mean) ||
           error_prefix("buffer view %d", view);
}

/* The lights of the file's extension. */
const tinygltf::Value *listed(const Model &model) {
    const auto found = model.extensions.find("EXT_lights_ies");
    return found == model.extensions.end() ? nullptr : &found->second.Get("lights");
}

/* A factor of the light's, also where a clip moves it. */
void set_mean(struct scene_light &light, float mean) {
    light.scale = mean;
    for (int c = 0; c < 3; c++)
        light.intensity[c] = light.color[c] * light.strength * light.scale;
}

} // namespace

size_t count_profiles(const Model &model) {
    const tinygltf::Value *lights = listed(model);
    return lights ? lights->ArrayLen() : 0;
}

bool load_profiles(Loader &loader) {
    for (size_t i = 0; i < count_profiles(loader.model); i++) {
        const tinygltf::Value &from = listed(loader.model)->Get(int(i));
        float mean = 0;
        bool good = from.Has("uri") ? add_uri(loader, from.Get("uri").Get<std::string>(), mean)
                    : from.Has("bufferView")
                        ? add_view(loader, from.Get("bufferView").GetNumberAsInt(), mean)
                        : error_set("neither uri nor bufferView");
        if (!good)
            return error_prefix("light profile %zu", i);
        loader.profiles.push_back({loader.scene->slide_count, mean});
    }
    return true;
}

bool load_profile(Loader &loader, const tinygltf::Value &extras, struct scene_light &light) {
    if (!extras.IsObject() || !extras.Has("profile"))
        return true;
    const tinygltf::Value &name = extras.Get("profile");
    bool good = !name.IsString() ? error_set("it is no file's name")
                : light.type != EMITTER_POINT || light.size[0] > 0
                    ? error_set("only a point light without a radius has one")
                    : true;
    const std::string file = good ? name.Get<std::string>() : "";
    if (good && !loader.files_of_profiles.count(file)) {
        float mean = 0;
        good = add_uri(loader, file, mean);
        if (good)
            loader.files_of_profiles[file] = {loader.scene->slide_count, mean};
    }
    if (!good)
        return error_prefix("extras: profile");
    const Profile &profile = loader.files_of_profiles[file];
    light.slide = profile.slide;
    set_mean(light, profile.mean);
    return true;
}

int add_profile_light(Loader &loader, const tinygltf::Node &node) {
    const auto found = node.extensions.find("EXT_lights_ies");
    if (found == node.extensions.end())
        return -1;
    const tinygltf::Value &from = found->second;
    const Profile &profile = loader.profiles[size_t(from.Get("light").GetNumberAsInt())];
    struct scene_light &to = loader.scene->lights[loader.scene->light_count];
    copy_name(to.name, node.name);
    to.type = EMITTER_POINT;
    to.range = INFINITY;
    to.slide = profile.slide;
    to.strength = from.Has("multiplier") ? float(from.Get("multiplier").GetNumberAsDouble()) : 1;
    for (size_t c = 0; c < 3; c++)
        to.color[c] =
            from.Has("color") ? float(from.Get("color").Get(int(c)).GetNumberAsDouble()) : 1;
    set_mean(to, profile.mean);
    return loader.scene->light_count++;
}

} // namespace gltf
