/* What the standard demands of a file's JSON, as far as we rely on it.
 *
 * tinygltf casts, drops or ignores where it should refuse, and recurses as deep as a file asks it
 * to. So the JSON is held against a table first: types, ranges, and that every index points at
 * something. Whoever reads the model afterwards need not ask again.
 */
#include "scene/gltf/model.hpp"
#include "scene/gltf/schema.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>

namespace gltf {
namespace {

using nlohmann::json;

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

/* A buffer that is not in the file: its views are packed. */
const json::json_pointer packed_mark("/extensions/EXT_meshopt_compression");

bool check_buffer(const json &buffer, bool first, size_t bin_size) {
    size_t size = buffer["byteLength"], there = size;
    if (size == 0)
        return error_set("byteLength is 0");
    if (!buffer.contains("uri")) {
        if (buffer.contains(packed_mark))
            return true;
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

/* tinygltf asks for a buffer's bytes by its uri: one that is not in the file gets one that tells its
 * size. */
bool name_absent(json &root) {
    bool any = false;
    for (size_t i = 0; i < list_size(root, "/buffers"); i++) {
        json &buffer = root["buffers"][i];
        if (buffer.contains("uri") || !buffer.contains(packed_mark))
            continue;
        buffer["uri"] = absent_prefix + buffer["byteLength"].dump();
        any = true;
    }
    return any;
}

/* tinygltf wants the indices of a primitive in a buffer view: those of a packed one are in its, until
 * they are unpacked. */
bool place_packed_indices(json &root) {
    const json::json_pointer packed("/extensions/KHR_draco_mesh_compression/bufferView");
    bool any = false;
    for (size_t i = 0; i < list_size(root, "/meshes"); i++)
        for (const json &primitive : root["meshes"][i]["primitives"]) {
            if (!primitive.contains(packed) || !primitive.contains("indices"))
                continue;
            json &accessor = root["accessors"][primitive["indices"].get<size_t>()];
            any |= accessor.emplace("bufferView", primitive[packed]).second;
        }
    return any;
}

} // namespace

bool check_schema(const char *text, size_t size, size_t bin_size, std::string &changed) {
    if (is_nested_deeper(text, size, 64))
        return error_set("the JSON is nested too deep");
    json root = json::parse(text, text + size);
    if (!root.is_object())
        return error_set("the JSON is not an object");
    if (!check_fields(root, root, file) || !check_bytes(root, bin_size) || !check_animations(root))
        return false;
    bool absent = name_absent(root), packed = place_packed_indices(root);
    if (absent || packed)
        changed = root.dump();
    return true;
}

} // namespace gltf
