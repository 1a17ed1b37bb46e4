/* The panel beside the picture. */
#include "viewer/panel/panel.h"

#include "base/memory.h"
#include "shared/composite.h"
#include "viewer/picture/look.h"
#include "viewer/picture/picture.h"
#include "viewer/scene/sessions.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- picture --- */

/* A choice among the picture and the outputs there are. */
static void draw_output_choice(struct viewer *viewer) {
    struct inspect_choice *choice = &viewer->shown.choice;
    struct output_list outputs;
    const char *names[OUTPUTS_MAX + 1] = {"picture"};
    renderer_outputs(&viewer->shown.renderer, &outputs);
    for (int i = 0; i < outputs.count; i++)
        names[i + 1] = outputs.items[i].name;
    const struct output *output = output_find(&outputs, choice->output);
    int shown = output ? (int)(output - outputs.items) + 1 : 0;
    struct ui_row row = {.name = "output",
                         .help = output ? output->help : "what the technique makes",
                         .differs = output};
    enum ui_result result = ui_choice(&row, &shown, names, outputs.count + 1);
    if (result != UI_NOTHING) {
        choice->output = result == UI_RESET || shown == 0 ? NULL : names[shown];
        choice->layer = -1;
        viewer->shown.recompose = true;
    }
}

static void draw_layer_choice(struct viewer *viewer) {
    struct inspect_choice *choice = &viewer->shown.choice;
    int layers = inspect_layers(&viewer->shown.renderer, choice->output);
    struct ui_row row = {.name = "layer",
                         .help = "one alone, or a sheet of all; a click on one shows it",
                         .least = "all",
                         .differs = choice->layer >= 0};
    enum ui_result result = layers > 1 ? ui_int(&row, &choice->layer, -1, layers - 1) : UI_NOTHING;
    if (result != UI_NOTHING) {
        choice->layer = result == UI_RESET ? -1 : choice->layer;
        viewer->shown.recompose = true;
    }
}

/* Unit and scale of light in false colours. */
static void draw_light_scale(struct viewer *viewer) {
    struct inspect_choice *choice = &viewer->shown.choice;
    int unit = (int)choice->unit;
    struct ui_row unit_row = {.name = "unit",
                              .help =
                                  "by the lumens that one watt of the scene stands for: 1 where "
                                  "lights are in candela, as in glTF and IES files",
                              .differs = unit != LIGHT_CANDELA},
                  top_row = {.name = "scale to",
                             .help = "the brightest colour, in the unit; 0: by the picture",
                             .least = "fitted",
                             .differs = choice->top > 0};
    if (!inspect_light(&viewer->shown.inspect, choice))
        return;
    enum ui_result of_unit = ui_choice(&unit_row, &unit, light_unit_names, LIGHT_UNITS);
    choice->unit = of_unit == UI_RESET ? LIGHT_CANDELA : (enum light_unit)unit;
    enum ui_result of_top = ui_float(&top_row, &choice->top, 0, 1e6F);
    choice->top = of_top == UI_RESET ? 0 : choice->top;
    viewer->shown.recompose |= of_unit || of_top;
}

static bool draw_exposure(struct viewer *viewer, struct picture_settings *picture) {
    struct ui_row row = {.name = "exposure, EV",
                         .help = "stops: drag sideways, .02 a pixel, ten times as fast with Shift; "
                                 "two clicks type it; + "
                                 "and -, or Ctrl and the wheel; 0: as the scene began",
                         .differs = picture->exposure != viewer->exposing.usual};
    enum ui_result result = ui_drag(&row, &picture->exposure, -EXPOSURE_MOST, EXPOSURE_MOST, .02F);
    if (result == UI_RESET)
        picture->exposure = viewer->exposing.usual;
    return result != UI_NOTHING;
}

/* It differs from the one that the viewer began with. */
static bool draw_tone_map(struct viewer *viewer, struct picture_settings *picture) {
    const struct picture_settings *usual =
        settings_of(struct picture_settings, &viewer->desc.settings, &picture_part);
    int count = 0;
    const struct option *option = option_find(picture_part.table, "tone-map");
    while (option->choices[count])
        count++;
    struct ui_row row = {
        .name = "tone map", .help = option->help, .differs = picture->tone_map != usual->tone_map};
    enum ui_result result = ui_choice(&row, &picture->tone_map, option->choices, count);
    if (result == UI_RESET)
        picture->tone_map = usual->tone_map;
    return result != UI_NOTHING;
}

/* How the picture is shown: nothing is rendered for that. */
static void draw_tone(struct viewer *viewer) {
    struct settings *settings = &viewer->wish.settings;
    struct picture_settings picture =
        *settings_of(struct picture_settings, settings, &picture_part);
    bool changed = draw_exposure(viewer, &picture);
    changed |= draw_tone_map(viewer, &picture);
    if (!changed)
        return;
    settings_set(settings, &picture_part, &picture);
    viewer_retone(viewer);
}

static void draw_picture(struct viewer *viewer) {
    static const char *const names[] = {"full", "indirect", "direct"};
    static const int layers[] = {LAYER_BEAUTY, LAYER_INDIRECT, LAYER_DIRECT};
    int shown = -1; /* none of them while an output is looked at */
    for (int i = 0; i < 3; i++)
        if (layers[i] == viewer->shown.layer && !viewer->shown.choice.output)
            shown = i;
    if (ui_segments("light", &shown, names, 3))
        viewer_show_layer(viewer, layers[shown]);
    ui_space();
    draw_output_choice(viewer);
    draw_layer_choice(viewer);
    draw_light_scale(viewer);
    draw_tone(viewer);
}

/* --- surface --- */

