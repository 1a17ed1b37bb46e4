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

/* KHR_materials_pbrSpecularGlossiness, which older files have, as the standard's own model: its diffuse
 * colour, no metal, and the roughness of its gloss. */
tinygltf::Material as_metallic_roughness(const tinygltf::Material &from) {
    auto found = from.extensions.find("KHR_materials_pbrSpecularGlossiness");
    if (found == from.extensions.end())
        return from;
    const tinygltf::Value &old = found->second;
    tinygltf::Material to = from;
    to.pbrMetallicRoughness = {};
    to.pbrMetallicRoughness.metallicFactor = 0;
    to.pbrMetallicRoughness.roughnessFactor = 1 - number_of(old, "glossinessFactor", 0, 1);
    for (int c = 0; c < 4; c++)
        to.pbrMetallicRoughness.baseColorFactor[size_t(c)] = number_of(old, "diffuseFactor", c, 1);
    if (!old.Has("diffuseTexture"))
        return to;
    const tinygltf::Value &texture = old.Get("diffuseTexture");
    tinygltf::TextureInfo &info = to.pbrMetallicRoughness.baseColorTexture;
    info.index = texture.Get("index").GetNumberAsInt();
    info.texCoord = int(number_of(texture, "texCoord", 0, 0));
    if (texture.Has("extensions"))
        for (const std::string &name : texture.Get("extensions").Keys())
            info.extensions[name] = texture.Get("extensions").Get(name);
    return to;
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

bool same_place(const UvSource &a, const UvSource &b) {
    return a.set == b.set && a.rotation == b.rotation &&
           std::equal(a.offset, a.offset + 2, b.offset) &&
           std::equal(a.scale, a.scale + 2, b.scale);
}

/* Vertices have one uv: a texture that lies elsewhere than the material's first is left out. */
bool load_textures(Loader &loader, const tinygltf::Material &from, struct material &to,
                   UvSource &uv) {
    tinygltf::TextureInfo normal;
    normal.index = from.normalTexture.index;
    normal.texCoord = from.normalTexture.texCoord;
    normal.extensions = from.normalTexture.extensions;
    const struct {
        const tinygltf::TextureInfo &info;
        bool linear;
        int &out;
    } rows[] = {
        {from.pbrMetallicRoughness.baseColorTexture, false, to.base_color_texture},
        {from.pbrMetallicRoughness.metallicRoughnessTexture, true, to.metal_roughness_texture},
        {from.emissiveTexture, false, to.emission_texture},
        {normal, true, to.normal_texture},
    };
    bool first = true;
    for (const auto &row : rows) {
        row.out = -1;
        if (row.info.index < 0)
            continue;
        UvSource source = uv_source(row.info);
        if (first)
            uv = source;
        else if (!same_place(source, uv)) {
            lack(loader, "textures with coordinates other than their material's first");
            continue;
        }
        first = false;
        if (!load_texture(loader, row.info.index, row.linear, row.out))
            return false;
    }
    return true;
}

bool load_share(double from, float &to, const char *what) {
    to = float(from);
    return (from >= 0 && from <= 1) || error_set("%s: %g is not from 0 to 1", what, from);
}

/* emissiveFactor x KHR_materials_emissive_strength. */
bool load_emission(const tinygltf::Material &from, struct material &to) {
    auto found = from.extensions.find("KHR_materials_emissive_strength");
    double strength =
        found == from.extensions.end() ? 1 : number_of(found->second, "emissiveStrength", 0, 1);
    for (int c = 0; c < 3; c++) {
        to.emission[c] = float(from.emissiveFactor[size_t(c)] * strength);
        if (!(to.emission[c] >= 0 && to.emission[c] <= SCENE_LIGHT_MOST))
            return error_set("emissiveFactor: it is negative or above %g",
                             double(SCENE_LIGHT_MOST));
    }
    return true;
}

/* Of what is no metal: KHR_materials_ior and KHR_materials_specular, but for the latter's textures. */
bool load_reflectance(Loader &loader, const tinygltf::Material &from, struct material &to) {
    const auto none = from.extensions.end();
    auto ior = from.extensions.find("KHR_materials_ior");
    auto specular = from.extensions.find("KHR_materials_specular");
    double index = ior == none ? 1.5 : number_of(ior->second, "ior", 0, 1.5);
    double straight = std::pow((index - 1) / (index + 1), 2);
    double factor = specular == none ? 1 : number_of(specular->second, "specularFactor", 0, 1);
    if (!(index == 0 || index >= 1))
        return error_set("KHR_materials_ior: ior: %g is neither 0 nor from 1 on", index);
    for (int c = 0; c < 3; c++) {
        double color =
            specular == none ? 1 : number_of(specular->second, "specularColorFactor", c, 1);
        if (!(color >= 0))
            return error_set("KHR_materials_specular: specularColorFactor: %g is negative", color);
        to.specular_f0[c] = float(std::min(straight * color, 1.) * factor);
    }
    if (specular != none &&
        (specular->second.Has("specularTexture") || specular->second.Has("specularColorTexture")))
        lack(loader, "textures of specular reflection");
    return load_share(factor, to.specular_f90, "KHR_materials_specular: specularFactor");
}

/* What is not seen of it. */
void tell_material(Loader &loader, const tinygltf::Material &from) {
    if (from.occlusionTexture.index >= 0)
        lack(loader, "occlusion maps (light is computed)");
    if (from.alphaMode == "BLEND")
        lack(loader, "blending (alpha from .5 on is opaque, below it a hole)");
}

bool load_material(Loader &loader, const tinygltf::Material &from, struct material &to,
                   UvSource &uv) {
    copy_name(to.name, from.name);
    const auto &pbr = from.pbrMetallicRoughness;
    to.double_sided = from.doubleSided;
    /* Whoever blends covers all, or nothing. */
    bool blends = from.alphaMode == "BLEND";
    to.alpha_mask = blends || from.alphaMode == "MASK";
    to.unlit = from.extensions.count("KHR_materials_unlit") > 0;
    tell_material(loader, from);
    return copy_numbers({blends ? .5 : from.alphaCutoff}, &to.alpha_cutoff, "alphaCutoff") &&
           copy_numbers(pbr.baseColorFactor, to.base_color, "baseColorFactor") &&
           load_share(pbr.metallicFactor, to.metalness, "metallicFactor") &&
           load_share(pbr.roughnessFactor, to.roughness, "roughnessFactor") &&
           copy_numbers({from.normalTexture.scale}, &to.normal_scale, "normalTexture: scale") &&
           load_reflectance(loader, from, to) && load_emission(from, to) &&
           load_textures(loader, from, to, uv);
}

/* The standard's default: white, rough and, as it is, a metal. */
void make_default(struct material &to) {
    copy_name(to.name, "default");
    for (float &c : to.base_color)
        c = 1;
    for (float &c : to.specular_f0)
        c = DIELECTRIC_F0;
    to.metalness = to.roughness = to.specular_f90 = to.normal_scale = 1;
    to.base_color_texture = to.metal_roughness_texture = -1;
    to.emission_texture = to.normal_texture = -1;
}

} // namespace

bool material_is_textured(const struct material &material) {
    return material.base_color_texture >= 0 || material.metal_roughness_texture >= 0 ||
           material.emission_texture >= 0 || material.normal_texture >= 0;
}

/* One material more than the file has: the default, for primitives without. */
bool load_materials(Loader &loader) {
    const auto &from = loader.model.materials;
    struct scene *scene = loader.scene;
    scene->materials = allocate<struct material>(from.size() + 1);
    scene->textures = allocate<struct scene_texture>(4 * from.size());
    scene->material_count = int(from.size()) + 1;
    loader.uv_sources.resize(from.size() + 1);
    for (size_t i = 0; i < from.size(); i++) {
        if (!load_material(loader, as_metallic_roughness(from[i]), scene->materials[i],
                           loader.uv_sources[i]))
            return error_prefix("%s", label("material", i, from[i].name).c_str());
    }
    make_default(scene->materials[from.size()]);
    return true;
}

} // namespace gltf
