/* The panel beside the picture. Settings come from the option table: a setting that is added there
 * is here. */
#include "viewer/viewer.h"

#include "base/error.h"
#include "shared/params.h"
#include "viewer/ui.h"

#include <stdio.h>
#include <string.h>

static int count_names(const char *const *names) {
    int count = 0;
    while (names[count])
        count++;
    return count;
}

/* --- settings --- */

static enum ui_result draw_widget(const struct option *option, void *at, const struct ui_row *row) {
    switch (option->type) {
    case OPTION_FLAG:
        return ui_flag(row, at);
    case OPTION_INT:
        return ui_int(row, at, (int)option->minimum, (int)option->maximum);
    case OPTION_FLOAT:
        return ui_float(row, at, (float)option->minimum, (float)option->maximum);
    case OPTION_CHOICE:
        return ui_choice(row, at, option->choices, count_names(option->choices));
    case OPTION_TEXT:
    case OPTION_LIST:
    case OPTION_SIZE:
        break;
    }
    return UI_NOTHING;
}

/* Whether the user changed it. */
static bool draw_setting(const struct option *option, struct settings *settings) {
    struct settings defaults;
    options_set_defaults(settings_table, &defaults);
    struct ui_row row = {.name = option->name,
                         .help = option->help,
                         .differs = !option_equal(option, settings, &defaults)};
    enum ui_result result = draw_widget(option, (char *)settings + option->offset, &row);
    char text[64];
    if (result == UI_RESET) {
        option_format(option, &defaults, text, sizeof text);
        option_parse(option, settings, text);
    }
    return result != UI_NOTHING;
}

static void draw_settings(struct viewer *viewer, bool of_picture) {
    for (const struct option *option = settings_table; option->name; option++)
        if (option->reinit != of_picture && draw_setting(option, &viewer->settings))
            viewer_touch(viewer);
}

/* --- sections --- */

static void draw_scene(struct viewer *viewer) {
    static char path[512];
    if (ui_text_field(
            &(struct ui_row){.name = "open",
                             .help = "a .gltf or .glb file; one may also be dropped on the window"},
            path, sizeof path, "path of a glTF file"))
        viewer_open(viewer, path);
    if (!viewer->has_scene)
        return;
    ui_value("faces", "%u", viewer->document.geometry.index_count / 3);
}

/* Those that the technique has. */
static void draw_buffer(struct viewer *viewer) {
    struct inspect_choice *choice = &viewer->choice;
    const char *names[SHOW_COUNT];
    int kinds[SHOW_COUNT], count = 0, shown = 0;
    for (int kind = 0; kind < SHOW_COUNT; kind++)
        if (inspect_layers(&viewer->renderer, (enum inspect_kind)kind) > 0) {
            if (kind == (int)choice->kind)
                shown = count;
            kinds[count] = kind;
            names[count++] = inspect_rows[kind].name;
        }
    struct ui_row row = {
        .name = "buffer", .help = inspect_rows[choice->kind].help, .differs = shown > 0};
    enum ui_result result = ui_choice(&row, &shown, names, count);
    if (result != UI_NOTHING) {
        choice->kind = result == UI_RESET ? SHOW_PICTURE : (enum inspect_kind)kinds[shown];
        choice->layer = -1;
        viewer->recompose = true;
    }
    int layers = inspect_layers(&viewer->renderer, choice->kind);
    struct ui_row layer = {.name = "layer",
                           .help = "-1 = a sheet of all; a click on one shows it alone",
                           .differs = choice->layer >= 0};
    if (layers > 1 && (result = ui_int(&layer, &choice->layer, -1, layers - 1)) != UI_NOTHING) {
        choice->layer = result == UI_RESET ? -1 : choice->layer;
        viewer->recompose = true;
    }
}

static void draw_picture(struct viewer *viewer) {
    static const char *const names[] = {"full", "indirect", "direct"};
    static const int layers[] = {LAYER_BEAUTY, LAYER_INDIRECT, LAYER_DIRECT};
    int shown = 0;
    for (int i = 0; i < 3; i++)
        if (layers[i] == viewer->layer)
            shown = i;
    if (ui_segments("light", &shown, names, 3)) {
        viewer->layer = layers[shown];
        viewer->choice.kind = SHOW_PICTURE;
        viewer->recompose = true;
    }
    ui_space();
    draw_buffer(viewer);
    draw_settings(viewer, true);
}

static void draw_technique(struct viewer *viewer) {
    struct ui_row row = {.name = "technique", .help = techniques[viewer->technique]->help};
    if (ui_choice(&row, &viewer->technique, technique_names, count_names(technique_names)))
        viewer_touch(viewer);
    ui_space();
    draw_settings(viewer, false);
}

void panel_draw(struct viewer *viewer) {
    const struct rectangle *area = &viewer->area;
    ui_area_begin("panel", UI_PANEL, (float)area->width, 0,
                  (float)(viewer->input->width - area->width), (float)viewer->input->height);
    ui_text(UI_TITLE, "manylight");
    if (ui_section("Scene", true))
        draw_scene(viewer);
    if (viewer->has_scene && ui_section("Picture", true))
        draw_picture(viewer);
    if (ui_section("Technique", true))
        draw_technique(viewer);
    ui_area_end();
}
