#define _DEFAULT_SOURCE
#include "viewer/files/start.h"

#include "base/file/folder.h"
#include "base/memory.h"
#include "viewer/files/opening.h"
#include "viewer/window/ui.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int is_scene(const struct dirent *entry) {
    const char *dot = strrchr(entry->d_name, '.');
    return dot && strcmp(dot, ".glb") == 0;
}

static void add_folder(struct own_scenes *scenes, const char *folder) {
    struct dirent **entries;
    int count = scandir(folder, &entries, is_scene, alphasort);
    for (int i = 0; i < count; i++) {
        if (scenes->count < OWN_SCENES_MAX)
            scenes->paths[scenes->count++] = mem_printf("%s/%s", folder, entries[i]->d_name);
        free(entries[i]);
    }
    if (count >= 0)
        free(entries);
}

/* Scenes of the first folder of the program that has some. */
static void list_own(struct own_scenes *scenes) {
    char *folder;
    for (int n = 0; scenes->count == 0 && (folder = folder_of_program(n)); n++) {
        char *path = mem_printf("%sscenes", folder);
        add_folder(scenes, path);
        mem_free(path, folder);
    }
    scenes->is_listed = true;
}

void start_free(struct viewer *viewer) {
    for (int i = 0; i < viewer->own_scenes.count; i++)
        free(viewer->own_scenes.paths[i]);
}

static void draw_own(struct viewer *viewer) {
    struct own_scenes *scenes = &viewer->own_scenes;
    if (!scenes->is_listed)
        list_own(scenes);
    if (scenes->count > 0)
        ui_heading("scenes of the program");
    for (int i = 0; i < scenes->count; i++) {
        const char *path = scenes->paths[i], *name = path_name(path);
        char title[64];
        snprintf(title, sizeof title, "%.*s", (int)strcspn(name, "."), name);
        if (ui_wide_button(title, path))
            viewer_open(viewer, path);
    }
}

static void draw_start(struct viewer *viewer) {
    const struct rectangle *area = &viewer->shown.area;
    ui_area_begin("start", UI_PANEL, 0, 0, (float)area->width, (float)area->height);
    ui_text(UI_TITLE, "manylight");
    ui_text(UI_DIM,
            "Click a scene, or drop a .gltf or .glb file on the window. F1 lists the keys.");
    ui_space();
    if (ui_button("Open a file ...", "Ctrl O"))
        viewer_ask_file(viewer);
    draw_own(viewer);
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
    if (reads)
        draw_reading(viewer);
    take(viewer, file_dialog_poll(&viewer->dialog));
}
