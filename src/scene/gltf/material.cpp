/* Materials and the textures that they use. */
#include "scene/gltf/model.hpp"

#include <algorithm>

namespace gltf {
namespace {

bool decode_image(const Loader &loader, const tinygltf::Image &image, struct bitmap &bitmap) {
    if (image.bufferView >= 0)
        return bitmap_decode(&bitmap, view_bytes(loader.model, image.bufferView),
                             loader.model.bufferViews[image.bufferView].byteLength);
    if (!image.image.empty())
        return bitmap_decode(&bitmap, image.image.data(), image.image.size());
    OwnedBytes file;
    std::string name = decode_uri(image.uri);
    if (!file_read_named(&file, loader.folder.c_str(), name.c_str()))
        return false;
    return bitmap_decode(&bitmap, file.data, file.size) || error_prefix("%s", name.c_str());
}

enum texture_wrap wrap_mode(int gl) {
    return gl == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE     ? TEXTURE_WRAP_CLAMP
           : gl == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? TEXTURE_WRAP_MIRROR
                                                         : TEXTURE_WRAP_REPEAT;
}

/* The scene's texture for one of the file's; a picture used with one sampler is decoded once. */
bool load_texture(Loader &loader, int index, int &out) {
    const Model &model = loader.model;
    const tinygltf::Texture &texture = model.textures[index];
    if (texture.source < 0)
        return error_set("texture %d: it has no source", index);
    auto &keys = loader.texture_keys;
    std::pair<int, int> key(texture.source, texture.sampler);
    auto known = std::find(keys.begin(), keys.end(), key);
    out = int(known - keys.begin());
    if (known != keys.end())
        return true;
    const tinygltf::Image &image = model.images[texture.source];
    struct scene_texture &made = loader.scene->textures[out];
    tinygltf::Sampler sampler;
    if (texture.sampler >= 0)
        sampler = model.samplers[texture.sampler];
    made.wrap_u = wrap_mode(sampler.wrapS);
    made.wrap_v = wrap_mode(sampler.wrapT);
    made.nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
    if (!decode_image(loader, image, made.bitmap))
        return error_prefix("%s", label("image", texture.source, image.name).c_str());
    keys.push_back(key);
    loader.scene->texture_count++;
    return true;
}

/* A number of an extension, or of an array in it. */
double number_of(const tinygltf::Value &object, const char *key, int i, double otherwise) {
    if (!object.Has(key))
        return otherwise;
    const tinygltf::Value &value = object.Get(key);
    return (value.IsArray() ? value.Get(i) : value).GetNumberAsDouble();
}

UvSource uv_source(const tinygltf::TextureInfo &info) {
    UvSource source;
    source.set = info.texCoord;
    auto found = info.extensions.find("KHR_texture_transform");
    if (found == info.extensions.end())
        return source;
    const tinygltf::Value &transform = found->second;
    source.set = int(number_of(transform, "texCoord", 0, info.texCoord));
    source.rotation = number_of(transform, "rotation", 0, 0);
    for (int i = 0; i < 2; i++) {
        source.offset[i] = number_of(transform, "offset", i, 0);
        source.scale[i] = number_of(transform, "scale", i, 1);
    }
    return source;
}

bool load_material(Loader &loader, const tinygltf::Material &from, struct material &to,
                   UvSource &uv) {
    copy_name(to.name, from.name);
    const auto &pbr = from.pbrMetallicRoughness;
    to.texture = -1;
    to.double_sided = from.doubleSided;
    to.alpha_mask = from.alphaMode == "MASK";
    uv = uv_source(pbr.baseColorTexture);
    return copy_numbers({from.alphaCutoff}, &to.alpha_cutoff, "alphaCutoff") &&
           copy_numbers(pbr.baseColorFactor, to.base_color, "baseColorFactor") &&
           (pbr.baseColorTexture.index < 0 ||
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
