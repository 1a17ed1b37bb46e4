/* Keys and mouse. The table of keys is also the help that is shown. */
#include "viewer/viewer.h"

#include "shared/params.h"
#include "viewer/ui.h"

#include <math.h>
#include <string.h>

/* --- keys --- */

static void show_layer(struct viewer *viewer, int layer) {
    viewer->layer = layer;
    viewer->choice.kind = SHOW_PICTURE;
    viewer->recompose = true;
}

static void key_full(struct viewer *viewer) {
    show_layer(viewer, LAYER_BEAUTY);
}
static void key_indirect(struct viewer *viewer) {
    show_layer(viewer, LAYER_INDIRECT);
}
static void key_direct(struct viewer *viewer) {
    show_layer(viewer, LAYER_DIRECT);
}
static void key_next(struct viewer *viewer) {
    if (viewer->has_scene)
        viewer_step_buffer(viewer, 1);
}
static void key_previous(struct viewer *viewer) {
    if (viewer->has_scene)
        viewer_step_buffer(viewer, -1);
}
static void key_home(struct viewer *viewer) {
    if (viewer->has_scene)
        viewer_pick_camera(viewer, viewer->camera);
}
static void key_help(struct viewer *viewer) {
    viewer->show_help = !viewer->show_help;
}
static void key_panel(struct viewer *viewer) {
    viewer->show_panel = !viewer->show_panel;
}
static void key_overlay(struct viewer *viewer) {
    viewer->show_overlay = !viewer->show_overlay;
}
static void key_full_screen(struct viewer *viewer) {
    window_toggle_full_screen(viewer->window);
}
static void key_quit(struct viewer *viewer) {
    viewer->done = true;
}

static const struct key {
    int key;
    const char *name, *help;
    void (*run)(struct viewer *viewer);
} keys[] = {
    {'1', "1", "all light", key_full},
    {'2', "2", "indirect light alone", key_indirect},
    {'3', "3", "direct light alone", key_direct},
    {KEY_LEFT_BRACKET, "[", "previous buffer of the frame", key_previous},
    {KEY_RIGHT_BRACKET, "]", "next buffer", key_next},
    {'R', "R", "back to the scene's camera", key_home},
    {KEY_F1, "F1", "this help", key_help},
    {KEY_F2, "F2", "panel", key_panel},
    {KEY_F3, "F3", "times and counts", key_overlay},
    {KEY_F11, "F11", "full screen", key_full_screen},
    {KEY_F12, "F12", "screenshot: PNG, and EXR with all layers", viewer_take_screenshot},
    {KEY_ESCAPE, "Esc", "quit", key_quit},
};

enum { KEY_ROWS = sizeof keys / sizeof *keys };

static const struct {
    const char *name, *help;
} gestures[] = {
    {"left drag", "orbit"},
    {"middle or Shift left drag", "pan"},
    {"right drag", "look around"},
    {"wheel", "zoom"},
    {"W A S D Q E", "fly; Shift fast, Ctrl slow"},
};

static void run_keys(struct viewer *viewer) {
    for (int i = 0; i < viewer->input->key_count; i++)
        for (int k = 0; k < KEY_ROWS; k++)
            if (keys[k].key == viewer->input->keys[i])
                keys[k].run(viewer);
}

void controls_draw_help(void) {
    for (int i = 0; i < KEY_ROWS; i++)
        ui_value(keys[i].help, "%s", keys[i].name);
    ui_separator();
    for (size_t i = 0; i < sizeof gestures / sizeof *gestures; i++)
        ui_value(gestures[i].help, "%s", gestures[i].name);
}

/* --- the camera --- */

static void fly(struct viewer *viewer, double seconds) {
    const struct input *input = viewer->input;
    float pace = input->shift ? 3.F : input->control ? .1F : .7F, step = pace * (float)seconds;
    float right = (float)(input->key_held['D'] - input->key_held['A']);
    float up = (float)(input->key_held['E'] - input->key_held['Q']);
    float forward = (float)(input->key_held['W'] - input->key_held['S']);
    if (right == 0 && up == 0 && forward == 0)
        return;
    orbit_fly(&viewer->orbit, right * step, up * step, forward * step);
    viewer_touch(viewer);
}

static void drag(struct viewer *viewer) {
    const struct input *input = viewer->input;
    float height = (float)viewer->picture.height;
    float right = (float)input->dx / height, down = (float)input->dy / height;
    bool pan = input->held[BUTTON_MIDDLE] || (input->held[BUTTON_LEFT] && input->shift);
    if (right == 0 && down == 0)
        return;
    if (pan)
        orbit_pan(&viewer->orbit, right, down);
    else if (input->held[BUTTON_LEFT])
        orbit_turn(&viewer->orbit, right, down);
    else if (input->held[BUTTON_RIGHT])
        orbit_look(&viewer->orbit, right, down);
    else
        return;
    viewer_touch(viewer);
}

/* --- clicks --- */

/* A click on a sheet shows that layer alone, the next one the sheet again. */
static void click_layer(struct viewer *viewer, float x, float y) {
    struct inspect_choice *choice = &viewer->choice;
    choice->layer = choice->layer < 0 ? inspect_sheet_layer(&viewer->renderer, choice, x, y) : -1;
    viewer->recompose = true;
}

static void click(struct viewer *viewer) {
    const struct input *input = viewer->input;
    const struct rectangle *picture = &viewer->picture;
    if (input->pressed[BUTTON_LEFT]) {
        viewer->press_x = input->x;
        viewer->press_y = input->y;
    }
    double away = fabs(input->x - viewer->press_x) + fabs(input->y - viewer->press_y);
    if (!input->released[BUTTON_LEFT] || !viewer->drags_picture || away > 4)
        return;
    float x = (float)(input->x - picture->x) / (float)picture->width;
    float y = (float)(input->y - picture->y) / (float)picture->height;
    if (inspect_layers(&viewer->renderer, viewer->choice.kind) > 1)
        click_layer(viewer, x, y);
}

void controls_update(struct viewer *viewer) {
    const struct input *input = viewer->input;
    double now = window_time(), seconds = now - viewer->last_update;
    viewer->last_update = now;
    if (input->dropped)
        viewer_open(viewer, input->dropped);
    if (!ui_wants_keys())
        run_keys(viewer);
    if (!viewer->has_scene)
        return;
    click(viewer);
    /* A drag that began on the picture goes on wherever the mouse is. */
    for (int i = 0; i < BUTTON_COUNT; i++)
        if (input->pressed[i])
            viewer->drags_picture = !ui_wants_mouse();
    if (viewer->drags_picture)
        drag(viewer);
    if (!ui_wants_mouse() && input->scroll != 0) {
        orbit_zoom(&viewer->orbit, (float)input->scroll);
        viewer_touch(viewer);
    }
    if (!ui_wants_keys())
        fly(viewer, seconds < .25 ? seconds : .25);
}