/* The VALs that bring most; one that is chosen shows its shadow. */
static void draw_vals(struct viewer *viewer, const struct pick *pick) {
    struct inspect_choice *choice = &viewer->shown.choice;
    if (pick->val_count)
        ui_fact(
            "lit most by",
            "groups of virtual lights: each is tested for shadow by one virtual area light, a VAL; "
            "its share of the light here, and how much of it is seen from here",
            "%d groups", pick->val_count);
    for (int i = 0; i < pick->val_count; i++) {
        const struct pick_val *val = &pick->vals[i];
        char name[32], share[32], visible[32];
        unsigned char rgb[3];
        bool chosen = choice->layer == val->val &&
                      inspect_is(&viewer->shown.renderer, choice->output, OUTPUT_VISIBILITY);
        snprintf(name, sizeof name, "group %d", val->val);
        snprintf(share, sizeof share, "%.1f %%", 100 * (double)val->share);
        snprintf(visible, sizeof visible, "visible %.0f %%", 100 * (double)val->visibility);
        marks_cluster_color(val->val, rgb);
        if (ui_list_item(UI_RGBA(rgb[0], rgb[1], rgb[2], 255), name, share, visible, val->share,
                         chosen)) {
            choice->output = inspect_find(&viewer->shown.renderer, OUTPUT_VISIBILITY);
            choice->layer = choice->chosen = val->val;
            viewer->shown.recompose = true;
        }
    }
}

static void draw_surface(struct viewer *viewer) {
    const struct pick *pick = &viewer->shown.pick;
    if (!viewer->shown.has_pick) {
        ui_text(UI_DIM, "Click on the picture.");
        return;
    }
    ui_numbers("position, m", pick->position);
    ui_numbers("normal", pick->normal);
    ui_numbers("albedo", pick->albedo);
    ui_numbers("radiance", pick->radiance);
    ui_numbers("direct, on white", pick->direct);
    ui_numbers("indirect, on white", pick->indirect);
    ui_space();
    draw_vals(viewer, pick);
}

/* --- look closely: how large pixels are, and their values --- */

static void draw_look(struct viewer *viewer) {
    static const char *const zooms[] = {"fit", "1:1"};
    struct look *look = &viewer->look;
    int zoom = look->zoom > 0;
    float percent = (float)(100 * look_zoom(viewer));
    struct ui_row enlarged = {
        .name = "enlarged, %",
        .help =
            "100: a pixel of the picture is one of the window; Ctrl Shift wheel, and Ctrl Shift "
            "drag moves the picture",
        .differs = look->zoom > 0};
    if (!viewer->shown.left)
        return;
    if (ui_segments("zoom", &zoom, zooms, 2))
        look_toggle(viewer);
    enum ui_result result = ui_float(&enlarged, &percent, 10, 100 * LOOK_ZOOM_MOST);
    if (result == UI_RESET)
        look->zoom = 0;
    else if (result == UI_CHANGED)
        look_enlarge(viewer, (double)percent / 100);
    ui_flag(&(struct ui_row){.name = "inspector",
                             .help = "values of the pixel under the mouse (I): linear radiance"},
            &look->inspects);
}

/* --- settings: what is looked at and how, in files and as a command line --- */

static void copy_command(struct viewer *viewer, const struct session *session) {
    char *command = session_command(session);
    window_set_clipboard(viewer->host.window, command);
    messages_add_result(&viewer->host.messages, "Copied: %s", command);
    free(command);
}

static void draw_session(struct viewer *viewer) {
    if (ui_wide_button("Save picture",
                       "PNG as it is shown, with a wipe both pictures; and EXR with "
                       "all layers of the left one; F12"))
        viewer->panel.saves_picture = true;
    struct ui_row row = {.name = "file", .help = "of settings, camera and lights"};
    const char *path = viewer->panel.session_path;
    ui_text_field(&row, viewer->panel.session_path, sizeof viewer->panel.session_path, "path");
    struct session session = viewer_session(viewer);
    if (ui_button("Save", "settings, camera and lights, for Load and --settings; Ctrl S"))
        viewer_save_session(viewer);
    ui_same_line();
    if (ui_button("Load", NULL))
        viewer_load_session(viewer, path);
    ui_same_line();
    if (ui_button("Copy command line", "renders the very same picture offscreen"))
        copy_command(viewer, &session);
    session_free(&session);
}

/* --- all together --- */

void panel_draw(struct viewer *viewer) {
    const struct rectangle *area = &viewer->shown.area;
    const struct {
        const char *title;
        bool open;
        void (*draw)(struct viewer *viewer);
    } sections[] = {
        {"Quality", true, panel_draw_technique}, {"Reference", true, panel_draw_reference},
        {"Picture", true, draw_picture},         {"Compare", false, panel_draw_compare},
        {"Light", false, panel_draw_light},      {"Camera", false, panel_draw_camera},
        {"Look closely", false, draw_look},      {"Surface", false, draw_surface},
        {"Settings", false, draw_session},
    };
    /* A comparison opens its section, however it began. */
    bool compares = viewer->shown.compare.mode != COMPARE_OFF;
    if (compares && !viewer->panel.was_comparing)
        ui_open_section("Compare");
    viewer->panel.was_comparing = compares;
    ui_area_begin("panel", UI_PANEL, (float)area->width, 0,
                  (float)(viewer->host.input->width - area->width),
                  (float)viewer->host.input->height);
    if (ui_section("Scene", true))
        panel_draw_scene(viewer);
    for (size_t i = 0; viewer->has_scene && i < sizeof sections / sizeof *sections; i++)
        if (ui_section(sections[i].title, sections[i].open))
            sections[i].draw(viewer);
    ui_area_end();
}
