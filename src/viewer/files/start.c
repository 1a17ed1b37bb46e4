#include "viewer/files/start.h"

#include "base/file/folder.h"
#include "viewer/files/opening.h"
#include "viewer/window/ui.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- pictures --- */

/* Made when the window is empty, and gone when a scene is there. */
static void fill_gallery(struct viewer *viewer) {
    struct start *start = &viewer->start;
    if (start->has_gallery)
        return;
    start->has_gallery = true;
    for (int i = 0; i < start->recent.count; i++)
        gallery_add(&start->gallery, start->recent.paths[i], true);
    gallery_add_own(&start->gallery);
    gallery_start(&start->gallery, window_wake);
}

static void title_of(const char *path, char *title, size_t size) {
    const char *name = path_name(path);
    snprintf(title, size, "%.*s", (int)strcspn(name, "."), name);
}

/* As many in a row as there is room for. */
static void draw_items(struct viewer *viewer, const char *heading, bool recent, float room) {
    struct gallery *gallery = &viewer->start.gallery;
    float line = ui_line_height(), gap = .6F * line;
    int columns = (int)((room + gap) / (10 * line + gap)), shown = 0;
    columns = columns < 1 ? 1 : columns;
    for (int i = 0; i < gallery->count; i++) {
        struct gallery_item *item = &gallery->items[i];
        char title[64];
        if (item->is_recent != recent || (!recent && atomic_load(&item->ready) < 0))
            continue;
        if (shown == 0)
            ui_heading(heading);
        else if (shown % columns != 0)
            ui_same_line();
        shown++;
        title_of(item->path, title, sizeof title);
        if (ui_tile(title, item->has_texture ? item->texture.id : 0, 10 * line, 7.5F * line,
                    item->path))
            viewer_open(viewer, item->path);
    }
}

static void draw_start(struct viewer *viewer) {
    const struct rectangle *area = &viewer->shown.area;
    float line = ui_line_height(), room = (float)area->width - 3 * line;
    fill_gallery(viewer);
    gallery_follow(&viewer->start.gallery);
    ui_area_begin("start", UI_PANEL, 0, 0, (float)area->width, (float)area->height);
    ui_text(UI_TITLE, "manylight");
    ui_text(UI_DIM,
            "Click a scene, or drop a .gltf or .glb file on the window. F1 lists the keys.");
    ui_space();
    if (ui_button("Open a file ...", "Ctrl O"))
        viewer_ask_file(viewer);
    draw_items(viewer, "opened before", true, room);
    draw_items(viewer, "scenes of the program", false, room);
    ui_area_end();
}

static void draw_reading(struct viewer *viewer) {
    const struct rectangle *area = &viewer->shown.area;
    bool over_picture = viewer->has_scene || preview_picture(&viewer->opening.preview);
    float x = (float)area->width / 2, y = (float)area->height / 2;
    char text[600];
    viewer_tell_opening(viewer, text, sizeof text);
    if (over_picture)
        y = 5.5F * ui_line_height(); /* messages are below, times in the corner */
    ui_area_begin("reading", UI_DIALOG, x, y, 0, 0);
    ui_text(UI_DIM, "%s\nEsc stops.", text);
    ui_area_end();
}

/* --- the list of files --- */

/* Beside the scene that is open, or the one that was asked for last. */
void viewer_ask_file(struct viewer *viewer) {
    viewer->hand.drags_picture = false;
    viewer->panel.help = false; /* it would cover the list and take its keyboard */
    file_dialog_open(&viewer->start.dialog,
                     viewer->has_scene ? viewer->document.scene.path : viewer->opening.loader.path);
}

static void take(struct viewer *viewer, char *path) {
    if (path)
        viewer_take_file(viewer, path);
    free(path);
}

/* The file that Enter gives; NULL = none. */
static char *draw_search(struct file_dialog *dialog) {
    static const int steps[] = {[UI_SEARCH_UP] = -1,
                                [UI_SEARCH_DOWN] = 1,
                                [UI_SEARCH_PAGE_UP] = -12,
                                [UI_SEARCH_PAGE_DOWN] = 12};
    enum ui_search done =
        ui_search_field("##typed", dialog->typed, sizeof dialog->typed, "name or path");
    if (done == UI_SEARCH_ENTERED)
        return file_dialog_accept(dialog);
    if (done == UI_SEARCH_EDITED)
        file_dialog_search(dialog);
    else if (done == UI_SEARCH_BACK)
        file_dialog_leave(dialog);
    else if (done != UI_SEARCH_NOTHING)
        file_dialog_move(dialog, steps[done]);
    return NULL;
}

/* The name that was clicked; -1 = none. */
static int draw_names(struct file_dialog *dialog) {
    int clicked = -1;
    ui_list_begin("names");
    for (int i = 0; i < dialog->count; i++)
        if (ui_entry(dialog->names[i], i == dialog->chosen, dialog->seeks))
            clicked = i;
    dialog->seeks = false;
    ui_list_end();
    return clicked;
}

static void draw_dialog(struct viewer *viewer) {
    struct file_dialog *dialog = &viewer->start.dialog;
    const struct input *input = viewer->host.input;
    ui_veil((float)input->width, (float)input->height);
    ui_page_begin("files", (float)input->width, (float)input->height, 42, 32);
    ui_text(UI_TITLE, "Open");
    ui_text(UI_DIM, "%s", dialog->folder);
    bool closes = ui_button("Cancel", "Esc");
    ui_same_line();
    bool leaves = ui_button("Up", "the folder above; Backspace");
    ui_same_line();
    bool goes_home = ui_button("Home", "your own folder; or type ~ and Enter");
    char *file = draw_search(dialog);
    if (*dialog->problem)
        ui_text(UI_ERROR, "%s", dialog->problem);
    int clicked = file ? -1 : draw_names(dialog);
    ui_area_end();
    if (closes)
        file_dialog_close(dialog);
    else if (leaves)
        file_dialog_leave(dialog);
    else if (goes_home)
        file_dialog_enter(dialog, "~");
    else
        take(viewer, clicked >= 0 ? file_dialog_choose(dialog, clicked) : file);
}

/* --- both --- */

void start_draw(struct viewer *viewer) {
    struct start *start = &viewer->start;
    bool reads = viewer_is_opening(viewer);
    if (!viewer->has_scene && !reads && !viewer_is_scripted(viewer))
        draw_start(viewer);
    if (viewer->has_scene && start->has_gallery) {
        gallery_free(&start->gallery);
        start->has_gallery = false;
    }
    if (reads)
        draw_reading(viewer);
    if (start->dialog.is_open)
        draw_dialog(viewer);
    take(viewer, file_dialog_poll(&start->dialog));
}

bool start_has_news(struct start *start) {
    return gallery_has_news(&start->gallery) || start->dialog.answer;
}

void start_free(struct start *start) {
    gallery_free(&start->gallery);
    recent_free(&start->recent);
    file_dialog_close(&start->dialog);
}
