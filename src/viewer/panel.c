/* The panel beside the picture. Settings come from the option table: a setting that is added there
 * is here. */
#include "viewer/viewer.h"

#include "base/error.h"
#include "scene/animation.h"
#include "scene/node.h"
#include "shared/composite.h"
#include "viewer/window/ui.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NAMES_MAX = 64 };

static int count_names(const char *const *names) {
    int count = 0;
    while (names[count])
        count++;
    return count;
}

/* --- scene --- */

/* A choice among nodes of the scene, by name. */
static bool draw_node_choice(const struct ui_row *row, const struct scene *scene,
                             enum node_kind kind, int *chosen) {
    const char *names[NAMES_MAX];
    int count = node_count_carrying(scene, kind);
    count = count < NAMES_MAX ? count : NAMES_MAX;
    for (int i = 0; i < count; i++) {
        const char *name = scene->nodes[node_carrying(scene, kind, i)].name;
        names[i] = *name ? name : "without a name";
    }
    enum ui_result result = ui_choice(row, chosen, names, count);
    if (result == UI_RESET)
        *chosen = *chosen < count ? *chosen : 0;
    return result != UI_NOTHING;
}

/* Clips are few, and told apart by their names. */
static void draw_clip(struct viewer *viewer) {
    enum { NAMES_MAX = 64 };
    const struct scene *scene = &viewer->document.scene;
    const char *names[NAMES_MAX];
    int clip = scene->clip, count = scene->clip_count < NAMES_MAX ? scene->clip_count : NAMES_MAX;
    for (int i = 0; i < count; i++)
        names[i] = *scene->clips[i].name ? scene->clips[i].name : "without a name";
    struct ui_row row = {.name = "clip", .help = "animation of the scene"};
    if (count > 0 && ui_choice(&row, &clip, names, count) && clip != scene->clip)
        viewer_pick_clip(viewer, clip);
}

static void draw_animation(struct viewer *viewer) {
    struct playing *play = &viewer->wish.play;
    double duration = scene_duration(&viewer->document.scene);
    draw_clip(viewer);
    if (duration <= 0)
        return;
    struct ui_row speed_row = {.name = "speed",
                               .help = "seconds of the animation a second",
                               .differs = play->speed != 1},
                  loop_row = {.name = "loop", .help = "begin again at the end"};
    if (ui_float(&speed_row, &play->speed, .05F, 4) == UI_RESET)
        play->speed = 1;
    ui_flag(&loop_row, &play->loops);
}

static void draw_scene(struct viewer *viewer) {
    struct ui_row open = {.name = "open",
                          .help = "a .gltf or .glb file; one may also be dropped on the window"};
    if (ui_text_field(&open, viewer->panel.scene_path, sizeof viewer->panel.scene_path,
                      "path, Enter"))
        viewer_open(viewer, viewer->panel.scene_path);
    if (!viewer->has_scene)
        return;
    const struct scene *scene = &viewer->document.scene;
    int camera = viewer->placed.camera_number;
    struct ui_row row = {.name = "camera",
                         .help = "of the scene; R goes back to it",
                         .differs = viewer->placed.camera_moved};
    if (draw_node_choice(&row, scene, NODE_CAMERA, &camera))
        viewer_pick_camera(viewer, camera);
    draw_animation(viewer);
}

/* --- picture --- */

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
static bool draw_setting(const struct setting *setting, struct settings *settings) {
    struct settings defaults;
    const struct option *option = setting->option;
    renderer_settings_init(&defaults);
    struct ui_row row = {.name = option->name,
                         .help = option->help,
                         .differs = !setting_equal(setting, settings, &defaults)};
    char *values = settings_edit(settings, setting->part), text[64];
    enum ui_result result = draw_widget(option, values + option->offset, &row);
    if (result == UI_RESET) {
        setting_format(setting, &defaults, text, sizeof text);
        setting_parse(setting, settings, text);
    }
    return result != UI_NOTHING;
}

static bool draw_part(const struct settings_part *part, struct settings *settings) {
    bool changed = false;
    for (const struct option *option = part->table; option->name; option++)
        changed |= draw_setting(&(struct setting){part, option}, settings);
    return changed;
}

static bool draw_parts(const struct settings_part *const *parts, struct settings *settings) {
    bool changed = false;
    for (; *parts; parts++) {
        ui_heading((*parts)->title);
        changed |= draw_part(*parts, settings);
    }
    return changed;
}

