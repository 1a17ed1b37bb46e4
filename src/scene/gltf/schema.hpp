/* The table of what the standard demands of a file's JSON; `file` is the whole but for
 * animations. */
#ifndef SCENE_GLTF_SCHEMA_HPP
#define SCENE_GLTF_SCHEMA_HPP

#include <cstddef>

namespace gltf {
namespace {

enum class Kind {
    Index,     /* of an element of the list at the JSON pointer `of` */
    Indices,   /* an array of them */
    IndexMap,  /* an object of them */
    IndexMaps, /* an array of these */
    Size,      /* a whole number */
    Int,       /* a whole number that an int can hold */
    Number,
    Numbers,   /* `count` of them; any number of them where that is 0 */
    Share,     /* a number that is clamped to 0 to 1 */
    Shares,    /* `count` of them: too many are cut, and a missing alpha is 1 */
    Positive,  /* a number that is 0 where it is negative by rounding */
    Positives, /* `count` of them: too many are cut */
    Flag,
    Text,
    Choice,  /* one of the words or numbers in `of`, each after a space */
    Hint,    /* such a choice; another is left out, as if there were none */
    Variant, /* such a choice; where a field has its name, that must be there too */
    Object,  /* with `fields` */
    Objects, /* an array of them, each called `of` in messages */
};

enum Need { Optional, Required };

struct Field {
    const char *name;
    Need need;
    Kind kind;
    const char *of = nullptr;
    const Field *fields = nullptr; /* ends with a field without name */
    size_t count = 0;
};

const Field end = {nullptr, Optional, Kind::Object};

const Field sparse_indices[] = {
    {"bufferView", Required, Kind::Index, "/bufferViews"},
    {"byteOffset", Optional, Kind::Int},
    {"componentType", Required, Kind::Choice, " 5121 5123 5125"},
    end,
};

const Field sparse_values[] = {
    {"bufferView", Required, Kind::Index, "/bufferViews"},
    {"byteOffset", Optional, Kind::Int},
    end,
};

const Field sparse[] = {
    {"count", Required, Kind::Int},
    {"indices", Required, Kind::Object, nullptr, sparse_indices},
    {"values", Required, Kind::Object, nullptr, sparse_values},
    end,
};

const Field accessor[] = {
    {"bufferView", Optional, Kind::Index, "/bufferViews"},
    {"byteOffset", Optional, Kind::Size},
    {"componentType", Required, Kind::Choice, " 5120 5121 5122 5123 5125 5126"},
    {"normalized", Optional, Kind::Flag},
    {"count", Required, Kind::Size},
    {"type", Required, Kind::Choice, " SCALAR VEC2 VEC3 VEC4 MAT2 MAT3 MAT4"},
    {"sparse", Optional, Kind::Object, nullptr, sparse},
    end,
};

const Field buffer[] = {
    {"uri", Optional, Kind::Text},
    {"byteLength", Required, Kind::Size},
    end,
};

const Field meshopt_view[] = {
    {"buffer", Required, Kind::Index, "/buffers"},
    {"byteOffset", Optional, Kind::Int},
    {"byteLength", Required, Kind::Int},
    {"byteStride", Required, Kind::Int},
    {"count", Required, Kind::Int},
    {"mode", Required, Kind::Choice, " ATTRIBUTES TRIANGLES INDICES"},
    {"filter", Optional, Kind::Choice, " NONE OCTAHEDRAL QUATERNION EXPONENTIAL COLOR"},
    end,
};

const Field view_extensions[] = {
    {"EXT_meshopt_compression", Optional, Kind::Object, nullptr, meshopt_view},
    {"KHR_meshopt_compression", Optional, Kind::Object, nullptr, meshopt_view},
    end,
};

const Field buffer_view[] = {
    {"buffer", Required, Kind::Index, "/buffers"},
    {"byteOffset", Optional, Kind::Size},
    {"byteLength", Required, Kind::Size},
    {"byteStride", Optional, Kind::Size},
    {"extensions", Optional, Kind::Object, nullptr, view_extensions},
    end,
};

const Field perspective[] = {
    {"yfov", Required, Kind::Number},
    {"znear", Optional, Kind::Number},
    {"zfar", Optional, Kind::Number},
    end,
};

const Field orthographic[] = {
    {"xmag", Required, Kind::Number},
    {"ymag", Required, Kind::Number},
    {"znear", Optional, Kind::Number},
    {"zfar", Optional, Kind::Number},
    end,
};

const Field camera[] = {
    {"type", Required, Kind::Variant, " perspective orthographic"},
    {"perspective", Optional, Kind::Object, nullptr, perspective},
    {"orthographic", Optional, Kind::Object, nullptr, orthographic},
    end,
};

const Field image[] = {
    {"uri", Optional, Kind::Text},
    {"bufferView", Optional, Kind::Index, "/bufferViews"},
    end,
};

const Field texture_transform[] = {
    {"offset", Optional, Kind::Numbers, nullptr, nullptr, 2},
    {"rotation", Optional, Kind::Number},
    {"scale", Optional, Kind::Numbers, nullptr, nullptr, 2},
    {"texCoord", Optional, Kind::Int},
    end,
};

const Field texture_info_extensions[] = {
    {"KHR_texture_transform", Optional, Kind::Object, nullptr, texture_transform},
    end,
};

const Field texture_info[] = {
    {"index", Required, Kind::Index, "/textures"},
    {"texCoord", Optional, Kind::Int},
    {"extensions", Optional, Kind::Object, nullptr, texture_info_extensions},
    end,
};

const Field normal_texture_info[] = {
    {"index", Required, Kind::Index, "/textures"},
    {"texCoord", Optional, Kind::Int},
    {"scale", Optional, Kind::Number},
    {"extensions", Optional, Kind::Object, nullptr, texture_info_extensions},
    end,
};

const Field metallic_roughness[] = {
    {"baseColorFactor", Optional, Kind::Shares, nullptr, nullptr, 4},
    {"baseColorTexture", Optional, Kind::Object, nullptr, texture_info},
    {"metallicFactor", Optional, Kind::Share},
    {"roughnessFactor", Optional, Kind::Share},
    {"metallicRoughnessTexture", Optional, Kind::Object, nullptr, texture_info},
    end,
};

const Field emissive_strength[] = {{"emissiveStrength", Optional, Kind::Positive}, end};

const Field specular_glossiness[] = {
    {"diffuseFactor", Optional, Kind::Shares, nullptr, nullptr, 4},
    {"diffuseTexture", Optional, Kind::Object, nullptr, texture_info},
    {"specularFactor", Optional, Kind::Shares, nullptr, nullptr, 3},
    {"glossinessFactor", Optional, Kind::Share},
    {"specularGlossinessTexture", Optional, Kind::Object, nullptr, texture_info},
    end,
};

const Field index_of_refraction[] = {{"ior", Optional, Kind::Number}, end};

const Field transmission[] = {
    {"transmissionFactor", Optional, Kind::Share},
    {"transmissionTexture", Optional, Kind::Object, nullptr, texture_info},
    end,
};

const Field volume[] = {
    {"thicknessFactor", Optional, Kind::Positive},
    {"attenuationDistance", Optional, Kind::Positive},
    {"attenuationColor", Optional, Kind::Shares, nullptr, nullptr, 3},
    end,
};

const Field specular[] = {
    {"specularFactor", Optional, Kind::Share},
    {"specularTexture", Optional, Kind::Object, nullptr, texture_info},
    {"specularColorFactor", Optional, Kind::Numbers, nullptr, nullptr, 3},
    {"specularColorTexture", Optional, Kind::Object, nullptr, texture_info},
    end,
};

const Field material_extensions[] = {
    {"KHR_materials_pbrSpecularGlossiness", Optional, Kind::Object, nullptr, specular_glossiness},
    {"KHR_materials_emissive_strength", Optional, Kind::Object, nullptr, emissive_strength},
    {"KHR_materials_ior", Optional, Kind::Object, nullptr, index_of_refraction},
    {"KHR_materials_specular", Optional, Kind::Object, nullptr, specular},
    {"KHR_materials_transmission", Optional, Kind::Object, nullptr, transmission},
    {"KHR_materials_volume", Optional, Kind::Object, nullptr, volume},
    end,
};

const Field material[] = {
    {"pbrMetallicRoughness", Optional, Kind::Object, nullptr, metallic_roughness},
    {"emissiveFactor", Optional, Kind::Positives, nullptr, nullptr, 3},
    {"emissiveTexture", Optional, Kind::Object, nullptr, texture_info},
    {"normalTexture", Optional, Kind::Object, nullptr, normal_texture_info},
    {"alphaMode", Optional, Kind::Hint, " OPAQUE MASK BLEND"},
    {"alphaCutoff", Optional, Kind::Number},
    {"doubleSided", Optional, Kind::Flag},
    {"extensions", Optional, Kind::Object, nullptr, material_extensions},
    end,
};

const Field anything[] = {end};

const Field draco[] = {
    {"bufferView", Required, Kind::Index, "/bufferViews"},
    {"attributes", Required, Kind::Object, nullptr, anything},
    end,
};

const char *const variants = "/extensions/KHR_materials_variants/variants";

const Field mapping[] = {
    {"material", Required, Kind::Index, "/materials"},
    {"variants", Required, Kind::Indices, variants},
    end,
};

const Field primitive_variants[] = {{"mappings", Required, Kind::Objects, "mapping", mapping}, end};

const Field primitive_extensions[] = {
    {"KHR_materials_variants", Optional, Kind::Object, nullptr, primitive_variants},
    {"KHR_draco_mesh_compression", Optional, Kind::Object, nullptr, draco},
    end,
};

const Field primitive[] = {
    {"attributes", Required, Kind::IndexMap, "/accessors"},
    {"indices", Optional, Kind::Index, "/accessors"},
    {"material", Optional, Kind::Index, "/materials"},
    {"mode", Optional, Kind::Choice, " 0 1 2 3 4 5 6"},
    {"targets", Optional, Kind::IndexMaps, "/accessors"},
    {"extensions", Optional, Kind::Object, nullptr, primitive_extensions},
    end,
};

const Field mesh[] = {
    {"primitives", Required, Kind::Objects, "primitive", primitive},
    {"weights", Optional, Kind::Numbers},
    end,
};

const Field skin[] = {
    {"inverseBindMatrices", Optional, Kind::Index, "/accessors"},
    {"joints", Required, Kind::Indices, "/nodes"},
    end,
};

const Field animation_pointer[] = {{"pointer", Required, Kind::Text}, end};

const Field channel_target_extensions[] = {
    {"KHR_animation_pointer", Optional, Kind::Object, nullptr, animation_pointer},
    end,
};

const Field channel_target[] = {
    {"node", Optional, Kind::Index, "/nodes"},
    {"path", Required, Kind::Text},
    {"extensions", Optional, Kind::Object, nullptr, channel_target_extensions},
    end,
};

/* Of animations, whose bad channels are left out. The sampler's index is into the animation's own
 * list. */
const Field channel[] = {
    {"sampler", Required, Kind::Size},
    {"target", Required, Kind::Object, nullptr, channel_target},
    end,
};

const Field channel_sampler[] = {
    {"input", Required, Kind::Index, "/accessors"},
    {"output", Required, Kind::Index, "/accessors"},
    {"interpolation", Optional, Kind::Choice, " LINEAR STEP CUBICSPLINE"},
    end,
};

const char *const lights = "/extensions/KHR_lights_punctual/lights";

const char *const area_lights = "/extensions/EXT_lights_area/lights";

const char *const profiles = "/extensions/EXT_lights_ies/lights";

const Field node_light[] = {{"light", Required, Kind::Index, lights}, end};
const Field node_area_light[] = {{"light", Required, Kind::Index, area_lights}, end};

const Field node_profile[] = {
    {"light", Required, Kind::Index, profiles},
    {"multiplier", Optional, Kind::Positive},
    {"color", Optional, Kind::Shares, nullptr, nullptr, 3},
    end,
};

const Field visibility[] = {{"visible", Optional, Kind::Flag}, end};

const Field instancing[] = {{"attributes", Required, Kind::IndexMap, "/accessors"}, end};

const Field node_extensions[] = {
    {"KHR_lights_punctual", Optional, Kind::Object, nullptr, node_light},
    {"EXT_lights_area", Optional, Kind::Object, nullptr, node_area_light},
    {"EXT_lights_ies", Optional, Kind::Object, nullptr, node_profile},
    {"EXT_mesh_gpu_instancing", Optional, Kind::Object, nullptr, instancing},
    {"KHR_node_visibility", Optional, Kind::Object, nullptr, visibility},
    end,
};

const Field node[] = {
    {"camera", Optional, Kind::Index, "/cameras"},
    {"mesh", Optional, Kind::Index, "/meshes"},
    {"skin", Optional, Kind::Index, "/skins"},
    {"weights", Optional, Kind::Numbers},
    {"children", Optional, Kind::Indices, "/nodes"},
    {"matrix", Optional, Kind::Numbers, nullptr, nullptr, 16},
    {"rotation", Optional, Kind::Numbers, nullptr, nullptr, 4},
    {"scale", Optional, Kind::Numbers, nullptr, nullptr, 3},
    {"translation", Optional, Kind::Numbers, nullptr, nullptr, 3},
    {"extensions", Optional, Kind::Object, nullptr, node_extensions},
    end,
};

const Field scene[] = {{"nodes", Optional, Kind::Indices, "/nodes"}, end};

const Field texture_format[] = {{"source", Optional, Kind::Index, "/images"}, end};

const Field texture_extensions[] = {
    {"EXT_texture_webp", Optional, Kind::Object, nullptr, texture_format},
    {"EXT_texture_avif", Optional, Kind::Object, nullptr, texture_format},
    {"KHR_texture_basisu", Optional, Kind::Object, nullptr, texture_format},
    {"MSFT_texture_dds", Optional, Kind::Object, nullptr, texture_format},
    end,
};

const Field texture[] = {
    {"sampler", Optional, Kind::Index, "/samplers"},
    {"source", Optional, Kind::Index, "/images"},
    {"extensions", Optional, Kind::Object, nullptr, texture_extensions},
    end,
};

const Field spot[] = {
    {"innerConeAngle", Optional, Kind::Number},
    {"outerConeAngle", Optional, Kind::Number},
    end,
};

const Field light[] = {
    {"type", Required, Kind::Variant, " directional point spot"},
    {"color", Optional, Kind::Positives, nullptr, nullptr, 3},
    {"intensity", Optional, Kind::Positive},
    {"range", Optional, Kind::Number},
    {"spot", Optional, Kind::Object, nullptr, spot},
    end,
};

const Field punctual[] = {{"lights", Required, Kind::Objects, "light", light}, end};

const Field rect[] = {{"aspect", Optional, Kind::Number}, end};

const Field area_light[] = {
    {"name", Optional, Kind::Text},
    {"type", Required, Kind::Choice, " rect disk"},
    {"color", Optional, Kind::Positives, nullptr, nullptr, 3},
    {"intensity", Optional, Kind::Positive},
    {"size", Optional, Kind::Number},
    {"rect", Optional, Kind::Object, nullptr, rect},
    end,
};

const Field area[] = {{"lights", Required, Kind::Objects, "area light", area_light}, end};

const Field profile[] = {
    {"uri", Optional, Kind::Text},
    {"bufferView", Optional, Kind::Index, "/bufferViews"},
    {"mimeType", Optional, Kind::Text},
    {"name", Optional, Kind::Text},
    end,
};

const Field file_profiles[] = {{"lights", Required, Kind::Objects, "light profile", profile}, end};

const Field variant[] = {{"name", Required, Kind::Text}, end};

const Field file_variants[] = {{"variants", Required, Kind::Objects, "variant", variant}, end};

const Field file_extensions[] = {
    {"KHR_materials_variants", Optional, Kind::Object, nullptr, file_variants},
    {"KHR_lights_punctual", Optional, Kind::Object, nullptr, punctual},
    {"EXT_lights_area", Optional, Kind::Object, nullptr, area},
    {"EXT_lights_ies", Optional, Kind::Object, nullptr, file_profiles},
    end,
};

const Field sampler[] = {
    {"magFilter", Optional, Kind::Hint, " 9728 9729"},
    {"wrapS", Optional, Kind::Hint, " 10497 33071 33648"},
    {"wrapT", Optional, Kind::Hint, " 10497 33071 33648"},
    end,
};

const Field asset[] = {{"version", Required, Kind::Text}, end};

const Field file[] = {
    {"asset", Required, Kind::Object, nullptr, asset},
    {"buffers", Optional, Kind::Objects, "buffer", buffer},
    {"bufferViews", Optional, Kind::Objects, "buffer view", buffer_view},
    {"accessors", Optional, Kind::Objects, "accessor", accessor},
    {"meshes", Optional, Kind::Objects, "mesh", mesh},
    {"nodes", Optional, Kind::Objects, "node", node},
    {"scenes", Optional, Kind::Objects, "scene", scene},
    {"scene", Optional, Kind::Index, "/scenes"},
    {"materials", Optional, Kind::Objects, "material", material},
    {"images", Optional, Kind::Objects, "image", image},
    {"textures", Optional, Kind::Objects, "texture", texture},
    {"samplers", Optional, Kind::Objects, "sampler", sampler},
    {"cameras", Optional, Kind::Objects, "camera", camera},
    {"skins", Optional, Kind::Objects, "skin", skin},
    {"extensions", Optional, Kind::Object, nullptr, file_extensions},
    end,
};

} // namespace
} // namespace gltf

#endif
