#include "quality/measure.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/text.h"

#include <string.h>

struct measure_desc measure_default(const struct stage *stage, int width, int height) {
    struct measure_desc desc = {
        .stage = stage, .width = width, .height = height, .technique = technique_default};
    renderer_settings_init(&desc.settings);
    return desc;
}

struct measure_desc measure_of(const struct renderer_desc *desc, const struct stage *stage) {
    return (struct measure_desc){.stage = stage,
                                 .width = desc->width,
                                 .height = desc->height,
                                 .technique = desc->technique,
                                 .direct = desc->direct,
                                 .settings = desc->settings};
}

static const struct option size_option = {
    "size", 0, OPTION_SIZE, offsetof(struct measure_desc, width), 800, 1, 16384, .help = ""};

OPTION_ASSERT_SIZE(struct measure_desc, width, height);

/* What is no setting goes into the desc; what is one, to the end of the text. */
static bool sort_out(struct measure_desc *desc, const char *assignment, struct text *settings) {
    if (strncmp(assignment, "size=", 5) == 0)
        return option_parse(&size_option, desc, assignment + 5);
    if (strncmp(assignment, "technique=", 10) == 0)
        return (desc->technique = technique_find(assignment + 10));
    if (strncmp(assignment, "direct=", 7) == 0)
        return (desc->direct = direct_find(assignment + 7));
    text_print(settings, "%s ", assignment);
    return true;
}

bool measure_assign_all(struct measure_desc *desc, const char *const *texts, int count) {
    struct measure_desc changed = *desc;
    struct text settings = {0};
    bool ok = true;
    text_append(&settings, "", 0);
    for (int i = 0; i < count; i++)
        for (struct word word = {.at = texts[i]}; ok && word_next(&word);) {
            char *assignment = mem_printf("%.*s", word.length, word.at);
            ok = sort_out(&changed, assignment, &settings);
            free(assignment);
        }
    const char *text = settings.data;
    ok = ok && renderer_settings_assign(&changed.settings, changed.technique, &text, 1);
    if (ok)
        *desc = changed;
    free(settings.data);
    return ok;
}

bool measure_assign(struct measure_desc *desc, const char *text) {
    return measure_assign_all(desc, &text, text ? 1 : 0);
}

static bool blame(const struct measure_desc *desc) {
    if (*desc->variant)
        error_prefix("%s%s%s", desc->variant, *desc->point ? " " : "", desc->point);
    return false;
}

bool measure_check(const struct measure_desc *desc) {
    return technique_check(desc->technique, &desc->settings) || blame(desc);
}

char *measure_settings(const struct measure_desc *desc) {
    struct settings defaults;
    struct text text = {0};
    renderer_settings_init(&defaults);
    text_append(&text, "", 0);
    for (struct setting setting = {0}; settings_next(&desc->settings, &setting);) {
        char name[SETTING_NAME_SIZE], value[64];
        if (setting_equal(&setting, &desc->settings, &defaults))
            continue;
        setting_name(&setting, name);
        setting_format(&setting, &desc->settings, value, sizeof value);
        text_print(&text, "%s%s=%s", text.length ? " " : "", name, value);
    }
    return text.data;
}

/* Without a stage, as it was given. */
static double chosen_number(const struct measure_desc *desc, const char *name) {
    const struct stage *stage = desc->stage;
    struct settings chosen = stage ? renderer_settings_chosen(&desc->settings, desc->technique,
                                                              &stage->scene, &stage->geometry)
                                   : desc->settings;
    return settings_number(&chosen, name);
}

double measure_setting(const struct measure_desc *desc, const char *name) {
    struct setting setting;
    if (!desc->technique || !settings_find(&desc->settings, name, &setting))
        return 0;
    for (const struct settings_part *const *p = desc->technique->parts; *p; p++)
        if (*p == setting.part)
            return chosen_number(desc, name);
    return 0;
}

int measure_bounces(const struct measure_desc *desc) {
    double bounces = measure_setting(desc, "bounces");
    return bounces > 1 ? (int)bounces : 1;
}

double measure_pixel_vpls(const struct measure_desc *desc) {
    double slots = measure_setting(desc, "interleave");
    return slots > 0 ? measure_pixels(desc) * measure_setting(desc, "vpls") / (slots * slots) : 0;
}

static bool start(struct renderer *renderer, const struct measure_desc *desc, bool progressive) {
    *renderer = (struct renderer){0};
    return (technique_check(desc->technique, &desc->settings) &&
            renderer_init(renderer, &(struct renderer_desc){.width = desc->width,
                                                            .height = desc->height,
                                                            .technique = desc->technique,
                                                            .direct = desc->direct,
                                                            .settings = desc->settings,
                                                            .scene = &desc->stage->scene,
                                                            .geometry = &desc->stage->geometry,
                                                            .emitters = desc->stage->emitters,
                                                            .camera = desc->stage->camera,
                                                            .progressive = progressive,
                                                            .timed = true})) ||
           blame(desc);
}

bool measure_start(struct renderer *renderer, const struct measure_desc *desc) {
    return start(renderer, desc, false);
}

bool measure_start_mean(struct renderer *renderer, const struct measure_desc *desc) {
    return start(renderer, desc, true);
}
