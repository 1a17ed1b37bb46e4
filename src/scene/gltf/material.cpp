/* Materials. */
#include "scene/gltf/model.hpp"

#include <algorithm>
#include <cmath>

namespace gltf {
namespace {

/* A number of an extension, or of an array in it. */
double number_of(const tinygltf::Value &object, const char *key, int i, double otherwise) {
    if (!object.Has(key))
        return otherwise;
    const tinygltf::Value &value = object.Get(key);
    return (value.IsArray() ? value.Get(i) : value).GetNumberAsDouble();
}

/* A texture that an extension names; its index is -1 where there is none. */
tinygltf::TextureInfo texture_of(const tinygltf::Value &object, const char *key) {
    tinygltf::TextureInfo info;
    if (!object.Has(key))
        return info;
    const tinygltf::Value &texture = object.Get(key);
    info.index = texture.Get("index").GetNumberAsInt();
    info.texCoord = int(number_of(texture, "texCoord", 0, 0));
    if (texture.Has("extensions"))
        for (const std::string &name : texture.Get("extensions").Keys())
            info.extensions[name] = texture.Get("extensions").Get(name);
    return info;
}

/* KHR_materials_pbrSpecularGlossiness, which older files have; NULL = none. */
const tinygltf::Value *specular_glossiness(const tinygltf::Material &from) {
    auto found = from.extensions.find("KHR_materials_pbrSpecularGlossiness");
    return found == from.extensions.end() ? nullptr : &found->second;
}

/* That extension as the standard's own model: its diffuse colour, no metal, and the roughness of
 * its glossiness. Its second texture takes the place of that of metals: load_textures. */
tinygltf::Material as_metallic_roughness(const tinygltf::Material &from) {
    const tinygltf::Value *old = specular_glossiness(from);
    if (!old)
        return from;
    tinygltf::Material to = from;
    to.pbrMetallicRoughness = {};
    to.pbrMetallicRoughness.metallicFactor = 0;
    to.pbrMetallicRoughness.roughnessFactor = 1 - number_of(*old, "glossinessFactor", 0, 1);
    for (int c = 0; c < 4; c++)
        to.pbrMetallicRoughness.baseColorFactor[size_t(c)] = number_of(*old, "diffuseFactor", c, 1);
    to.pbrMetallicRoughness.baseColorTexture = texture_of(*old, "diffuseTexture");
    to.pbrMetallicRoughness.metallicRoughnessTexture =
        texture_of(*old, "specularGlossinessTexture");
    return to;
}

/* Leaves an unlit material its base colour, as KHR_materials_unlit has everything else ignored. */
tinygltf::Material without_ignored(const tinygltf::Material &from) {
    auto unlit = from.extensions.find("KHR_materials_unlit");
    if (unlit == from.extensions.end())
        return from;
    tinygltf::Material to = from;
    to.extensions = {*unlit};
    to.pbrMetallicRoughness.metallicRoughnessTexture = {};
    to.emissiveTexture = {};
    to.emissiveFactor = {0, 0, 0};
    to.normalTexture = {};
    to.occlusionTexture = {};
    return to;
}

UvSource uv_source(const tinygltf::TextureInfo &info) {
    UvSource source;
    source.set = source.own_set = info.texCoord;
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

bool same_place(const UvSource &a, const UvSource &b) {
    return a.set == b.set && a.own_set == b.own_set && a.rotation == b.rotation &&
           std::equal(a.offset, a.offset + 2, b.offset) &&
           std::equal(a.scale, a.scale + 2, b.scale);
}

/* The number of that mapping of a material. */
int mapping_of(std::vector<UvSource> &mappings, const UvSource &source) {
    auto same = [&](const UvSource &other) { return same_place(source, other); };
    auto known = std::find_if(mappings.begin(), mappings.end(), same);
    int number = int(known - mappings.begin());
    if (known == mappings.end())
        mappings.push_back(source);
    return number;
}

/* The first texture's mapping is the first one: so is the base colour's. */
bool load_textures(Loader &loader, const tinygltf::Material &from, struct material &to,
                   std::vector<UvSource> &mappings) {
    tinygltf::TextureInfo normal;
    normal.index = from.normalTexture.index;
    normal.texCoord = from.normalTexture.texCoord;
    normal.extensions = from.normalTexture.extensions;
    to.specular_glossiness = specular_glossiness(from);
    int first = 0;
    const struct {
        const tinygltf::TextureInfo &info;
        bool linear;
        int &out, &mapping;
    } rows[] = {
        {from.pbrMetallicRoughness.baseColorTexture, false, to.base_color_texture, first},
        {from.pbrMetallicRoughness.metallicRoughnessTexture, !to.specular_glossiness,
         to.metal_roughness_texture, to.metal_roughness_mapping},
        {from.emissiveTexture, false, to.emission_texture, to.emission_mapping},
        {normal, true, to.normal_texture, to.normal_mapping},
    };
    for (const auto &row : rows) {
        row.out = -1;
        if (row.info.index < 0)
            continue;
        row.mapping = mapping_of(mappings, uv_source(row.info));
        if (!load_texture(loader, row.info.index, row.linear, row.out))
            return false;
    }
    return true;
}

/* emissiveFactor x KHR_materials_emissive_strength. */
bool load_emission(const tinygltf::Material &from, struct material &to) {
    auto found = from.extensions.find("KHR_materials_emissive_strength");
    double strength =
        found == from.extensions.end() ? 1 : number_of(found->second, "emissiveStrength", 0, 1);
    to.emissive_strength = float(strength);
    for (int c = 0; c < 3; c++) {
        to.emissive_factor[c] = float(from.emissiveFactor[size_t(c)]);
        to.emission[c] = float(from.emissiveFactor[size_t(c)] * strength);
        if (!(to.emission[c] >= 0 && to.emission[c] <= SCENE_LIGHT_MOST))
            return error_set("emissiveFactor: it is negative or above %g",
                             double(SCENE_LIGHT_MOST));
    }
    return true;
}

TextureMean mean_of(const struct scene_texture &texture) {
    const struct bitmap &bitmap = texture.bitmap;
    size_t count = size_t(bitmap.width) * size_t(bitmap.height);
    size_t counts[3][256] = {};
    double alpha = 0;
    float srgb_to_linear[256];
    TextureMean mean = {};
    texture_decode_table(srgb_to_linear);
    for (size_t i = 0; i < count; i++) {
        for (int c = 0; c < 3; c++)
            counts[c][bitmap.rgba[4 * i + size_t(c)]]++;
        alpha += bitmap.rgba[4 * i + 3];
    }
    for (size_t c = 0; c < 3; c++)
        for (int byte = 0; byte < 256; byte++)
            mean[c] += double(counts[c][byte]) / double(count) * double(srgb_to_linear[byte]);
    mean[3] = alpha / double(count) / 255;
    return mean;
}

/* What the whole of a texture is on average, for want of its texels: white where there is none, or
 * its picture is missing. The scene does not keep it. */
bool find_mean(Loader &loader, const tinygltf::TextureInfo &info, TextureMean &mean) {
    mean = {1, 1, 1, 1};
    if (info.index < 0)
        return true;
    lack(loader, "textures of specular reflection and transmission (each is its mean everywhere)");
    int image = texture_source(loader.model.textures[size_t(info.index)]), number;
    auto known = loader.texture_means.find(image);
    int before = loader.scene->texture_count;
    if (known != loader.texture_means.end())
        mean = known->second;
    else if (!load_texture(loader, info.index, false, number))
        return false;
    else if (number >= 0 && !loader.replaced_images.count(image))
        loader.texture_means[image] = mean = mean_of(loader.scene->textures[number]);
    if (loader.scene->texture_count > before) {
        bitmap_free(&loader.scene->textures[before].bitmap);
        loader.scene->textures[before] = {};
        loader.scene->texture_count = before;
        loader.texture_keys.pop_back();
    }
    return true;
}

const double absorption_most = 1e9; /* 1/m */

/* KHR_materials_pbrSpecularGlossiness: the specular colour is the reflectance, whether of metals or
 * not. */
void load_specular_color(const tinygltf::Value &from, struct material &to) {
    float *f0 = to.specular_f0;
    for (int c = 0; c < 3; c++)
        f0[c] = float(number_of(from, "specularFactor", c, 1));
    to.specular_f90 = reflectance_grazing(std::max({f0[0], f0[1], f0[2]}));
}

/* Of what is no metal: KHR_materials_ior and KHR_materials_specular. */
bool load_reflectance(Loader &loader, const tinygltf::Material &from, struct material &to) {
    if (const tinygltf::Value *old = specular_glossiness(from)) {
        load_specular_color(*old, to);
        return true;
    }
    auto ior = from.extensions.find("KHR_materials_ior");
    auto found = from.extensions.find("KHR_materials_specular");
    const tinygltf::Value specular =
        found == from.extensions.end() ? tinygltf::Value() : found->second;
    double index = ior == from.extensions.end() ? 1.5 : number_of(ior->second, "ior", 0, 1.5);
    to.index_of_refraction = index == 0 ? 1.5F : float(index);
    double straight = std::pow((index - 1) / (index + 1), 2);
    TextureMean strengths, colors;
    if (!(index == 0 || index >= 1))
        return error_set("KHR_materials_ior: ior: %g is neither 0 nor from 1 on", index);
    if (!find_mean(loader, texture_of(specular, "specularTexture"), strengths) ||
        !find_mean(loader, texture_of(specular, "specularColorTexture"), colors))
        return false;
    double factor = number_of(specular, "specularFactor", 0, 1) * strengths[3];
    for (size_t c = 0; c < 3; c++) {
        double color = number_of(specular, "specularColorFactor", int(c), 1) * colors[c];
        if (!(color >= 0))
            return error_set("KHR_materials_specular: specularColorFactor: %g is negative", color);
        to.specular_f0[c] = float(std::min(straight * color, 1.) * factor);
    }
    to.specular_f90 = float(factor);
    return true;
}

/* KHR_materials_transmission, and KHR_materials_volume: without a thickness the wall is thin, and
 * light goes straight on. */
bool load_transmission(Loader &loader, const tinygltf::Material &from, struct material &to) {
    auto transmission = from.extensions.find("KHR_materials_transmission");
    if (transmission == from.extensions.end())
        return true;
    TextureMean strengths;
    if (!find_mean(loader, texture_of(transmission->second, "transmissionTexture"), strengths))
        return false;
    to.transmission =
        float(number_of(transmission->second, "transmissionFactor", 0, 0) * strengths[0]);
    auto volume = from.extensions.find("KHR_materials_volume");
    if (volume != from.extensions.end())
        to.thickness = float(std::max(number_of(volume->second, "thicknessFactor", 0, 0), 0.));
    to.thin_walled = to.thickness <= 0;
    if (to.thin_walled)
        return true;
    double distance = number_of(volume->second, "attenuationDistance", 0, HUGE_VAL);
    if (!(distance > 0))
        return error_set("KHR_materials_volume: attenuationDistance: %g is not positive", distance);
    for (int c = 0; c < 3; c++) {
        double color = number_of(volume->second, "attenuationColor", c, 1);
        if (!(color >= 0 && color <= 1))
            return error_set("KHR_materials_volume: attenuationColor: %g is not from 0 to 1",
                             color);
        to.absorption[c] = float(std::min(-std::log(color) / distance, absorption_most));
    }
    return true;
}

bool does_shine(const tinygltf::Material &from) {
    return *std::max_element(from.emissiveFactor.begin(), from.emissiveFactor.end()) > 0;
}

/* What is not seen of it. */
void tell_material(Loader &loader, const tinygltf::Material &from) {
    if (from.occlusionTexture.index >= 0)
        lack(loader, "occlusion maps (light is computed)");
    bool shines = does_shine(from);
    if (shines && from.alphaMode == "BLEND")
        lack(loader, "blending of what shines (alpha from .5 on is opaque, below it a hole)");
    if (shines && from.extensions.count("KHR_materials_transmission"))
        lack(loader, "transmission of what shines");
}

bool load_material(Loader &loader, const tinygltf::Material &from, struct material &to,
                   std::vector<UvSource> &mappings) {
    copy_name(to.name, from.name);
    const auto &pbr = from.pbrMetallicRoughness;
    to.double_sided = from.doubleSided;
    /* What shines and blends covers all, or nothing. */
    bool blends = from.alphaMode == "BLEND";
    to.alpha_mask = blends || from.alphaMode == "MASK";
    to.blends = blends && !does_shine(from);
    to.unlit = from.extensions.count("KHR_materials_unlit") > 0;
    tell_material(loader, from);
    return copy_numbers({blends ? .5 : from.alphaCutoff}, &to.alpha_cutoff, "alphaCutoff") &&
           copy_numbers(pbr.baseColorFactor, to.base_color, "baseColorFactor") &&
           copy_numbers({pbr.metallicFactor}, &to.metalness, "metallicFactor") &&
           copy_numbers({pbr.roughnessFactor}, &to.roughness, "roughnessFactor") &&
           copy_numbers({from.normalTexture.scale}, &to.normal_scale, "normalTexture: scale") &&
           load_reflectance(loader, from, to) && load_transmission(loader, from, to) &&
           load_emission(from, to) && load_textures(loader, from, to, mappings);
}

/* Alphas of a material. */
struct Alphas {
    float least = 1, most = 0;
    size_t covering = 0, partly = 0; /* how many are not holes, and are not opaque either */

    void add(float alpha) {
        const float clear = .1F;
        least = std::min(least, alpha);
        most = std::max(most, alpha);
        covering += alpha > clear;
        partly += alpha > clear && alpha < 1 - clear;
    }
};

Alphas of_texture(const struct scene &scene, const struct material &material) {
    Alphas alphas;
    if (material.base_color_texture < 0) {
        alphas.add(material.base_color[3]);
        return alphas;
    }
    const struct bitmap &bitmap = scene.textures[material.base_color_texture].bitmap;
    for (size_t i = 0; i < size_t(bitmap.width) * size_t(bitmap.height); i++)
        alphas.add(material.base_color[3] * float(bitmap.rgba[4 * i + 3]) / 255);
    return alphas;
}

/* Those that have none have 1. */
Alphas of_vertices(const struct scene &scene, int material) {
    Alphas alphas;
    for (int m = 0; m < scene.mesh_count; m++)
        for (int p = 0; p < scene.meshes[m].primitive_count; p++) {
            const struct primitive &primitive = scene.meshes[m].primitives[p];
            for (int i = 0; primitive.material == material && i < primitive.vertex_count; i++)
                alphas.add(primitive.color ? primitive.color[i][3] : 1);
        }
    return alphas;
}

} // namespace

/* What blends with an alpha of 1 throughout is opaque. Leaves, whose alphas are 0 or 1 but for
 * their edges, are masked: their triangles stay few, and sharp. */
void settle_blending(struct scene &scene) {
    const float even = 1e-3F;
    for (int i = 0; i < scene.material_count; i++) {
        struct material &material = scene.materials[i];
        if (!material.blends)
            continue;
        Alphas alphas[] = {of_texture(scene, material), of_vertices(scene, i)};
        material.blends = material.alpha_mask = false;
        for (const Alphas &own : alphas) {
            material.blends = material.blends || own.least < 1 - even;
            material.alpha_mask = material.alpha_mask || own.most - own.least > even;
        }
        for (const Alphas &own : alphas)
            material.alpha_mask = material.alpha_mask && 2 * own.partly <= own.covering;
    }
}

/* One material more than the file has: the default, for primitives without. */
bool load_materials(Loader &loader) {
    const auto &from = loader.model.materials;
    struct scene *scene = loader.scene;
    scene->materials = allocate<struct material>(from.size() + 1);
    scene->textures = allocate<struct scene_texture>(4 * from.size());
    scene->material_count = int(from.size()) + 1;
    loader.mappings.resize(from.size() + 1);
    for (size_t i = 0; i < from.size(); i++) {
        if (!load_material(loader, without_ignored(as_metallic_roughness(from[i])),
                           scene->materials[i], loader.mappings[i]))
            return error_prefix("%s", label("material", i, from[i].name).c_str());
    }
    material_init(&scene->materials[from.size()], "default");
    note_texture_sizes(loader);
    return true;
}

} // namespace gltf
