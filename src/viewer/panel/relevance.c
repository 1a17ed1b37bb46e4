#include "viewer/panel/relevance.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

/* A setting, or the owner of several, and what must hold for it to change anything: another setting, "=", ">"
 * or "!=", and a value, or several with bars between. One may stand in several rows: all must hold. */
struct relevance {
    const char *name, *needs;
};

static const struct relevance of_all[] = {
    {"lights.paths", "lights.bounces>1"},
    {"clustered.bounce-vals", "lights.bounces>1"},
    {"lookup.terms", "clustered.visibility=cssm"},
    {"lookup.shift", "clustered.visibility=cssm"},
    {"lookup.gain", "clustered.visibility=cssm"},
    {"lookup.sharpen-a", "clustered.visibility=cssm"},
    {"lookup.filter-jacobian", "clustered.visibility=cssm"},
    {"lookup.taps", "clustered.visibility=pcss|ray"},
    {"gather.clamp-value", "gather.clamp=value"},
    {"gather.near-reach", "gather.clamp=near"},
    {"gather.near-samples", "gather.clamp=near"},
    {"gather.detail", "blur.radius!=0"},
    {"gather.detail-times", "blur.radius!=0"},
    {"gather.detail-times", "gather.detail>0"},
    {"gather.detail-share", "blur.radius!=0"},
    {"gather.detail-share", "gather.detail>0"},
    {"gather.further-points", "blur.radius!=0"},
    {"gather.further-points", "gather.detail>0"},
    {"blur.separable", "blur.radius!=0"},
    {"blur.distance", "blur.radius!=0"},
};

/* Of area lights, which have a form where others have a clamp, and a pattern where others are interleaved. */
static const struct relevance of_cluster_lights[] = {
    {"clustered", "cluster-lights.shadows=vals"},
    {"map", "cluster-lights.shadows=vals"},
    {"lookup", "cluster-lights.shadows=vals"},
    {"caster", "cluster-lights.shadows=vals"},
    {"cluster-lights.near", "cluster-lights.form=rectangle"},
    {"gather.clamp-value", "cluster-lights.seeds=importance"},
    {"gather.near-reach", "cluster-lights.near>0"},
    {"gather.near-reach", "cluster-lights.form=rectangle"},
    {"gather.detail", "cluster-lights.pattern=1"},
    {"gather.detail-share", "cluster-lights.pattern=1"},
    {"gather.further-points", "cluster-lights.pattern=1"},
    {"blur.separable", "cluster-lights.pattern>1"},
};

#define COUNT(rows) (int)(sizeof(rows) / sizeof *(rows))

static bool has_part(const struct technique *technique, const struct settings_part *part) {
    const struct settings_part *const *p = technique->parts;
    while (*p && *p != part)
        p++;
    return *p;
}

static double number_of(const struct setting *setting, const struct settings *settings) {
    return setting_number(setting, settings);
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

/* The setting that a need speaks of. */
static struct setting needed(const char *needs, const struct settings *settings) {
    char name[SETTING_NAME_SIZE];
    struct setting setting = {0};
    snprintf(name, sizeof name, "%.*s", (int)strcspn(needs, "=!>"), needs);
    bool found = settings_find(settings, name, &setting);
    assert(found);
    (void)found;
    return setting;
}

static bool holds(const char *needs, const struct settings *settings,
                  const struct technique *technique) {
    const char *sign = needs + strcspn(needs, "=!>");
    struct setting setting = needed(needs, settings);
    if (setting_is_among(&setting, technique->unused))
        return true;
    if (!has_part(technique, setting.part))
        return false;
    if (*sign == '>') {
        struct settings bound = *settings;
        return setting_parse(&setting, &bound, sign + 1) &&
               number_of(&setting, settings) > number_of(&setting, &bound);
    }
    return is_one_of(&setting, settings, sign + strspn(sign, "!=")) == (*sign == '=');
}

static bool is_of(const struct relevance *row, const struct setting *setting) {
    return strcmp(row->name, setting->part->owner) == 0 || setting_is_among(setting, row->name);
}

static bool all_hold(const struct relevance *rows, int count, const struct setting *setting,
                     const struct settings *settings, const struct technique *technique) {
    for (int i = 0; i < count; i++)
        if (is_of(&rows[i], setting) && !holds(rows[i].needs, settings, technique))
            return false;
    return true;
}

bool setting_matters(const struct setting *setting, const struct settings *settings,
                     const struct technique *technique) {
    bool of_areas = strcmp(technique->name, "cluster-lights") == 0;
    return !setting_is_among(setting, technique->unused) &&
           all_hold(of_all, COUNT(of_all), setting, settings, technique) &&
           (!of_areas ||
            all_hold(of_cluster_lights, COUNT(of_cluster_lights), setting, settings, technique));
}
