#include "viewer/relevance.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

const struct relevance relevances[] = {
    {"lights.surface-points", "lights.bounces>1"},
    {"clustered.bounce-vals", "lights.bounces>1"},
    {"lookup.terms", "clustered.visibility=cssm"},
    {"lookup.shift", "clustered.visibility=cssm"},
    {"lookup.gain", "clustered.visibility=cssm"},
    {"lookup.sharpen-a", "clustered.visibility=cssm"},
    {"lookup.sharpen-b", "clustered.visibility=cssm"},
    {"lookup.sharpen-b", "lookup.sharpen-a>0"},
    {"lookup.filter-jacobian", "clustered.visibility=cssm"},
    {"lookup.taps", "clustered.visibility=pcss|ray"},
    {"gather.clamp-value", "gather.clamp=value"},
    {"gather.near-reach", "gather.clamp=near"},
    {"gather.near-samples", "gather.clamp=near"},
    {"gather.take-back", "gather.clamp=near"},
    {"gather.detail", "blur.radius!=0"},
    {"gather.detail-times", "blur.radius!=0"},
    {"gather.detail-times", "gather.detail>0"},
    {"gather.detail-share", "blur.radius!=0"},
    {"gather.detail-share", "gather.detail>0"},
    {"lightcuts.detail-nodes", "blur.radius!=0"},
    {"lightcuts.detail-nodes", "gather.detail>0"},
    {"blur.separable", "blur.radius!=0"},
    {"blur.distance", "blur.radius!=0"},
    {"caster.bend", "caster.long>0"},
    {NULL, NULL},
};

static bool has_part(const struct technique *technique, const struct settings_part *part) {
    const struct settings_part *const *p = technique->parts;
    while (*p && *p != part)
        p++;
    return *p;
}

static double number_of(const struct setting *setting, const struct settings *settings) {
    return option_number(setting->option, settings_of(settings, setting->part));
}

/* Whether the setting has one of the values, "pcss|ray". */
static bool is_one_of(const struct setting *setting, const struct settings *settings,
                      const char *values) {
    for (const char *at = values; *at; at += strcspn(at, "|"), at += *at == '|') {
        struct settings told = *settings;
        char value[32];
        snprintf(value, sizeof value, "%.*s", (int)strcspn(at, "|"), at);
        if (setting_parse(setting, &told, value) && setting_equal(setting, settings, &told))
            return true;
    }
    return false;
}

static bool holds(const char *needs, const struct settings *settings,
                  const struct technique *technique) {
    int length = (int)strcspn(needs, "=!>");
    char name[SETTING_NAME_SIZE];
    const char *sign = needs + length;
    struct setting setting;
    snprintf(name, sizeof name, "%.*s", length, needs);
    bool found = settings_find(settings, name, &setting);
    assert(found);
    if (!found || !has_part(technique, setting.part))
        return false;
    if (*sign == '>') {
        struct settings bound = *settings;
        return setting_parse(&setting, &bound, sign + 1) &&
               number_of(&setting, settings) > number_of(&setting, &bound);
    }
    return is_one_of(&setting, settings, sign + strspn(sign, "!=")) == (*sign == '=');
}

bool setting_matters(const struct setting *setting, const struct settings *settings,
                     const struct technique *technique) {
    char name[SETTING_NAME_SIZE];
    setting_name(setting, name);
    for (const struct relevance *row = relevances; row->name; row++)
        if (strcmp(row->name, name) == 0 && !holds(row->needs, settings, technique))
            return false;
    return true;
}
