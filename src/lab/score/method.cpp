#include "lab/score/method.h"

#include "base/json_library.hpp"

extern "C" {
#include "base/error.h"
#include "base/memory.h"
}

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

using nlohmann::json;

namespace {

enum class Kind { Text, Number, Whole, Flag, Texts, Times, Sums };

struct Field {
    const char *name;
    Kind kind;
    bool required;
};

const Field fields[] = {
    {"name", Kind::Text, true},
    {"version", Kind::Text, false},
    {"url", Kind::Text, false},
    {"licence", Kind::Text, false},
    {"device", Kind::Text, false},
    {"driver", Kind::Text, false},
    {"layers", Kind::Texts, false},         /* besides beauty */
    {"ms", Kind::Times, false},             /* of one frame */
    {"history_frames", Kind::Whole, false}, /* before a frame that it needs */
    {"denoiser", Kind::Text, false},
    {"hardware_rays", Kind::Flag, false},
    {"precomputed_s", Kind::Number, false},
    {"sha256", Kind::Sums, false}, /* of pictures, by the names of their files */
};

const Field times[] = {
    {"median", Kind::Number, false},
    {"p99", Kind::Number, false},
    {"frames", Kind::Whole, false}, /* measured */
    {"covers", Kind::Text, false},  /* what is in the time */
};

template <size_t count> bool check_fields(const json &object, const Field (&table)[count]);

bool is_count(const json &value) {
    return value.is_number_integer() && value.get<double>() >= 0;
}

bool is_sum(const json &value) {
    if (!value.is_string())
        return false;
    const std::string &text = value.get_ref<const std::string &>();
    return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

bool check_sums(const json &value) {
    if (!value.is_object())
        return error_set("it is no object");
    for (const auto &item : value.items())
        if (!is_sum(item.value()))
            return error_set("%.80s: it is no 64 lower-case hexadecimal digits",
                             item.key().c_str());
    return true;
}

bool check_value(const json &value, const Field &field) {
    switch (field.kind) {
    case Kind::Text:
        return (value.is_string() && !value.get_ref<const std::string &>().empty()) ||
               error_set("%s: it is no text", field.name);
    case Kind::Number:
        return (value.is_number() && value.get<double>() >= 0) ||
               error_set("%s: it is no number from 0 up", field.name);
    case Kind::Whole:
        return is_count(value) || error_set("%s: it is no whole number from 0 up", field.name);
    case Kind::Flag:
        return value.is_boolean() || error_set("%s: it is neither true nor false", field.name);
    case Kind::Texts:
        for (const json &text : value)
            if (!value.is_array() || !text.is_string())
                return error_set("%s: it is no list of texts", field.name);
        return value.is_array() || error_set("%s: it is no list of texts", field.name);
    case Kind::Times:
        return check_fields(value, times) || error_prefix("%s", field.name);
    case Kind::Sums:
        return check_sums(value) || error_prefix("%s", field.name);
    }
    return false;
}

/* What is missing may be null as well. */
template <size_t count> bool check_fields(const json &object, const Field (&table)[count]) {
    if (!object.is_object())
        return error_set("it is no object");
    for (const Field &field : table) {
        bool is_there = object.contains(field.name) && !object[field.name].is_null();
        if (!is_there && field.required)
            return error_set("%s is missing", field.name);
        if (is_there && !check_value(object[field.name], field))
            return false;
    }
    for (const auto &item : object.items()) {
        bool known = false;
        for (const Field &field : table)
            known |= item.key() == field.name;
        if (!known)
            return error_set("'%.40s' is no field of it", item.key().c_str());
    }
    return true;
}

template <size_t size> void copy_text(char (&to)[size], const json &object, const char *name) {
    if (object.contains(name) && object[name].is_string())
        snprintf(to, size, "%s", object[name].get_ref<const std::string &>().c_str());
}

bool copy_layers(struct method &method, const json &object) {
    if (!object.contains("layers") || object["layers"].is_null())
        return true;
    for (const json &name : object["layers"]) {
        const std::string &text = name.get_ref<const std::string &>();
        if (method.layer_count == METHOD_LAYERS_MAX || text.size() >= sizeof *method.layers)
            return error_set("layers: more than %d, or a name of more than %zu letters",
                             METHOD_LAYERS_MAX, sizeof *method.layers - 1);
        memcpy(method.layers[method.layer_count++], text.c_str(), text.size() + 1);
    }
    return true;
}

void copy_sums(struct method &method, const json &object) {
    if (!object.contains("sha256") || object["sha256"].is_null())
        return;
    const json &sums = object["sha256"];
    method.sums = static_cast<struct method_sum *>(mem_alloc(sums.size(), sizeof *method.sums));
    for (const auto &item : sums.items()) {
        struct method_sum &sum = method.sums[method.sum_count++];
        sum.file = mem_strdup(item.key().c_str());
        snprintf(sum.digits, sizeof sum.digits, "%s",
                 item.value().get_ref<const std::string &>().c_str());
    }
}

bool take(struct method &method, const json &object) {
    if (!check_fields(object, fields) || !copy_layers(method, object))
        return false;
    copy_text(method.name, object, "name");
    copy_text(method.version, object, "version");
    copy_text(method.device, object, "device");
    copy_sums(method, object);
    method.json = mem_strdup(object.dump().c_str());
    return true;
}

} // namespace

bool method_read(struct method *method, const char *path) {
    *method = {};
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return error_set("cannot open %s: %s", path, strerror(errno));
    try {
        json object = json::parse(file);
        return take(*method, object) || error_prefix("%s", path);
    } catch (const json::exception &fault) {
        return error_set("%s: no JSON: %s", path, fault.what());
    }
}

void method_free(struct method *method) {
    for (int i = 0; i < method->sum_count; i++)
        free(method->sums[i].file);
    free(method->sums);
    free(method->json);
    *method = {};
}

const char *method_sum_of(const struct method *method, const char *file) {
    for (int i = 0; i < method->sum_count; i++)
        if (strcmp(method->sums[i].file, file) == 0)
            return method->sums[i].digits;
    return nullptr;
}