/* Buttons: a preset sets several at once. */
static bool draw_presets(const struct technique *technique, struct settings *settings) {
    bool changed = false;
    for (const struct preset *p = technique->presets; p && p->name; p++) {
        if (p != technique->presets)
            ui_same_line();
        if (ui_button(p->name, p->help)) {
            renderer_settings_init(settings);
            settings_assign(settings, p->settings);
            changed = true;
        }
    }
    return changed;
}

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

/* Of all exposures there are, the slider has those of use. */
static bool draw_exposure(struct picture_settings *picture) {
    struct ui_row row = {.name = "exposure",
                         .help = "stops (EV); + and -, or Ctrl and the wheel; 0 resets",
                         .differs = picture->exposure != 0};
    enum ui_result result = ui_float(&row, &picture->exposure, -8, 8);
    if (result == UI_RESET)
        picture->exposure = 0;
    return result != UI_NOTHING;
}

/* How the picture is shown; only its samples have it rendered again. */
static void draw_tone(struct viewer *viewer) {
    struct settings *settings = &viewer->wish.settings;
    struct picture_settings *picture = settings_edit(settings, &picture_part), before = *picture;
    bool changed = draw_exposure(picture);
    for (const struct option *option = picture_part.table; option->name; option++)
        if (option->offset != offsetof(struct picture_settings, exposure))
            changed |= draw_setting(&(struct setting){&picture_part, option}, settings);
    if (changed)
        viewer_retone(viewer);
    viewer->shown.dirty |= picture->samples != before.samples;
}

static void draw_picture(struct viewer *viewer) {
    static const char *const names[] = {"full", "indirect", "direct"};
    static const int layers[] = {LAYER_BEAUTY, LAYER_INDIRECT, LAYER_DIRECT};
    int shown = -1; /* none of them while an output is looked at */
    for (int i = 0; i < 3; i++)
        if (layers[i] == viewer->shown.layer && !viewer->shown.choice.output)
            shown = i;
    if (ui_segments("light", &shown, names, 3)) {
        viewer->shown.layer = layers[shown];
        viewer->shown.choice.output = NULL;
        viewer->shown.compare.measured = false;
        viewer->shown.recompose = true;
    }
    ui_space();
    draw_output_choice(viewer);
    draw_layer_choice(viewer);
    draw_tone(viewer);
}

/* --- technique --- */

static bool draw_technique_choice(const struct technique **technique) {
    const char *names[NAMES_MAX];
    int count = 0, chosen = 0;
    for (; techniques[count] && count < NAMES_MAX; count++) {
        names[count] = techniques[count]->name;
        chosen = techniques[count] == *technique ? count : chosen;
    }
    struct ui_row row = {.name = "technique", .help = (*technique)->help};
    if (ui_choice(&row, &chosen, names, count) == UI_NOTHING)
        return false;
    *technique = techniques[chosen];
    return true;
}

static void draw_technique(struct viewer *viewer) {
    struct compare *compare = &viewer->shown.compare;
    bool two = compare->mode == COMPARE_TECHNIQUE;
    static const char *const sides[] = {"left picture", "right picture"};
    int side = two && viewer->panel.edits_right;
    if (two && ui_segments("side", &side, sides, 2))
        viewer->panel.edits_right = side == 1;
    const struct technique **technique = side ? &compare->technique : &viewer->wish.technique;
    struct settings *settings = side ? &compare->settings : &viewer->wish.settings;
    bool changed = draw_technique_choice(technique);
    changed |= draw_presets(*technique, settings);
    ui_space();
    changed |= draw_parts((*technique)->parts, settings);
    changed |= draw_parts(viewer->shown.renderer.desc.direct->parts, settings);
    if (changed)
        viewer_touch(viewer);
}

/* --- comparison --- */

static void draw_errors(struct viewer *viewer) {
    struct compare *compare = &viewer->shown.compare;
    const char *names[METRIC_COUNT];
    ui_space();
    for (int i = 0; i < METRIC_COUNT; i++) {
        names[i] = metrics[i].name;
        if (compare->measured && compare->is_known[i])
            ui_value(metrics[i].name, "%.5g", compare->values[i]);
        else
            ui_value(metrics[i].name, "-");
    }
    ui_space();
    struct ui_row heat = {.name = "heat map", .help = "errors in place of the left picture"},
                  metric = {.name = "of", .help = metrics[compare->heat_metric].help};
    enum ui_result result = ui_flag(&heat, &compare->heat);
    if (compare->heat && ui_choice(&metric, &compare->heat_metric, names, METRIC_COUNT))
        result = UI_CHANGED;
    if (result)
        compare->measured = false;
    if (ui_wide_button("Measure FLIP too", "looks at neighbourhoods, and takes its time"))
        viewer_measure_all(viewer);
}

