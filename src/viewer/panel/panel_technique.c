/* How the picture is made: presets, the few settings that matter to everybody, and all others that
 * have an effect now. A setting that is added to a table is here. */
#include "viewer/panel/panel.h"

#include "direct/environment.h"
#include "scene/caustics.h"
#include "scene/medium.h"
#include "viewer/picture/budget.h"
#include "viewer/picture/picture.h"
#include "viewer/picture/preset.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

enum { TECHNIQUES_MAX = 32, PRESETS_MAX = 8 };

/* --- a row --- */

static int count_names(const char *const *names) {
    int count = 0;
    while (names[count])
        count++;
    return count;
}

static enum ui_result draw_widget(const struct option *option, double *value,
                                  const struct ui_row *row) {
    enum ui_result result;
    if (option->type == OPTION_FLOAT) {
        float real = (float)*value;
        result = ui_float(row, &real, (float)option->minimum, (float)option->maximum);
        *value = (double)real;
        return result;
    }
    int number = (int)*value;
    bool flag = number;
    if (option->type == OPTION_FLAG)
        result = ui_flag(row, &flag);
    else if (option->type == OPTION_CHOICE)
        result = ui_choice(row, &number, option->choices, count_names(option->choices));
    else
        result = ui_int(row, &number, (int)option->minimum, (int)option->maximum);
    *value = option->type == OPTION_FLAG ? flag : number;
    return result;
}

static const char *label_of(const struct option *option) {
    return option->label ? option->label : option->name;
}

static bool draw_setting(const struct setting *setting, struct settings *settings, const char *name,
                         const char *help) {
    struct settings defaults;
    const struct option *option = setting->option;
    char whole[SETTING_NAME_SIZE], explained[1024];
    renderer_settings_init(&defaults);
    setting_name(setting, whole);
    snprintf(explained, sizeof explained, "%s\n(--set %s)", help ? help : option->help, whole);
    struct ui_row row = {.name = name ? name : label_of(option),
                         .help = explained,
                         .scope = setting->part->owner,
                         .differs = !setting_equal(setting, settings, &defaults)};
    double value = setting_number(setting, settings);
    enum ui_result result = draw_widget(option, &value, &row);
    setting_set_number(setting, settings,
                       result == UI_RESET ? setting_number(setting, &defaults) : value);
    return result != UI_NOTHING;
}

/* --- presets --- */

/* Each sets all there is to set. */
static bool draw_presets(const struct technique *technique, struct settings *settings) {
    char titles[PRESETS_MAX][PRESET_TITLE_SIZE], texts[PRESETS_MAX][PRESET_HELP_SIZE];
    const char *names[PRESETS_MAX], *helps[PRESETS_MAX];
    const struct preset *presets = technique->presets;
    int count = 0, chosen = -1;
    for (; presets && count < PRESETS_MAX && presets[count].name; count++) {
        struct settings with = preset_settings(&presets[count], settings);
        preset_title(&presets[count], titles[count]);
        preset_explain(&presets[count], texts[count]);
        names[count] = titles[count];
        helps[count] = texts[count];
        if (renderer_settings_same(&with, settings, technique->parts))
            chosen = count;
    }
    if (count == 0 || !ui_explained_segments("presets", &chosen, names, helps, count))
        return false;
    *settings = preset_settings(&presets[chosen], settings);
    return true;
}

/* --- what matters to everybody --- */

static const struct main_setting {
    const char *setting, *name, *help;
} main_settings[] = {
    {"lights.vpls", "virtual lights",
     "VPLs: points of surfaces that shine on with the light that they reflect. More are smoother, "
     "and take longer. 0: 512 by rays, 1024 by maps."},
    {"clustered.vals", "shadow groups",
     "VALs: groups of virtual lights, each with one shadow map. More make finer indirect shadows, "
     "and take longer. Other numbers than 30 take maps instead of rays."},
    {"map.size", "map texels",
     "a side of each group's shadow map; other numbers than 256 take maps"},
    {"lights.bounces", "light bounces",
     "how often light is reflected on its way: one is half to three quarters of it in a room"},
    {"direct.shadow-size", "shadow texels",
     "a side of the map of each lamp's direct shadow: more are sharper"},
    {"picture.samples", "edge samples",
     "samples of a pixel for antialiasing: 1 leaves edges rough"},
};

static bool is_main(const struct setting *setting) {
    char name[SETTING_NAME_SIZE];
    setting_name(setting, name);
    for (size_t i = 0; i < sizeof main_settings / sizeof *main_settings; i++)
        if (strcmp(main_settings[i].setting, name) == 0)
            return true;
    return false;
}

/* Those that the technique and the direct method have. */
static bool draw_main(const struct technique *technique, const struct direct_method *direct,
                      struct settings *settings) {
    bool changed = false;
    for (size_t i = 0; i < sizeof main_settings / sizeof *main_settings; i++) {
        struct setting setting;
        if (settings_find(settings, main_settings[i].setting, &setting) &&
            (setting.part == &picture_part || settings_parts_have(technique->parts, setting.part) ||
             settings_parts_have(direct->parts, setting.part)))
            changed |=
                draw_setting(&setting, settings, main_settings[i].name, main_settings[i].help);
    }
    return changed;
}

/* --- all others --- */

/* Letters count as small ones. */
static bool has_text(const char *text, const char *part) {
    size_t length = strlen(part);
    for (; text && *text; text++)
        if (strncasecmp(text, part, length) == 0)
            return true;
    return false;
}

static bool is_wanted(const struct setting *setting, const char *filter) {
    const struct option *option = setting->option;
    return *filter == '\0' || has_text(label_of(option), filter) ||
           has_text(option->name, filter) || has_text(option->help, filter) ||
           has_text(setting->part->title, filter);
}

