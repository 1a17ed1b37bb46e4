/* Our own extras, of the scene that is shown or of the asset: {"environment": "sky.exr"}, a
 * panorama beside the file, and how it is turned (degrees) and how strong it is. */
#include "scene/gltf/model.hpp"

extern "C" {
#include "scene/lights/environment.h"
}

#include <cmath>

namespace gltf {

const tinygltf::Value *find_extras(const Model &model, const char *key) {
    size_t shown = model.defaultScene >= 0 ? size_t(model.defaultScene) : 0;
    if (shown < model.scenes.size() && model.scenes[shown].extras.Has(key))
        return &model.scenes[shown].extras;
    return model.asset.extras.Has(key) ? &model.asset.extras : nullptr;
}

namespace {

bool read_number(const tinygltf::Value &extras, const char *key, float &to) {
    if (!extras.Has(key))
        return true;
    const tinygltf::Value &value = extras.Get(key);
    to = value.IsNumber() ? float(value.GetNumberAsDouble()) : NAN;
    return std::isfinite(to) || error_set("%s: it is no number", key);
}

bool read_desc(const tinygltf::Value &extras, struct environment_desc &desc) {
    return read_number(extras, "environmentTurn", desc.turn) &&
           read_number(extras, "environmentStrength", desc.strength) &&
           (desc.strength > 0 || error_set("environmentStrength: it is not above 0"));
}

} // namespace

bool load_environment(Loader &loader) {
    const tinygltf::Value *extras = find_extras(loader.model, "environment");
    struct environment_desc desc = {nullptr, 0, 1};
    if (!extras)
        return true;
    const tinygltf::Value &name = extras->Get("environment");
    if (!name.IsString())
        return error_set("extras: environment: it is no file's name");
    if (!read_desc(*extras, desc))
        return error_prefix("extras");
    enum file_lack lack;
    char *path = file_find_named(loader.folder.c_str(), name.Get<std::string>().c_str(), &lack);
    desc.path = path;
    /* No pipe, which only the user may name. */
    bool good =
        path && file_can_be_read(path) && environment_follow(&loader.scene->environment, &desc);
    free(path);
    return good || error_prefix("extras: environment");
}

} // namespace gltf
