/* What the standard demands of a file's JSON, as far as we rely on it.
 *
 * tinygltf casts, drops or ignores where it should refuse, and recurses as deep as a file asks it
 * to. So the JSON is held against a table first: types, ranges, and that every index points at
 * something. Whoever reads the model afterwards need not ask again. A defect that changes no
 * picture, or that other readers pass over, is mended in the JSON, and told. */
#include "scene/gltf/json.hpp"
#include "scene/gltf/schema.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace gltf {

size_t list_size(const json &root, const char *pointer) {
    json::json_pointer at(pointer);
    return root.contains(at) && root[at].is_array() ? root[at].size() : 0;
}

std::string quote(const json &value) {
    std::string text = value.is_structured()
                           ? value.type_name()
                           : value.dump(-1, ' ', true, json::error_handler_t::replace);
    return text.size() > 40 ? text.substr(0, 40) + "..." : text;
}

std::string label_of(const char *noun, size_t index, const json &element) {
    bool named = element.is_object() && element.contains("name") && element["name"].is_string();
    return label(noun, index, named ? element["name"].get<std::string>() : "");
}

namespace {

/* An element of a list that is being checked. */
struct Place {
    const char *noun;
    size_t index;
    const json *element;
};

struct Check {
    Loader &loader;
    const json &root;
    std::vector<Place> places; /* the list's element, its list's element and so on, from outside */
};

bool check_fields(Check &check, json &object, const Field *fields);

/* A field of the element that is being checked has a defect. */
bool mend_field(Check &check, const char *what, const Field &field) {
    std::string object;
    for (const Place &place : check.places)
        object += label_of(place.noun, place.index, *place.element) + ": ";
    return mend(check.loader, what, object + field.name);
}

/* 4.0 and -0 become whole numbers. */
bool make_whole(Check &check, json &value, const Field &field) {
    const double most = 9007199254740992; /* 2^53: all below are exact */
    if (value.is_number_integer() && !value.is_number_unsigned() && value.get<int64_t>() == 0)
        value = 0u;
    if (!value.is_number_float())
        return true;
    double number = value.get<double>();
    if (!(number >= 0 && number < most && number == std::floor(number)))
        return true;
    value = uint64_t(number);
    return mend_field(check, "numbers written as fractions are taken as whole", field);
}

bool check_index(Check &check, json &value, const Field &field) {
    size_t size = list_size(check.root, field.of);
    if (!make_whole(check, value, field))
        return false;
    if (value.is_number_unsigned() && value.get<uint64_t>() < size)
        return true;
    return error_set("%s, but there are %zu %s", quote(value).c_str(), size,
                     strrchr(field.of, '/') + 1);
}

bool check_choice(Check &check, json &value, const Field &field) {
    if (!make_whole(check, value, field))
        return false;
    std::string word = value.is_string() ? value.get<std::string>() : value.dump();
    if (word.find(' ') == std::string::npos &&
        (std::string(field.of) + " ").find(" " + word + " ") != std::string::npos)
        return true;
    return error_set("%s is none of%s", quote(value).c_str(), field.of);
}

bool check_elements(Check &check, json &list, const Field &field) {
    if (!list.is_array())
        return error_set("%s is not an array", quote(list).c_str());
    for (size_t i = 0; i < list.size(); i++) {
        json &element = list[i];
        check.places.push_back({field.of, i, &element});
        if (!element.is_object() ? !error_set("%s is not an object", quote(element).c_str())
                                 : !check_fields(check, element, field.fields))
            return error_prefix("%s", label_of(field.of, i, element).c_str());
        check.places.pop_back();
    }
    return true;
}

bool check_each_index(Check &check, json &list, Kind kind, const Field &field) {
    if (kind == Kind::Indices ? !list.is_array() : !list.is_object())
        return error_set("%s is not %s", quote(list).c_str(),
                         kind == Kind::Indices ? "an array" : "an object");
    for (auto it = list.begin(); it != list.end(); ++it)
        if (!check_index(check, *it, field))
            return kind == Kind::Indices ? false : error_prefix("%.40s", it.key().c_str());
    return true;
}

bool check_index_maps(Check &check, json &list, const Field &field) {
    if (!list.is_array())
        return error_set("%s is not an array", quote(list).c_str());
    for (json &map : list)
        if (!check_each_index(check, map, Kind::IndexMap, field))
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

/* Of a share to 0 to 1; of a positive number what rounding has made negative. */
bool clamp(Check &check, json &value, const Field &field) {
    if (!value.is_number())
        return error_set("%s is not a number", quote(value).c_str());
    bool is_share = field.kind == Kind::Share || field.kind == Kind::Shares;
    double number = value.get<double>();
    if (is_share && (number < 0 || number > 1)) {
        value = number < 0 ? 0. : 1.;
        return mend_field(check, "numbers that are not from 0 to 1 are clamped", field);
    }
    if (!is_share && number < 0 && number >= -rounding) {
        value = 0.;
        return mend_field(check, "numbers just below 0 are taken as 0", field);
    }
    return true;
}

/* Of a colour. */
bool clamp_each(Check &check, json &list, const Field &field) {
    bool lacks_alpha = field.count == 4 && list.is_array() && list.size() == 3;
    if (list.is_array() && (list.size() > field.count || lacks_alpha)) {
        while (list.size() > field.count)
            list.erase(list.size() - 1);
        if (lacks_alpha)
            list.push_back(1.);
        if (!mend_field(check, "colours of other than 3 or 4 numbers are cut or made opaque",
                        field))
            return false;
    }
    if (!check_numbers(list, field.count))
        return false;
    for (json &value : list)
        if (!clamp(check, value, field))
            return false;
    return true;
}

bool check_flag(Check &check, json &value, const Field &field) {
    if (value.is_boolean())
        return true;
    if (value != 0 && value != 1)
        return error_set("%s is neither true nor false", quote(value).c_str());
    value = value == 1;
    return mend_field(check, "0 and 1 are taken as false and true", field);
}

bool check_value(Check &check, json &value, const Field &field) {
    switch (field.kind) {
    case Kind::Index:
        return check_index(check, value, field);
    case Kind::Indices:
    case Kind::IndexMap:
        return check_each_index(check, value, field.kind, field);
    case Kind::IndexMaps:
        return check_index_maps(check, value, field);
    case Kind::Size:
        return make_whole(check, value, field) &&
               (value.is_number_unsigned() ||
                error_set("%s is not a whole number from 0", quote(value).c_str()));
    case Kind::Int:
        return make_whole(check, value, field) &&
               ((value.is_number_unsigned() && value.get<uint64_t>() <= INT32_MAX) ||
                error_set("%s is not a whole number from 0 to 2^31 - 1", quote(value).c_str()));
    case Kind::Number:
        return value.is_number() || error_set("%s is not a number", quote(value).c_str());
    case Kind::Numbers:
        return check_numbers(value, field.count);
    case Kind::Share:
    case Kind::Positive:
        return clamp(check, value, field);
    case Kind::Shares:
    case Kind::Positives:
        return clamp_each(check, value, field);
    case Kind::Flag:
        return check_flag(check, value, field);
    case Kind::Text:
        return value.is_string() || error_set("%s is not a string", quote(value).c_str());
    case Kind::Choice:
    case Kind::Hint:
    case Kind::Variant:
        return check_choice(check, value, field);
    case Kind::Object:
        return value.is_object() ? check_fields(check, value, field.fields)
                                 : error_set("%s is not an object", quote(value).c_str());
    case Kind::Objects:
        return check_elements(check, value, field);
    }
    return false;
}

bool all_optional(const Field *fields) {
    for (; fields->name; fields++)
        if (fields->need == Required)
            return false;
    return true;
}

/* The object that a variant needs; one that may be empty is made. */
bool check_variant(Check &check, json &object, const std::string &name, const Field *fields) {
    for (const Field *field = fields; field->name; field++)
        if (name == field->name && !object.contains(name)) {
            if (!all_optional(field->fields))
                return error_set("it has no '%s'", field->name);
            object[name] = json::object();
            return mend_field(check, "an object that is not there has its defaults", *field);
        }
    return true;
}

bool check_field(Check &check, json &object, json &value, const Field &field, const Field *fields) {
    if (check_value(check, value, field))
        return field.kind != Kind::Variant || check_variant(check, object, value, fields);
    if (field.kind == Kind::Hint && !read_rules_are_strict()) {
        object.erase(field.name);
        return mend_field(check, "words that do not exist are left out", field);
    }
    /* The elements of a list name themselves. */
    return value.is_array() && field.kind == Kind::Objects ? false : error_prefix("%s", field.name);
}

bool check_fields(Check &check, json &object, const Field *fields) {
    for (const Field *field = fields; field->name; field++) {
        auto found = object.find(field->name);
        if (found != object.end() && found->is_null()) {
            object.erase(found);
            found = object.end();
            if (!mend_field(check, "fields that are null are left out", *field))
                return false;
        }
        if (found == object.end()) {
            if (field->need == Required)
                return error_set("it has no '%s'", field->name);
            continue;
        }
        if (!check_field(check, object, *found, *field, fields))
            return false;
    }
    return true;
}

/* Why each sampler is none; "" = it is one. */
std::vector<std::string> check_samplers(Check &check, json &animation) {
    std::vector<std::string> reasons;
    json stub = {{"input", 0}, {"output", 0}};
    for (json &sampler : animation["samplers"]) {
        bool good = sampler.is_object() ? check_fields(check, sampler, channel_sampler)
                                        : error_set("%s is not an object", quote(sampler).c_str());
        reasons.push_back(good ? "" : error_get());
        if (!good)
            sampler = stub; /* for tinygltf, which asks for numbers; no channel has it */
    }
    return reasons;
}

bool check_channel(Check &check, json &value, const std::vector<std::string> &samplers) {
    if (!value.is_object())
        return error_set("%s is not an object", quote(value).c_str());
    if (!check_fields(check, value, channel))
        return false;
    value["target"].emplace("node", -1); /* tinygltf wants one */
    size_t sampler = value["sampler"].get<size_t>();
    if (sampler >= samplers.size())
        return error_set("its sampler is %zu, but there are %zu", sampler, samplers.size());
    return samplers[sampler].empty() ||
           error_set("sampler %zu: %s", sampler, samplers[sampler].c_str());
}

/* Leaves out the channels that are none. */
bool check_animation(Check &check, json &animation, const std::string &object) {
    if (!animation.is_object() || !animation.contains("channels") ||
        !animation["channels"].is_array() || !animation.contains("samplers") ||
        !animation["samplers"].is_array()) {
        animation = {{"channels", json::array()}, {"samplers", json::array()}};
        return mend(check.loader, bad_clips, object + ": it has no channels or no samplers");
    }
    std::vector<std::string> samplers = check_samplers(check, animation);
    json &channels = animation["channels"], good = json::array();
    for (size_t i = 0; i < channels.size(); i++) {
        if (check_channel(check, channels[i], samplers))
            good.push_back(std::move(channels[i]));
        else if (!mend(check.loader, bad_clips,
                       object + ": channel " + std::to_string(i) + ": " + error_get()))
            return false;
    }
    channels = std::move(good);
    return true;
}

bool check_animations(Check &check, json &root) {
    auto found = root.find("animations");
    if (found == root.end())
        return true;
    if (!found->is_array())
        *found = json::array({*found});
    for (size_t i = 0; i < found->size(); i++) {
        json &animation = (*found)[i];
        check.places.assign(1, {"animation", i, &animation});
        if (!check_animation(check, animation, label_of("animation", i, animation)))
            return false;
    }
    return true;
}

} // namespace

bool check_schema(Loader &loader, json &root) {
    Check check = {loader, root, {}};
    return check_fields(check, root, file) && check_animations(check, root);
}

} // namespace gltf
