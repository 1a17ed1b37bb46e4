#include "viewer/panel/panel.h"

#include "shared/composite.h"
#include "viewer/files/opening.h"
#include "viewer/files/screenshot.h"
#include "viewer/files/start.h"
#include "viewer/picture/look.h"
#include "viewer/picture/picture.h"
#include "viewer/reference/comparing.h"
#include "viewer/scene/animation.h"
#include "viewer/scene/camera_hand.h"
#include "viewer/scene/exposure.h"
#include "viewer/scene/lights.h"
#include "viewer/scene/placed.h"
#include "viewer/scene/sessions.h"
#include "viewer/window/ui.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* --- keys --- */

static void key_home(struct viewer *viewer) {
    if (viewer->has_scene)
        viewer_pick_camera(viewer, viewer->placed.camera_number);
}
static void key_wipe(struct viewer *viewer) {
    struct compare *compare = &viewer->shown.compare;
    compare->mode = (enum compare_mode)((compare->mode + 1) % COMPARE_MODES);
    if (compare->mode == COMPARE_REFERENCE && !compare->reference.framebuffer)
        compare->mode = COMPARE_OFF;
    if (compare->mode == COMPARE_REFERENCE)
        viewer_compare_reference(viewer);
    viewer->shown.dirty = true;
}
static void key_overlay(struct viewer *viewer) {
    viewer->panel.overlay = (enum overlay_kind)((viewer->panel.overlay + 1) % OVERLAY_KINDS);
}
static void key_full_screen(struct viewer *viewer) {
    window_toggle_full_screen(viewer->host.window);
}
/* Steps back out of what is open; only twice in a row does it end the program. */
static void key_escape(struct viewer *viewer) {
    double now = window_time();
    if (ui_close_popup())
        return;
    if (viewer_is_opening(viewer)) {
        viewer_stop_opening(viewer);
    } else if (viewer->panel.help) {
        viewer->panel.help = false;
    } else if (window_is_full_screen(viewer->host.window)) {
        window_toggle_full_screen(viewer->host.window);
    } else if (now - viewer->hand.last_escape < 2) {
        viewer->done = true;
    } else {
        viewer->hand.last_escape = now;
        messages_add(&viewer->host.messages, UI_NORMAL, "Esc once more quits.");
    }
}
static void key_screenshot(struct viewer *viewer) {
    if (!viewer_take_screenshot(viewer))
        viewer_close_scene(viewer);
}
static void key_quit(struct viewer *viewer) {
    viewer->done = true;
}

static void scale_widgets(struct viewer *viewer, int by) {
    float scale = viewer->host.input->scale * powf(1.125F, (float)by);
    window_set_scale(viewer->host.window, fminf(fmaxf(scale, .5F), 4));
}
static void expose(struct viewer *viewer, int by) {
    viewer_expose(viewer, .5F * (float)by);
}
static void key_usual_scale(struct viewer *viewer) {
    window_set_scale(viewer->host.window, viewer->desc.scale);
}

/* The help's two columns are about as long where the second begins there. */
static const char second_column[] = "Window and files";

#define TOGGLES(member) .toggles = offsetof(struct viewer, member)

