/* Materials and the textures that they use. */
#include "scene/gltf_model.hpp"

#include <cmath>
#include <cstdlib>

namespace gltf {
namespace {

bool decode_image(Loader &loader, int index, struct bitmap &bitmap) {
    const tinygltf::Image &image = loader.model.images[index];
    if (image.bufferView >= 0) {
        const unsigned char *bytes;
        size_t size;
        return view_bytes(loader.model, image.bufferView, 0, &bytes, &size) &&
               bitmap_decode(&bitmap, bytes, size);
    }
    if (!image.image.empty())
        return bitmap_decode(&bitmap, image.image.data(), image.image.size());
    struct file_bytes file;
    std::string name = decode_uri(image.uri);
    if (!file_read_named(&file, loader.folder.c_str(), name.c_str()))
        return false;
    bool good = bitmap_decode(&bitmap, file.data, file.size);
    free(file.data);
    return good || error_prefix("%s", name.c_str());
}

enum texture_wrap wrap_mode(int gl) {
    return gl == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE     ? TEXTURE_WRAP_CLAMP
           : gl == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? TEXTURE_WRAP_MIRROR
                                                         : TEXTURE_WRAP_REPEAT;
}

/* The scene's texture for one of the file's; a picture used with one sampler is decoded once. */
bool load_texture(Loader &loader, int index, int &out) {
    const Model &model = loader.model;
    if (index < 0 || size_t(index) >= model.textures.size())
        return error_set("there is no texture %d", index);
    const tinygltf::Texture &texture = model.textures[index];
    if (texture.source < 0 || size_t(texture.source) >= model.images.size())
        return error_set("texture %d: there is no image %d", index, texture.source);
    if (texture.sampler >= int(model.samplers.size()))
        return error_set("texture %d: there is no sampler %d", index, texture.sampler);
    std::pair<int, int> key(texture.source, texture.sampler);
    for (size_t i = 0; i < loader.texture_keys.size(); i++)
        if (loader.texture_keys[i] == key) {
            out = int(i);
            return true;
        }
    struct scene_texture &made = loader.scene->textures[loader.scene->texture_count];
    tinygltf::Sampler sampler;
    if (texture.sampler >= 0)
        sampler = model.samplers[texture.sampler];
    made.wrap_u = wrap_mode(sampler.wrapS);
    made.wrap_v = wrap_mode(sampler.wrapT);
    made.nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
    if (!decode_image(loader, texture.source, made.bitmap))
        return error_prefix(
            "%s", label("image", texture.source, model.images[texture.source].name).c_str());
    loader.texture_keys.push_back(key);
    out = loader.scene->texture_count++;
    return true;
}

bool numbers_of(const tinygltf::Value &object, const char *key, double *out, int count) {
    if (!object.Has(key))
        return true;
    const tinygltf::Value &list = object.Get(key);
    if (count > 1 && int(list.ArrayLen()) != count)
        return error_set("KHR_texture_transform: %s has not %d numbers", key, count);
    for (int i = 0; i < count; i++) {
        const tinygltf::Value &number = count > 1 ? list.Get(i) : list;
        if (!number.IsNumber() || !std::isfinite(number.GetNumberAsDouble()))
            return error_set("KHR_texture_transform: %s is not a number", key);
        out[i] = number.GetNumberAsDouble();
    }
    return true;
}

bool load_uv_source(const tinygltf::TextureInfo &info, UvSource &out) {
    out.set = info.texCoord;
    auto found = info.extensions.find("KHR_texture_transform");
    if (found == info.extensions.end())
        return true;
    double set = out.set;
    if (!numbers_of(found->second, "offset", out.offset, 2) ||
        !numbers_of(found->second, "rotation", &out.rotation, 1) ||
        !numbers_of(found->second, "scale", out.scale, 2) ||
        !numbers_of(found->second, "texCoord", &set, 1))
        return false;
    out.set = int(std::fmax(0, std::fmin(set, 99)));
    return true;
}

bool load_material(Loader &loader, const tinygltf::Material &from, struct material &to,
                   UvSource &uv) {
    copy_name(to.name, from.name);
    const auto &pbr = from.pbrMetallicRoughness;
    to.texture = -1;
    to.double_sided = from.doubleSided;
    to.alpha_mask = from.alphaMode == "MASK";
    to.alpha_cutoff = float(from.alphaCutoff);
    if (!std::isfinite(to.alpha_cutoff))
        return error_set("the alpha cutoff is not finite");
    if (!copy_numbers(pbr.baseColorFactor, to.base_color, 4, "the base colour"))
        return false;
    return pbr.baseColorTexture.index < 0 ||
           (load_uv_source(pbr.baseColorTexture, uv) &&
            load_texture(loader, pbr.baseColorTexture.index, to.texture));
}

} // namespace

/* One material more than the file has: the standard's default, white, for primitives without. */
bool load_materials(Loader &loader) {
    const auto &from = loader.model.materials;
    struct scene *scene = loader.scene;
    scene->materials = allocate<struct material>(from.size() + 1);
    scene->textures = allocate<struct scene_texture>(from.size());
    scene->material_count = int(from.size()) + 1;
    loader.uv_sources.resize(from.size() + 1);
    bool blended = false;
    for (size_t i = 0; i < from.size(); i++) {
        blended |= from[i].alphaMode == "BLEND";
        if (!load_material(loader, from[i], scene->materials[i], loader.uv_sources[i]))
            return error_prefix("%s", label("material", i, from[i].name).c_str());
    }
    struct material &fallback = scene->materials[from.size()];
    copy_name(fallback.name, "default");
    fallback.texture = -1;
    for (float &c : fallback.base_color)
        c = 1;
    if (blended)
        log_warning("%s: alpha mode BLEND is drawn opaque", scene->path);
    return true;
}

} // namespace gltf
