#include "renderer/settings.h"

#include "base/error.h"
#include "base/names.h"
#include "direct/direct.h"
#include "direct/environment.h"
#include "passes/picture/composite.h"
#include "scene/caustics.h"
#include "scene/material.h"
#include "scene/medium.h"
#include "techniques/many_lights.h"
#include "techniques/volume.h"

#include "parts.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const tone_map_names[] = {"clamp", "filmic", NULL};

static const struct option table[] = {
    {"exposure", 0, OPTION_FLOAT, offsetof(struct picture_settings, exposure), 0, -EXPOSURE_MOST,
     EXPOSURE_MOST, .label = "exposure, EV",
     .help = "exposure of the picture, EV; 1 more doubles the brightness"},
    {"samples", 0, OPTION_INT, offsetof(struct picture_settings, samples), 12, 1, 16,
     .label = "edge samples",
     .help = "samples per pixel for antialiasing of edges, rounded\n"
             "up to a multiple of 4, or of 8 or 16 as the driver\n"
             "has; 1: the pixel centre alone"},
    {"tone-map", 0, OPTION_CHOICE, offsetof(struct picture_settings, tone_map), TONE_MAP_CLAMP,
     .label = "tone map", .choices = tone_map_names,
     .help = "tone curve of bright light in PNG, JPEG\n"
             "and on the screen: cut off, or filmic"},
    {NULL},
};

const struct settings_part picture_part = {"picture", "picture", table,
                                           sizeof(struct picture_settings)};

static void add_parts(struct settings *settings, const struct settings_part *const *parts) {
    for (; *parts; parts++)
        settings_add(settings, *parts);
}

void renderer_settings_init(struct settings *settings) {
    *settings = (struct settings){0};
    for (const struct technique *const *t = techniques; *t; t++)
        add_parts(settings, (*t)->parts);
    for (const struct direct_method *const *d = direct_methods; *d; d++)
        add_parts(settings, (*d)->parts);
    /* Of ambient occlusion, whatever the technique. */
    IF_VOLUME(settings_add(settings, &volume_part), (void)0);
    settings_add(settings, &sky_part);
    settings_add(settings, &material_part);
    settings_add(settings, &medium_part);
    settings_add(settings, &caustics_part);
    settings_add(settings, &picture_part);
}

/* --- texts --- */

static const char preset_key[] = "path=";

static bool apply_preset(struct settings *settings, const struct technique *technique,
                         const struct word *name) {
    struct names names = {0};
    for (const struct preset *p = technique->presets; p && p->name; p++) {
        if (word_is(name, p->name) || (p->word && word_is(name, p->word)))
            return settings_assign(settings, p->settings);
        names_add(&names, ", ", p->name);
        if (p->word)
            names_add(&names, ", ", p->word);
    }
    return error_set("path: '%.*s' is not one of %s's: %s", name->length, name->at, technique->name,
                     names.length ? names.text : "it has none");
}

static bool assign(struct settings *settings, const struct technique *technique,
                   const struct word *word, bool presets) {
    int key = (int)strlen(preset_key);
    if (strncmp(word->at, preset_key, (size_t)key) != 0)
        return presets || settings_give_word(settings, word);
    struct word name = {word->at + key, word->length - key};
    return !presets || apply_preset(settings, technique, &name);
}

bool renderer_settings_assign(struct settings *settings, const struct technique *technique,
                              const char *const *texts, int count) {
    for (int presets = 1; presets >= 0; presets--)
        for (int i = 0; i < count; i++)
            for (struct word word = {.at = texts[i]}; word_next(&word);)
                if (!assign(settings, technique, &word, presets))
                    return false;
    return true;
}

struct settings renderer_settings_chosen(const struct settings *settings,
                                         const struct technique *technique,
                                         const struct scene *scene,
                                         const struct geometry *geometry) {
    return many_lights_chosen(settings,
                              technique->by_rays && technique->by_rays(settings, scene, geometry));
}

bool renderer_settings_same(const struct settings *a, const struct settings *b,
                            const struct settings_part *const *parts) {
    for (; *parts; parts++)
        if (!settings_same(a, b, *parts))
            return false;
    return true;
}

static void set_samples(struct settings *settings, int samples) {
    struct picture_settings picture =
        *settings_of(struct picture_settings, settings, &picture_part);
    picture.samples = samples;
    settings_set(settings, &picture_part, &picture);
}

void renderer_settings_roughen(struct settings *settings) {
    set_samples(settings, 1);
}

void renderer_settings_copy_but_samples(struct settings *to, const struct settings *from) {
    int samples = settings_of(struct picture_settings, to, &picture_part)->samples;
    *to = *from;
    set_samples(to, samples);
}

/* --- needs --- */

/* Whether a need of a technique holds; of another setting: true. */
static bool allows(const struct need *need, const struct technique *technique) {
    return strcmp(need->name, "technique") != 0 ||
           need_names(need, technique->name) == (need->sign == '=');
}