static const struct key {
    int key;
    const char *name, *help; /* NULL: the row before tells it; KEY_NONE: a heading */
    void (*run)(struct viewer *viewer);
    void (*step)(struct viewer *viewer, int by);
    int by;
    size_t toggles; /* a bool of struct viewer */
} keys[] = {
    {KEY_NONE, .name = "Picture"},
    {'1', "1", "all light", .step = viewer_show_layer, .by = LAYER_BEAUTY},
    {'2', "2", "indirect light alone", .step = viewer_show_layer, .by = LAYER_INDIRECT},
    {'3', "3", "direct light alone", .step = viewer_show_layer, .by = LAYER_DIRECT},
    {KEY_LEFT_BRACKET, "[", "previous output of the technique", .step = viewer_step_output,
     .by = -1},
    {KEY_RIGHT_BRACKET, "]", "next output", .step = viewer_step_output, .by = 1},
    {'=', "+", "brighter by half a stop; so does Ctrl wheel", .step = expose, .by = 1},
    {'-', "-", "darker", .step = expose, .by = -1},
    {'0', "0", "the exposure that the scene began with", .run = viewer_reset_exposure},
    {'Z', "Z", "1:1, or as large as fits", .run = look_toggle},
    {'I', "I", "inspector: the pixel under the mouse", TOGGLES(look.inspects)},
    {KEY_NONE, .name = "Compare"},
    {'C', "C", "a technique, the reference, off", .run = key_wipe},
    {'M', "M", "right picture alone, or the wipe", TOGGLES(shown.compare.only_right)},
    {'V', "V", "wipe, side by side, difference", .run = look_step_layout},
    {KEY_NONE, .name = "Camera and light"},
    {'F', "F", "frame what is under the mouse, or all", .run = camera_hand_frame},
    {'R', "R", "back to the scene's camera", .run = key_home},
    {'L', "L", "handles to move, turn and size lights", TOGGLES(hand.light_tool.shown)},
    {KEY_NONE, .name = "Animation"},
    {KEY_SPACE, "Space", "play and pause the animation", .run = viewer_toggle_play},
    {',', ", .", "a frame back, a frame on", .step = timeline_step, .by = -1},
    {'.', .step = timeline_step, .by = 1},
    {KEY_NONE, .name = second_column},
    {KEY_F1, "F1", "this help", TOGGLES(panel.help)},
    {KEY_F2, "F2", "panel", TOGGLES(panel.is_open)},
    {KEY_F3, "F3", "times: a line, a table, none", .run = key_overlay},
    {KEY_F5, "F5", "read the scene again; a changed file is read without it", .run = viewer_reload},
    {KEY_F5 + KEY_WITH_CONTROL, "Ctrl F5", "read the shaders again (--glsl)",
     .run = viewer_reload_shaders},
    {KEY_F11, "F11", "full screen", .run = key_full_screen},
    {KEY_F12, "F12", "save the picture: PNG as shown, EXR with all layers", .run = key_screenshot},
    {KEY_ESCAPE, "Esc", "close what is open; twice: quit", .run = key_escape},
    {'O' + KEY_WITH_CONTROL, "Ctrl O", "open a file", .run = viewer_ask_file},
    {'S' + KEY_WITH_CONTROL, "Ctrl S", "save settings, camera and lights",
     .run = viewer_save_session},
    {'Z' + KEY_WITH_CONTROL, "Ctrl Z", "undo: camera, light or settings", .step = viewer_undo,
     .by = -1},
    {'Z' + KEY_WITH_CONTROL + KEY_WITH_SHIFT, "Ctrl Shift Z", "redo", .step = viewer_undo, .by = 1},
    {'Y' + KEY_WITH_CONTROL, "Ctrl Y", "redo", .step = viewer_undo, .by = 1},
    {'=' + KEY_WITH_CONTROL, "Ctrl + - 0", "larger and smaller text and widgets, as at first",
     .step = scale_widgets, .by = 1},
    {'=' + KEY_WITH_CONTROL + KEY_WITH_SHIFT, .step = scale_widgets, .by = 1},
    {'-' + KEY_WITH_CONTROL, .step = scale_widgets, .by = -1},
    {'0' + KEY_WITH_CONTROL, .run = key_usual_scale},
    {'Q' + KEY_WITH_CONTROL, "Ctrl Q", "quit", .run = key_quit},
};

enum { KEY_ROWS = sizeof keys / sizeof *keys };

static const struct {
    const char *name, *help;
} gestures[] = {
    {"left drag", "orbit about the point under the mouse"},
    {"middle drag", "pan; so does Shift left drag"},
    {"right drag", "look around"},
    {"wheel", "zoom towards the mouse; with Shift: field of view"},
    {"Ctrl Shift wheel", "enlarge the picture; so does Alt wheel"},
    {"Ctrl Shift drag", "move the enlarged picture; so does Alt drag"},
    {"W A S D Q E", "fly; then Shift fast, Ctrl slow; the wheel sets the speed"},
    {"Ctrl 1 to 9", "keep a view; Alt and the number goes there"},
    {"click", "a surface, and the shadow groups (VALs) that light it"},
    {"click on a cluster", "that group's shadow; on a sheet: that layer alone"},
    {"drop a file", "a scene, its sky (.hdr), settings, a reference (.exr);"},
    {"", "an .exr twice as wide as high, without layers, is a sky"},
    {"Tab", "the panel by keyboard: Tab and arrows go on, Space"},
    {"", "presses, Enter types a number, Esc leaves"},
};