static void draw_compare(struct viewer *viewer) {
    static const char *const modes[] = {"off", "technique", "reference"};
    struct compare *compare = &viewer->shown.compare;
    int mode = compare->mode;
    if (ui_segments("compare", &mode, modes, COMPARE_MODES)) {
        compare->mode = (enum compare_mode)mode;
        viewer->panel.edits_right = mode == COMPARE_TECHNIQUE;
        viewer->shown.dirty = true;
    }
    if (mode == COMPARE_REFERENCE) {
        struct ui_row row = {.name = "file", .help = "EXR, PFM, ... of the same view"};
        if (ui_text_field(&row, viewer->panel.reference_path, sizeof viewer->panel.reference_path,
                          "path, Enter"))
            viewer_load_reference(viewer, viewer->panel.reference_path);
    }
    if (viewer->shown.fixed_width > 0 &&
        ui_wide_button("Fill the window again", "the picture has the reference's size now")) {
        viewer->shown.fixed_width = viewer->shown.fixed_height = 0;
        viewer->shown.dirty = true;
    }
    if (viewer->shown.right) {
        if (ui_flag(&(struct ui_row){.name = "right alone", .help = "M"}, &compare->only_right))
            viewer->shown.recompose = true;
        draw_errors(viewer);
    }
}

/* --- surface --- */

/* The VALs that bring most; one that is chosen shows its shadow. */
static void draw_vals(struct viewer *viewer, const struct pick *pick) {
    struct inspect_choice *choice = &viewer->shown.choice;
    if (pick->val_count)
        ui_text(UI_DIM, "lit by");
    for (int i = 0; i < pick->val_count; i++) {
        const struct pick_val *val = &pick->vals[i];
        char name[32], share[32], visible[32];
        unsigned char rgb[3];
        bool chosen = choice->layer == val->val &&
                      inspect_is(&viewer->shown.renderer, choice->output, OUTPUT_VISIBILITY);
        snprintf(name, sizeof name, "VAL %d", val->val);
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
    ui_numbers("position", pick->position);
    ui_numbers("normal", pick->normal);
    ui_numbers("albedo", pick->albedo);
    ui_numbers("radiance", pick->radiance);
    ui_numbers("direct, on white", pick->direct);
    ui_numbers("indirect, on white", pick->indirect);
    ui_space();
    draw_vals(viewer, pick);
}

/* --- session --- */

static void draw_session(struct viewer *viewer) {
    struct ui_row row = {.name = "file", .help = "of settings, camera and lights"};
    ui_text_field(&row, viewer->panel.session_path, sizeof viewer->panel.session_path, "path");
    struct session session = viewer_session(viewer);
    if (ui_button("Save", NULL)) {
        if (session_save(&session, viewer->panel.session_path))
            messages_add(&viewer->host.messages, UI_NORMAL, "saved: %s",
                         viewer->panel.session_path);
        else
            viewer_tell_error(viewer);
    }
    ui_same_line();
    if (ui_button("Load", NULL))
        viewer_load_session(viewer, viewer->panel.session_path);
    ui_same_line();
    if (ui_button("Copy command line", "renders the very same picture offscreen")) {
        char *command = session_command(&session);
        window_set_clipboard(viewer->host.window, command);
        messages_add(&viewer->host.messages, UI_NORMAL, "%s", command);
        free(command);
    }
    session_free(&session);
}

void panel_draw(struct viewer *viewer) {
    const struct rectangle *area = &viewer->shown.area;
    const struct {
        const char *title;
        bool open;
        void (*draw)(struct viewer *viewer);
    } sections[] = {
        {"Picture", true, draw_picture},      {"Light", false, light_panel_draw},
        {"Camera", false, camera_panel_draw}, {"Look closely", false, look_panel_draw},
        {"Compare", false, draw_compare},     {"Surface", true, draw_surface},
        {"Settings", false, draw_session},    {"Technique", true, draw_technique},
    };
    ui_area_begin("panel", UI_PANEL, (float)area->width, 0,
                  (float)(viewer->host.input->width - area->width),
                  (float)viewer->host.input->height);
    if (ui_section("Scene", true))
        draw_scene(viewer);
    for (size_t i = 0; viewer->has_scene && i < sizeof sections / sizeof *sections; i++)
        if (ui_section(sections[i].title, sections[i].open))
            sections[i].draw(viewer);
    ui_area_end();
}
