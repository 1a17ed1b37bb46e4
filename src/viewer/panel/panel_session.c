/* The panel: what is looked at and how, in files and as a command line. */
#include "viewer/panel/panel.h"

#include "base/file/output_file.h"
#include "base/memory.h"
#include "viewer/files/kept.h"
#include "viewer/scene/sessions.h"

#include <stdlib.h>
#include <string.h>

static void copy_command(struct viewer *viewer, const struct session *session) {
    char *command = session_command(session);
    window_set_clipboard(viewer->host.window, command);
    messages_add_result(&viewer->host.messages, "Copied: %s", command);
    free(command);
}

/* For a shell, beside the settings. */
static void save_command(struct viewer *viewer, const struct session *session) {
    char *command = session_command(session), *text = mem_printf("#!/bin/sh\n%s\n", command);
    char *path = mem_printf("%s.sh", viewer->panel.session_path);
    viewer_tell_saved(viewer, output_file_write(path, text, strlen(text)), path);
    free(path);
    free(text);
    free(command);
}

/* For a spreadsheet, beside the settings. */
static void save_times(struct viewer *viewer) {
    struct output_text text;
    char *path = mem_printf("%s.csv", viewer->panel.session_path);
    output_text_init(&text);
    pace_print_csv(&viewer->shown.pace, text.stream);
    viewer_tell_saved(viewer, output_text_end(&text, path), path);
    free(path);
}

void panel_draw_session(struct viewer *viewer) {
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
    if (ui_wide_button("Save command line", "the same, as a script beside the settings: .sh"))
        save_command(viewer, &session);
    if (ui_wide_button("Save times",
                       "of the last frames and their passes, beside the settings: .csv"))
        save_times(viewer);
    session_free(&session);
}
