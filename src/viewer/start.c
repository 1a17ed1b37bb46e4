/* The first minute: the empty window's pictures of scenes to click, and the list of files. */
#include "viewer/viewer.h"

#include "base/memory.h"
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
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    snprintf(title, size, "%.*s", (int)strcspn(name, "."), name);
}

/* As many in a row as there is room for. */
static void draw_items(struct viewer *viewer, const char *heading, bool recent, float room) {
    const struct gallery *gallery = &viewer->start.gallery;
    float line = ui_line_height(), gap = .6F * line;
    int columns = (int)((room + gap) / (10 * line + gap)), shown = 0;
    columns = columns < 1 ? 1 : columns;
    for (int i = 0; i < gallery->count; i++) {
        const struct gallery_item *item = &gallery->items[i];
        char title[64];
        if (item->is_recent != recent)
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
    float x = (float)viewer->shown.area.width / 2, y = (float)viewer->shown.area.height / 2;
    ui_area_begin("reading", UI_DIALOG, x, y, 0, 0);
    if (viewer->is_arriving)
        ui_text(UI_DIM, "compiling shaders of %s ...", viewer->arriving.scene.path);
    else
        ui_text(UI_DIM, "reading %s ...", viewer->loader.path);
    ui_area_end();
}

/* --- the list of files --- */

void viewer_ask_file(struct viewer *viewer) {
    file_dialog_open(&viewer->start.dialog);
}

static void take(struct viewer *viewer, char *path) {
    if (path)
        viewer_take_file(viewer, path);
    free(path);
}

static void draw_dialog(struct viewer *viewer) {
    struct file_dialog *dialog = &viewer->start.dialog;
    const struct input *input = viewer->host.input;
    int clicked = -1;
    ui_page_begin("files", (float)input->width, (float)input->height, 42, 32);
    ui_text(UI_TITLE, "Open");
    ui_text(UI_DIM, "%s", dialog->folder);
    bool closes = ui_button("Cancel", "Esc");
    ui_separator();
    for (int i = 0; i < dialog->count; i++)
        if (ui_line(dialog->names[i]))
            clicked = i;
    ui_area_end();
    if (closes)
        file_dialog_close(dialog);
    else if (clicked >= 0)
        take(viewer, file_dialog_choose(dialog, clicked));
}

/* --- both --- */

void start_draw(struct viewer *viewer) {
    struct start *start = &viewer->start;
    bool reads = viewer_is_opening(viewer);
    if (!viewer->has_scene && !reads && !viewer->desc.scene)
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