/* Ctrl and a number keep a view, Alt and the number goes there. */
static void use_views(struct viewer *viewer, int key) {
    int number = (key & 0xff) - '1', with = key & ~0xff;
    if (number < 0 || number >= SESSION_VIEWS)
        return;
    if (with == KEY_WITH_CONTROL)
        views_keep(viewer, number);
    if (with == KEY_WITH_ALT)
        views_go(viewer, number);
}

static void run(struct viewer *viewer, const struct key *key) {
    if (key->run)
        key->run(viewer);
    else if (key->step)
        key->step(viewer, key->by);
    else {
        bool *value = (bool *)((char *)viewer + key->toggles);
        *value = !*value;
    }
}

static void run_keys(struct viewer *viewer) {
    for (int i = 0; i < viewer->host.input->key_count; i++)
        use_views(viewer, viewer->host.input->keys[i]);
    for (int i = 0; i < viewer->host.input->key_count; i++)
        for (int k = 0; k < KEY_ROWS; k++)
            if (keys[k].key == viewer->host.input->keys[i])
                run(viewer, &keys[k]);
}

void controls_draw_help(void) {
    ui_columns_begin("keys");
    for (int i = 0; i < KEY_ROWS; i++) {
        if (keys[i].name && strcmp(keys[i].name, second_column) == 0)
            ui_columns_next();
        if (keys[i].key == KEY_NONE)
            ui_heading(keys[i].name);
        else if (keys[i].name)
            ui_definition(keys[i].name, keys[i].help);
    }
    ui_heading("Mouse, flying and the panel");
    for (size_t i = 0; i < sizeof gestures / sizeof *gestures; i++)
        ui_definition(gestures[i].name, gestures[i].help);
    ui_columns_end();
}

/* --- what lies on the picture: the light's handles, the wipe --- */

static struct light_stage light_stage(const struct viewer *viewer) {
    return (struct light_stage){&viewer->placed.orbit.camera, &viewer->document.geometry,
                                &viewer->shown.picture, viewer->host.input->scale};
}

static bool drag_light(struct viewer *viewer) {
    struct light_stage stage = light_stage(viewer);
    bool moved;
    if (!viewer_has_light(viewer))
        return false;
    bool held = light_tool_update(&viewer->hand.light_tool, &stage, viewer->host.input,
                                  &viewer->placed.emitters, &viewer->placed.chosen_light, &moved);
    if (moved)
        viewer_touch_light(viewer);
    return held;
}

static bool is_near_split(const struct viewer *viewer, double x) {
    const struct compare *compare = &viewer->shown.compare;
    const struct rectangle *picture = &viewer->shown.picture;
    double reach = 7 * (double)viewer->host.input->scale;
    double line = picture->x + (double)compare->split * picture->width;
    return viewer->shown.right && !compare->only_right && viewer->look.layout == SCREEN_WIPE &&
           fabs(x - line) < reach;
}

static bool drag_split(struct viewer *viewer) {
    const struct input *input = viewer->host.input;
    const struct rectangle *picture = &viewer->shown.picture;
    double x = (input->x - picture->x) / picture->width;
    if (input->pressed[BUTTON_LEFT] && is_near_split(viewer, input->press_x))
        viewer->hand.drags_split = true;
    if (!input->held[BUTTON_LEFT])
        viewer->hand.drags_split = false;
    if (viewer->hand.drags_split)
        viewer->shown.compare.split = (float)fmin(fmax(x, 0), 1);
    return viewer->hand.drags_split;
}