/* Whether the technique reads it: all that its row says of techniques holds. */
static bool is_read(const struct setting *setting, const struct technique *technique) {
    bool all = true;
    for (struct need need = {.word.at = setting->option->needs}; all && need_next(&need);)
        all = allows(&need, technique);
    return all;
}

static bool technique_has(const struct technique *technique, const struct setting *setting) {
    return settings_parts_have(technique->parts, setting->part) && is_read(setting, technique);
}

static bool holds(const struct need *need, const struct settings *settings,
                  const struct technique *technique) {
    struct setting setting;
    char value[32];
    if (strcmp(need->name, "technique") == 0)
        return allows(need, technique);
    if (!settings_find(settings, need->name, &setting) || /* of a technique that was left out */
        !settings_parts_have(technique->parts, setting.part))
        return need->sign == '!';
    if (!is_read(&setting, technique))
        return true;
    setting_format(&setting, settings, value, sizeof value);
    if (need->sign == '>')
        return atof(value) > atof(need->values);
    return need_names(need, value) == (need->sign == '=');
}

bool setting_matters(const struct setting *setting, const struct settings *settings,
                     const struct technique *technique) {
    bool all = true;
    for (struct need need = {.word.at = setting->option->needs}; all && need_next(&need);)
        all = holds(&need, settings, technique);
    return all;
}

/* --- help --- */

/* With what it needs of the technique's other settings. */
static void print_setting(FILE *out, const struct setting *setting,
                          const struct technique *technique) {
    struct names with = {0};
    struct settings settings;
    struct setting other;
    renderer_settings_init(&settings);
    for (struct need need = {.word.at = setting->option->needs}; need_next(&need);)
        if (strcmp(need.name, "technique") != 0 && settings_find(&settings, need.name, &other) &&
            technique_has(technique, &other)) {
            char text[2 * SETTING_NAME_SIZE];
            snprintf(text, sizeof text, "%.*s", need.word.length, need.word.at);
            names_add(&with, " and ", text);
        }
    setting_print_help(out, setting, with.text);
}

/* Those of a part that the technique reads, under its title. */
static void print_part(FILE *out, const struct settings_part *part,
                       const struct technique *technique) {
    fprintf(out, "\n  %s:\n", part->title);
    for (const struct option *option = part->table; option->name; option++) {
        struct setting setting = {part, option};
        if (is_read(&setting, technique))
            print_setting(out, &setting, technique);
    }
}

/* Those that methods share with the first of them. */
static void print_direct_parts(FILE *out, const struct technique *technique) {
    for (const struct direct_method *const *d = direct_methods; *d; d++)
        for (const struct settings_part *const *p = (*d)->parts; *p; p++) {
            const struct direct_method *const *first = direct_methods;
            while (!settings_parts_have((*first)->parts, *p))
                first++;
            if (first == d)
                print_part(out, *p, technique);
        }
}

static void print_presets(FILE *out, const struct technique *technique) {
    if (technique->presets && technique->presets->name)
        fprintf(out, "\n  presets, by either name; other settings override them:\n");
    for (const struct preset *p = technique->presets; p && p->name; p++)
        fprintf(out, "  path=%-8s %-12s %s\n", p->name, p->word ? p->word : "", p->help);
}

static void print_all(FILE *out, const struct technique *technique) {
    for (const struct settings_part *const *part = technique->parts; *part; part++)
        print_part(out, *part, technique);
    print_direct_parts(out, technique);
    print_part(out, &sky_part, technique);
    print_part(out, &material_part, technique);
    print_part(out, &medium_part, technique);
    print_part(out, &caustics_part, technique);
    print_part(out, &picture_part, technique);
}

static bool is_picture(const struct setting *setting) {
    return setting->part == &picture_part || setting->part == &material_part;
}

/* Those most often set; and all that another technique than the default calls its own. */
static void print_main(FILE *out, const struct technique *technique) {
    static const char *const names[] = {
        "lights.vpls",          "lights.bounces",   "clustered.trace",   "clustered.vals",
        "clustered.visibility", "map.size",         "gather.interleave", "gather.adaptive",
        "surface.materials",    "picture.exposure", "picture.samples",   "picture.tone-map",
    };
    struct settings settings;
    renderer_settings_init(&settings);
    fprintf(out, "\n  main settings:\n");
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        struct setting setting;
        if (settings_find(&settings, names[i], &setting) &&
            (technique_has(technique, &setting) || is_picture(&setting)))
            print_setting(out, &setting, technique);
    }
    for (const struct settings_part *const *part = technique->parts; *part; part++)
        if (technique != technique_default && strcmp((*part)->owner, technique->name) == 0)
            print_part(out, *part, technique);
}

void renderer_settings_print_help(FILE *out, const struct technique *technique, bool all) {
    fprintf(out,
            "\nsettings of %s, for --set NAME=VALUE; a name's last word suffices if no other name "
            "has it\n"
            "(--technique NAME --help lists the settings of another technique):\n",
            technique->name);
    print_presets(out, technique);
    (all ? print_all : print_main)(out, technique);
}
