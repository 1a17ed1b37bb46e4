/* The file's scenes and material variants, and which of them the user asks for. */
#include "scene/gltf/model.hpp"

namespace gltf {
namespace {

const char *const variants = "KHR_materials_variants";

void add_name(struct choice_list &list, const std::string &name) {
    list.names[list.count++] = mem_strdup(clean(name).c_str());
}

void list_scenes(Loader &loader) {
    struct choice_list &list = loader.scene->scenes;
    const Model &model = loader.model;
    list.names = allocate<char *>(model.scenes.size());
    for (const tinygltf::Scene &scene : model.scenes)
        add_name(list, scene.name);
    list.shown = std::max(model.defaultScene, 0);
}

void list_variants(Loader &loader) {
    struct choice_list &list = loader.scene->variants;
    auto found = loader.model.extensions.find(variants);
    list.shown = -1;
    if (found == loader.model.extensions.end())
        return;
    const tinygltf::Value &all = found->second.Get("variants");
    list.names = allocate<char *>(all.ArrayLen());
    for (size_t i = 0; i < all.ArrayLen(); i++)
        add_name(list, all.Get(int(i)).Get("name").Get<std::string>());
}

bool has_number(const tinygltf::Value &list, int number) {
    for (size_t i = 0; i < list.ArrayLen(); i++)
        if (list.Get(int(i)).GetNumberAsInt() == number)
            return true;
    return false;
}

} // namespace

bool load_choice(Loader &loader, const struct scene_choice &choice) {
    list_scenes(loader);
    list_variants(loader);
    bool ok = choice_set(&loader.scene->scenes, "scene", choice.scene) &&
              choice_set(&loader.scene->variants, "variant", choice.variant);
    loader.model.defaultScene = loader.scene->scenes.shown;
    return ok;
}

int material_of(const Loader &loader, const tinygltf::Primitive &primitive) {
    auto found = primitive.extensions.find(variants);
    if (found == primitive.extensions.end() || loader.scene->variants.shown < 0)
        return primitive.material;
    const tinygltf::Value &mappings = found->second.Get("mappings");
    for (size_t i = 0; i < mappings.ArrayLen(); i++)
        if (has_number(mappings.Get(int(i)).Get("variants"), loader.scene->variants.shown))
            return mappings.Get(int(i)).Get("material").GetNumberAsInt();
    return primitive.material;
}

} // namespace gltf