/* The rows that have an effect, under their heading; without any there is none. */
static bool draw_part(const struct settings_part *part, const struct technique *technique,
                      const char *filter, struct settings *settings) {
    bool changed = false, headed = false;
    for (const struct option *option = part->table; option->name; option++) {
        struct setting setting = {part, option};
        if (is_main(&setting) || !setting_matters(&setting, settings, technique) ||
            !is_wanted(&setting, filter))
            continue;
        if (!headed)
            ui_heading(part->title);
        headed = true;
        changed |= draw_setting(&setting, settings, NULL, NULL);
    }
    return changed;
}

static bool draw_parts(const struct settings_part *const *parts, const struct technique *technique,
                       const char *filter, struct settings *settings) {
    bool changed = false;
    for (; *parts; parts++)
        changed |= draw_part(*parts, technique, filter, settings);
    return changed;
}

static bool draw_advanced(struct viewer *viewer, const struct technique *technique,
                          struct settings *settings) {
    char *filter = viewer->panel.filter;
    struct ui_row row = {
        .name = "find", .help = "shows the settings alone whose name, group or explanation has it"};
    ui_text_field(&row, filter, sizeof viewer->panel.filter, "shadow, blur, seed ...");
    bool changed = draw_parts(technique->parts, technique, filter, settings);
    changed |= draw_parts(viewer->shown.renderer.desc.direct->parts, technique, filter, settings);
    if (viewer->placed.emitters.sky)
        changed |= draw_part(&sky_part, technique, filter, settings);
    changed |= draw_part(&medium_part, technique, filter, settings);
    changed |= draw_part(&caustics_part, technique, filter, settings);
    return changed;
}

/* --- all together --- */

static bool draw_technique_choice(const struct technique **technique) {
    const char *names[TECHNIQUES_MAX];
    int count = 0, chosen = 0;
    for (; count < TECHNIQUES_MAX && techniques[count]; count++) {
        names[count] = techniques[count]->name;
        chosen = techniques[count] == *technique ? count : chosen;
    }
    struct ui_row row = {.name = "technique", .help = (*technique)->help};
    if (ui_choice(&row, &chosen, names, count) == UI_NOTHING)
        return false;
    *technique = techniques[chosen];
    return true;
}

/* By the lights' sizes first. */
static bool draw_direct_choice(struct viewer *viewer) {
    const char *names[TECHNIQUES_MAX] = {"by the lights"};
    const struct direct_method *now = viewer->wish.direct;
    int count = 1, chosen = 0;
    for (; direct_methods[count - 1] && count < TECHNIQUES_MAX; count++) {
        names[count] = direct_methods[count - 1]->name;
        chosen = direct_methods[count - 1] == now ? count : chosen;
    }
    struct ui_row row = {
        .name = "direct light",
        .help = now ? now->help : "hard shadows, or soft ones where a light has a size (--direct)",
        .differs = now};
    enum ui_result result = ui_choice(&row, &chosen, names, count);
    if (result != UI_NOTHING)
        viewer->wish.direct = result == UI_RESET || chosen == 0 ? NULL : direct_methods[chosen - 1];
    return result != UI_NOTHING;
}

/* A picture at rest goes on to their mean. */
static void draw_passes(struct viewer *viewer) {
    int passes = viewer_passes(viewer);
    struct ui_row row = {.name = "passes at rest",
                         .help = "at rest the picture becomes the mean of so many, each with other "
                                 "virtual lights: truer, and as many times as dear (--passes; 64: "
                                 "--quality final)",
                         .differs = viewer->wish.passes > 0};
    enum ui_result result = ui_int(&row, &passes, 1, PASSES_AT_REST);
    if (result == UI_NOTHING)
        return;
    viewer->wish.passes = result == UI_RESET ? 0 : passes;
    viewer_touch(viewer);
}

/* What a frame may take, and what has been chosen by it. */
static void draw_budget(struct viewer *viewer) {
    const struct time_budget *budget = &viewer->shown.budget;
    float ms = viewer->wish.budget;
    struct ui_row row = {
        .name = "budget, ms",
        .help = "what a frame may take: the settings here then follow from how long frames take "
                "(--budget)",
        .differs = ms > 0,
        .least = "none"};
    enum ui_result result = ui_float(&row, &ms, 0, 1000);
    if (result != UI_NOTHING) {
        viewer_set_budget(viewer, result == UI_RESET ? 0 : ms);
        viewer_touch(viewer);
    }
    if (viewer->wish.budget > 0)
        ui_text(UI_DIM, "level %d of %d, by the time of frames", budget->level,
                TIME_BUDGET_LEVELS - 1);
}

void panel_draw_technique(struct viewer *viewer) {
    struct compare *compare = &viewer->shown.compare;
    bool two = compare->mode == COMPARE_TECHNIQUE;
    static const char *const sides[] = {"left picture", "right picture"};
    int side = two && viewer->panel.edits_right;
    if (two && ui_segments("side", &side, sides, 2))
        viewer->panel.edits_right = side == 1;
    const struct technique **technique = side ? &compare->technique : &viewer->wish.technique;
    struct settings *settings = side ? &compare->settings : &viewer->wish.settings;
    bool changed = draw_presets(*technique, settings);
    ui_space();
    changed |= draw_technique_choice(technique);
    changed |= draw_main(*technique, viewer->shown.renderer.desc.direct, settings);
    if (side == 0) {
        changed |= draw_direct_choice(viewer);
        draw_passes(viewer);
        draw_budget(viewer);
    }
    if (ui_section("Advanced", false))
        changed |= draw_advanced(viewer, *technique, settings);
    if (changed && side == 0)
        viewer_set_budget(viewer, 0); /* what is set by hand wins */
    if (changed)
        viewer_touch(viewer);
}
