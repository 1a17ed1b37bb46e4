/* Our own extras, of the scene that is shown or of the asset: {"medium": {"sigma_s": .1, "sigma_a":
 * [0, .1, .2], "g": .5}}, scattering and absorption in 1/m, one number or RGB, and the mean cosine
 * of the scattering. */
#include "scene/gltf/model.hpp"

#include <cmath>

namespace gltf {
namespace {

const double sigma_most = 1e9; /* 1/m */

bool read_sigma(const tinygltf::Value &medium, const char *key, float to[3]) {
    if (!medium.Has(key))
        return true;
    const tinygltf::Value &value = medium.Get(key);
    bool is_rgb = value.IsArray() && value.ArrayLen() == 3;
    for (int c = 0; c < 3; c++) {
        const tinygltf::Value &number = is_rgb ? value.Get(c) : value;
        double sigma = number.IsNumber() ? number.GetNumberAsDouble() : NAN;
        to[c] = float(sigma);
        if (!(sigma >= 0 && sigma <= sigma_most))
            return error_set("%s: it is no number from 0 to %g, nor three", key, sigma_most);
    }
    return true;
}

bool read_g(const tinygltf::Value &medium, float &to) {
    if (!medium.Has("g"))
        return true;
    const tinygltf::Value &value = medium.Get("g");
    to = value.IsNumber() ? float(value.GetNumberAsDouble()) : NAN;
    return std::fabs(to) < 1 || error_set("g: it is no number between -1 and 1");
}

} // namespace

bool load_medium(Loader &loader) {
    const tinygltf::Value *extras = find_extras(loader.model, "medium");
    if (!extras)
        return true;
    const tinygltf::Value &from = extras->Get("medium");
    struct medium &to = loader.scene->medium;
    bool good = (from.IsObject() || error_set("it is no object")) &&
                read_sigma(from, "sigma_s", to.scattering) &&
                read_sigma(from, "sigma_a", to.absorption) && read_g(from, to.g);
    return good || error_prefix("extras: medium");
}

} // namespace gltf