/* The mouse tells what it can hold. */
static void show_cursor(const struct viewer *viewer) {
    const struct input *input = viewer->host.input;
    struct light_stage stage = light_stage(viewer);
    if (ui_wants_mouse() && !viewer->hand.drags_split)
        return;
    if (viewer_has_light(viewer) &&
        light_tool_is_under(&viewer->hand.light_tool, &stage, input, &viewer->placed.emitters,
                            viewer->placed.chosen_light))
        ui_show_cursor(UI_CURSOR_HAND);
    else if (viewer->hand.drags_split || is_near_split(viewer, input->x))
        ui_show_cursor(UI_CURSOR_SIDEWAYS);
}

/* --- clicks --- */

/* A click on a sheet shows that layer alone, the next one the sheet again. */
static void click_layer(struct viewer *viewer, float x, float y) {
    struct inspect_choice *choice = &viewer->shown.choice;
    choice->layer =
        choice->layer < 0 ? inspect_sheet_layer(&viewer->shown.renderer, choice, x, y) : -1;
    viewer->shown.recompose = true;
}

static void click_cluster(struct viewer *viewer, float x, float y) {
    int val = probe_nearest_val(&viewer->shown.renderer, x, y);
    if (val < 0)
        return;
    viewer->shown.choice.output = inspect_find(&viewer->shown.renderer, OUTPUT_VISIBILITY);
    viewer->shown.choice.layer = viewer->shown.choice.chosen = val;
    viewer->shown.recompose = true;
}

/* Nothing scrolls: the next click in the panel finds what it aims at. */
static void click_surface(struct viewer *viewer, float x, float y) {
    viewer_pick_surface(viewer, x, y);
    if (viewer->shown.has_pick)
        ui_open_section("Surface");
}

static void click(struct viewer *viewer) {
    const char *output = viewer->shown.choice.output;
    float x, y;
    if (!look_at_mouse(viewer, &x, &y))
        return;
    if (inspect_layers(&viewer->shown.renderer, output) > 1)
        click_layer(viewer, x, y);
    else if (inspect_is(&viewer->shown.renderer, output, OUTPUT_VALS))
        click_cluster(viewer, x, y);
    else
        click_surface(viewer, x, y);
}

static bool was_clicked(struct viewer *viewer) {
    const struct input *input = viewer->host.input;
    double away = fabs(input->x - input->press_x) + fabs(input->y - input->press_y);
    return input->released[BUTTON_LEFT] && viewer->hand.drags_picture && away < 4;
}

static void use_mouse(struct viewer *viewer) {
    const struct input *input = viewer->host.input;
    /* A drag that began on the picture goes on wherever the mouse is. */
    for (int i = 0; i < BUTTON_COUNT; i++)
        if (input->pressed[i])
            viewer->hand.drags_picture = !ui_wants_mouse();
    bool holds = viewer->hand.light_tool.held != HANDLE_NONE || viewer->hand.drags_split;
    if ((holds || viewer->hand.drags_picture) && (drag_light(viewer) || drag_split(viewer))) {
        viewer->hand.drags_picture = false;
        return;
    }
    if (was_clicked(viewer))
        click(viewer);
    bool looks = input->alt || (input->control && input->shift);
    if (viewer->hand.drags_picture && looks)
        look_drag(viewer);
    else if (viewer->hand.drags_picture)
        camera_hand_drag(viewer);
    if (!ui_wants_mouse() && input->scroll != 0 && looks)
        look_scroll(viewer, input->scroll);
    else if (!ui_wants_mouse() && input->scroll != 0 && input->control)
        viewer_expose(viewer, .25F * (float)input->scroll);
    else if (!ui_wants_mouse() && input->scroll != 0)
        camera_hand_scroll(viewer);
}

void controls_update(struct viewer *viewer, double seconds) {
    if (viewer->host.input->dropped)
        viewer_take_file(viewer, viewer->host.input->dropped);
    if (!ui_wants_keys())
        run_keys(viewer);
    if (viewer->panel.saves_picture)
        key_screenshot(viewer);
    viewer->panel.saves_picture = false;
    if (!viewer->has_scene || viewer->shown.picture.width == 0)
        return;
    use_mouse(viewer);
    show_cursor(viewer);
    if (!ui_wants_keys())
        camera_hand_fly(viewer, seconds);
}
