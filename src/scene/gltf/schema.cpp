/* What the standard demands of a file's JSON, as far as we rely on it.
 *
 * tinygltf casts, drops or ignores where it should refuse, and recurses as deep as a file asks it
 * to. So the JSON is held against this table first: types, ranges, and that every index points at
 * something. Whoever reads the model afterwards need not ask again.
 */
#include "scene/gltf/model.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>

namespace gltf {
namespace {

using nlohmann::json;

enum class Kind {
    Index,     /* of an element of the list at the JSON pointer `of` */
    Indices,   /* an array of them */
    IndexMap,  /* an object of them */
    IndexMaps, /* an array of these */
    Size,      /* a whole number */
    Int,       /* a whole number that an int can hold */
    Number,
    Numbers, /* `count` of them; any number of them where that is 0 */
    Flag,
    Text,
    Choice,  /* one of the words or numbers in `of`, each after a space */
    Variant, /* such a choice; where a field has its name, that must be there too */
    Object,  /* with `fields` */
    Objects, /* an array of them, each called `of` in messages */
    Packed,  /* where it is, data are compressed in a way that is not read */
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

const Field buffer_view[] = {
    {"buffer", Required, Kind::Index, "/buffers"},
    {"byteOffset", Optional, Kind::Size},
    {"byteLength", Required, Kind::Size},
    {"byteStride", Optional, Kind::Size},
    end,
};

const Field perspective[] = {
    {"yfov", Required, Kind::Number},
    {"znear", Required, Kind::Number},
    {"zfar", Optional, Kind::Number},
    end,
};

const Field orthographic[] = {
    {"xmag", Required, Kind::Number},
    {"ymag", Required, Kind::Number},
    {"znear", Required, Kind::Number},
    {"zfar", Required, Kind::Number},
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

const Field metallic_roughness[] = {
    {"baseColorFactor", Optional, Kind::Numbers, nullptr, nullptr, 4},
    {"baseColorTexture", Optional, Kind::Object, nullptr, texture_info},
    {"metallicFactor", Optional, Kind::Number},
    {"roughnessFactor", Optional, Kind::Number},
    {"metallicRoughnessTexture", Optional, Kind::Object, nullptr, texture_info},
    end,
};

const Field emissive_strength[] = {{"emissiveStrength", Optional, Kind::Number}, end};

const Field material_extensions[] = {
    {"KHR_materials_emissive_strength", Optional, Kind::Object, nullptr, emissive_strength},
    end,
};

const Field material[] = {
    {"pbrMetallicRoughness", Optional, Kind::Object, nullptr, metallic_roughness},
    {"emissiveFactor", Optional, Kind::Numbers, nullptr, nullptr, 3},
    {"emissiveTexture", Optional, Kind::Object, nullptr, texture_info},
    {"alphaMode", Optional, Kind::Choice, " OPAQUE MASK BLEND"},
    {"alphaCutoff", Optional, Kind::Number},
    {"doubleSided", Optional, Kind::Flag},
    {"extensions", Optional, Kind::Object, nullptr, material_extensions},
    end,
};

const Field primitive_extensions[] = {
    {"KHR_draco_mesh_compression", Optional, Kind::Packed},
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

const Field channel_target[] = {
    {"node", Optional, Kind::Index, "/nodes"},
    {"path", Required, Kind::Text},
    end,
};

/* The sampler's index is into the animation's own list: check_animation. */
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

const Field animation[] = {
    {"channels", Required, Kind::Objects, "channel", channel},
    {"samplers", Required, Kind::Objects, "sampler", channel_sampler},
    end,
};

const char *const lights = "/extensions/KHR_lights_punctual/lights";

const char *const area_lights = "/extensions/EXT_lights_area/lights";

const Field node_light[] = {{"light", Required, Kind::Index, lights}, end};
const Field node_area_light[] = {{"light", Required, Kind::Index, area_lights}, end};

const Field instancing[] = {{"attributes", Required, Kind::IndexMap, "/accessors"}, end};

const Field node_extensions[] = {
    {"KHR_lights_punctual", Optional, Kind::Object, nullptr, node_light},
    {"EXT_lights_area", Optional, Kind::Object, nullptr, node_area_light},
    {"EXT_mesh_gpu_instancing", Optional, Kind::Object, nullptr, instancing},
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

const Field texture_webp[] = {{"source", Optional, Kind::Index, "/images"}, end};

const Field texture_extensions[] = {
    {"EXT_texture_webp", Optional, Kind::Object, nullptr, texture_webp},
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
    {"color", Optional, Kind::Numbers, nullptr, nullptr, 3},
    {"intensity", Optional, Kind::Number},
    {"range", Optional, Kind::Number},
    {"spot", Optional, Kind::Object, nullptr, spot},
    end,
};

const Field punctual[] = {{"lights", Required, Kind::Objects, "light", light}, end};

const Field rect[] = {{"aspect", Optional, Kind::Number}, end};

const Field area_light[] = {
    {"name", Optional, Kind::Text},
    {"type", Required, Kind::Choice, " rect disk"},
    {"color", Optional, Kind::Numbers, nullptr, nullptr, 3},
    {"intensity", Optional, Kind::Number},
    {"size", Optional, Kind::Number},
    {"rect", Optional, Kind::Object, nullptr, rect},
    end,
};

const Field area[] = {{"lights", Required, Kind::Objects, "area light", area_light}, end};

const Field file_extensions[] = {
    {"KHR_lights_punctual", Optional, Kind::Object, nullptr, punctual},
    {"EXT_lights_area", Optional, Kind::Object, nullptr, area},
    end,
};

const Field sampler[] = {
    {"magFilter", Optional, Kind::Choice, " 9728 9729"},
    {"wrapS", Optional, Kind::Choice, " 10497 33071 33648"},
    {"wrapT", Optional, Kind::Choice, " 10497 33071 33648"},
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
    {"animations", Optional, Kind::Objects, "animation", animation},
    {"extensions", Optional, Kind::Object, nullptr, file_extensions},
    end,
};

bool check_fields(const json &root, const json &object, const Field *fields);

size_t list_size(const json &root, const char *pointer) {
    json::json_pointer at(pointer);
    return root.contains(at) && root[at].is_array() ? root[at].size() : 0;
}

/* The value as a user would find it in the file, shortened. */
std::string quote(const json &value) {
    std::string text = value.is_structured()
                           ? value.type_name()
                           : value.dump(-1, ' ', true, json::error_handler_t::replace);
    return text.size() > 40 ? text.substr(0, 40) + "..." : text;
}

bool check_index(const json &root, const json &value, const char *list) {
    size_t size = list_size(root, list);
    if (value.is_number_unsigned() && value.get<uint64_t>() < size)
        return true;
    return error_set("%s, but there are %zu %s", quote(value).c_str(), size,
                     strrchr(list, '/') + 1);
}

bool check_choice(const json &value, const char *choices) {
    std::string word = value.is_string() ? value.get<std::string>() : value.dump();
    if (word.find(' ') == std::string::npos &&
        (std::string(choices) + " ").find(" " + word + " ") != std::string::npos)
        return true;
    return error_set("%s is none of%s", quote(value).c_str(), choices);
}

bool check_elements(const json &root, const json &list, const Field &field) {
    if (!list.is_array())
        return error_set("%s is not an array", quote(list).c_str());
    for (size_t i = 0; i < list.size(); i++) {
        const json &element = list[i];
        std::string name;
        if (element.is_object() && element.contains("name") && element["name"].is_string())
            name = element["name"].get<std::string>();
        if (!element.is_object() ? !error_set("%s is not an object", quote(element).c_str())
                                 : !check_fields(root, element, field.fields))
            return error_prefix("%s", label(field.of, i, name).c_str());
    }
    return true;
}

bool check_each_index(const json &root, const json &list, Kind kind, const char *of) {
    if (kind == Kind::Indices ? !list.is_array() : !list.is_object())
        return error_set("%s is not %s", quote(list).c_str(),
                         kind == Kind::Indices ? "an array" : "an object");
    for (auto it = list.begin(); it != list.end(); ++it)
        if (!check_index(root, *it, of))
            return kind == Kind::Indices ? false : error_prefix("%.40s", it.key().c_str());
    return true;
}

bool check_index_maps(const json &root, const json &list, const char *of) {
    if (!list.is_array())
        return error_set("%s is not an array", quote(list).c_str());
    for (const json &map : list)
        if (!check_each_index(root, map, Kind::IndexMap, of))
            return false;
    return true;
}

bool check_numbers(const json &list, size_t count) {
    bool good = list.is_array() && (count == 0 || list.size() == count);
    for (size_t i = 0; good && i < list.size(); i++)
        good = list[i].is_number();
    return good || (count ? error_set("not an array of %zu numbers", count)
                          : error_set("not an array of numbers"));
}

bool check_value(const json &root, const json &value, const Field &field) {
    switch (field.kind) {
    case Kind::Index:
        return check_index(root, value, field.of);
    case Kind::Indices:
    case Kind::IndexMap:
        return check_each_index(root, value, field.kind, field.of);
    case Kind::IndexMaps:
        return check_index_maps(root, value, field.of);
    case Kind::Size:
        return value.is_number_unsigned() ||
               error_set("%s is not a whole number from 0", quote(value).c_str());
    case Kind::Int:
        return (value.is_number_unsigned() && value.get<uint64_t>() <= INT32_MAX) ||
               error_set("%s is not a whole number from 0 to 2^31 - 1", quote(value).c_str());
    case Kind::Number:
        return value.is_number() || error_set("%s is not a number", quote(value).c_str());
    case Kind::Numbers:
        return check_numbers(value, field.count);
    case Kind::Flag:
        return value.is_boolean() ||
               error_set("%s is neither true nor false", quote(value).c_str());
    case Kind::Text:
        return value.is_string() || error_set("%s is not a string", quote(value).c_str());
    case Kind::Choice:
    case Kind::Variant:
        return check_choice(value, field.of);
    case Kind::Object:
        return value.is_object() ? check_fields(root, value, field.fields)
                                 : error_set("%s is not an object", quote(value).c_str());
    case Kind::Objects:
        return check_elements(root, value, field);
    case Kind::Packed:
        return error_set("compressed data, which are not read");
    }
    return false;
}

bool check_variant(const json &object, const std::string &name, const Field *fields) {
    for (const Field *field = fields; field->name; field++)
        if (name == field->name && !object.contains(name))
            return error_set("it has no '%s'", field->name);
    return true;
}

bool check_fields(const json &root, const json &object, const Field *fields) {
    for (const Field *field = fields; field->name; field++) {
        auto found = object.find(field->name);
        if (found == object.end()) {
            if (field->need == Required)
                return error_set("it has no '%s'", field->name);
            continue;
        }
        /* The elements of a list name themselves. */
        if (!check_value(root, *found, *field))
            return found->is_array() && field->kind == Kind::Objects
                       ? false
                       : error_prefix("%s", field->name);
        if (field->kind == Kind::Variant && !check_variant(object, *found, fields))
            return false;
    }
    return true;
}

/* The bytes that a data URI stands for; tinygltf takes base64 alone. */
bool data_size(const std::string &uri, size_t *size) {
    size_t comma = uri.find(',');
    if (comma == std::string::npos || uri.rfind(";base64", comma) != comma - 7)
        return error_set("its data URI is not in base64");
    size_t end = uri.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                                       "0123456789+/",
                                       comma + 1);
    *size = (std::min(end, uri.size()) - comma - 1) * 3 / 4;
    return true;
}

bool check_buffer(const json &buffer, bool first, size_t bin_size) {
    size_t size = buffer["byteLength"], there = size;
    if (size == 0)
        return error_set("byteLength is 0");
    if (!buffer.contains("uri")) {
        if (buffer.contains(json::json_pointer("/extensions/EXT_meshopt_compression")))
            return error_set("compressed with EXT_meshopt_compression, which is not read");
        if (!first || bin_size == 0)
            return error_set("it has no uri, and there is no BIN chunk for it");
        return size <= bin_size ||
               error_set("byteLength is %zu, but the BIN chunk has %zu bytes", size, bin_size);
    }
    const std::string uri = buffer["uri"];
    if (uri.compare(0, 5, "data:") == 0 && !data_size(uri, &there))
        return false;
    return there == size ||
           error_set("byteLength is %zu, but its data URI has %zu bytes", size, there);
}

bool check_view(const json &root, const json &view) {
    size_t buffer = view["buffer"], offset = view.value("byteOffset", size_t(0));
    size_t size = view["byteLength"], stride = view.value("byteStride", size_t(4));
    size_t available = root["buffers"][buffer]["byteLength"];
    if (offset > available || size > available - offset)
        return error_set("%zu bytes at %zu are outside buffer %zu of %zu bytes", size, offset,
                         buffer, available);
    if (stride < 4 || stride > 252 || stride % 4 != 0)
        return error_set("byteStride: %zu is not a multiple of 4 from 4 to 252", stride);
    return true;
}

/* bin_size = bytes of the BIN chunk. */
bool check_bytes(const json &root, size_t bin_size) {
    for (size_t i = 0; i < list_size(root, "/buffers"); i++)
        if (!check_buffer(root["buffers"][i], i == 0, bin_size))
            return error_prefix("buffer %zu", i);
    for (size_t i = 0; i < list_size(root, "/bufferViews"); i++)
        if (!check_view(root, root["bufferViews"][i]))
            return error_prefix("buffer view %zu", i);
    return true;
}

bool check_animations(const json &root) {
    for (size_t i = 0; i < list_size(root, "/animations"); i++) {
        const json &animation = root["animations"][i];
        size_t samplers = animation["samplers"].size();
        for (const json &channel : animation["channels"])
            if (channel["sampler"].get<uint64_t>() >= samplers)
                return error_set("animation %zu: a channel's sampler is %s, but there are %zu", i,
                                 quote(channel["sampler"]).c_str(), samplers);
    }
    return true;
}

/* Told before parsing, which recurses; the parser's own callback would cost the square of a list's
 * length. */
bool is_nested_deeper(const char *text, size_t size, int most) {
    bool quoted = false;
    int depth = 0;
    for (size_t i = 0; i < size; i++) {
        char c = text[i];
        if (quoted && c == '\\')
            i++;
        else if (c == '"')
            quoted = !quoted;
        else if (!quoted && (c == '[' || c == '{') && ++depth > most)
            return true;
        else if (!quoted && (c == ']' || c == '}'))
            depth--;
    }
    return false;
}

} // namespace

bool check_schema(const char *text, size_t size, size_t bin_size) {
    if (is_nested_deeper(text, size, 64))
        return error_set("the JSON is nested too deep");
    json root = json::parse(text, text + size);
    if (!root.is_object())
        return error_set("the JSON is not an object");
    return check_fields(root, root, file) && check_bytes(root, bin_size) && check_animations(root);
}

} // namespace gltf
