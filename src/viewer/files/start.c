#include "viewer/files/start.h"

#include "base/file/folder.h"
#include "viewer/files/opening.h"
#include "viewer/window/ui.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Made when the window is empty, and gone when a scene is there. */
static void fill_gallery(struct viewer *viewer) {
    if (viewer->has_gallery)
        return;
    viewer->has_gallery = true;
    gallery_add_own(&viewer->gallery);
    gallery_start(&viewer->gallery, window_wake);
}

static void title_of(const char *path, char *title, size_t size) {
    const char *name = path_name(path);
    snprintf(title, size, "%.*s", (int)strcspn(name, "."), name);
}

/* As many in a row as there is room for. */
static void draw_items(struct viewer *viewer, float room) {
    struct gallery *gallery = &viewer->gallery;
    float line = ui_line_height(), gap = .6F * line;
    int columns = (int)((room + gap) / (10 * line + gap)), shown = 0;
    columns = columns < 1 ? 1 : columns;
    for (int i = 0; i < gallery->count; i++) {
        struct gallery_item *item = &gallery->items[i];
        char title[64];
        if (atomic_load(&item->ready) < 0)
            continue;
        if (shown == 0)
            ui_heading("scenes of the program");
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
    fill_gallery(viewer);
    gallery_follow(&viewer->gallery);
    ui_area_begin("start", UI_PANEL, 0, 0, (float)area->width, (float)area->height);
    ui_text(UI_TITLE, "manylight");
    ui_text(UI_DIM,
            "Click a scene, or drop a .gltf or .glb file on the window. F1 lists the keys.");
    ui_space();
    if (ui_button("Open a file ...", "Ctrl O"))
        viewer_ask_file(viewer);
    draw_items(viewer, (float)area->width - 3 * ui_line_height());
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

/* Beside the scene that is open, or the one that was asked for last, or the program's own. */
void viewer_ask_file(struct viewer *viewer) {
    char *own = folder_find_own("scenes/cornell-box.glb");
    const char *asked = viewer->opening.loader.path;
    viewer->hand.drags_picture = false;
    if (!file_dialog_open(&viewer->dialog, viewer->has_scene ? viewer->document.scene.path
                                           : asked           ? asked
                                                             : own))
        viewer_tell_error(viewer);
    free(own);
}

static void take(struct viewer *viewer, char *path) {
    if (path)
        viewer_take_file(viewer, path);
    free(path);
}

void start_draw(struct viewer *viewer) {
    bool reads = viewer_is_opening(viewer);
    if (!viewer->has_scene && !reads && !viewer_is_scripted(viewer))
        draw_start(viewer);
    if (viewer->has_scene && viewer->has_gallery) {
        gallery_free(&viewer->gallery);
        viewer->has_gallery = false;
    }
    if (reads)
        draw_reading(viewer);
    take(viewer, file_dialog_poll(&viewer->dialog));
}
