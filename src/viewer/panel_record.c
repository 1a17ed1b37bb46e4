/* Asks for a clip's range and folder before it is recorded. */
#define _XOPEN_SOURCE 700
#include "viewer/viewer.h"

#include "scene/animation.h"
#include "viewer/window/ui.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

void recorder_ask(struct viewer *viewer, enum record_kind kind) {
    struct record_request *request = &viewer->record;
    char *folder = realpath(".", NULL);
    *request = (struct record_request){
        .is_open = true, .kind = kind, .to = (float)scene_duration(&viewer->document.scene)};
    snprintf(request->folder, sizeof request->folder, "%s", folder ? folder : ".");
    free(folder);
    viewer->wish.play.on = false;
}

static void draw_range(struct viewer *viewer) {
    struct record_request *request = &viewer->record;
    float most = (float)scene_duration(&viewer->document.scene);
    ui_float(&(struct ui_row){.name = "from, s", .help = "of the clip", .even = true},
             &request->from, 0, most);
    ui_float(&(struct ui_row){.name = "to, s", .help = "of the clip", .even = true}, &request->to,
             0, most);
    request->to = fmaxf(request->from, request->to);
    int frames = (int)lround((double)(request->to - request->from) * TIMELINE_FPS);
    ui_text(UI_DIM, "%d frames, %d a second", frames > 0 ? frames : 1, TIMELINE_FPS);
}

void recorder_draw_request(struct viewer *viewer) {
    struct record_request *request = &viewer->record;
    const struct input *input = viewer->host.input;
    if (!request->is_open || !viewer->has_scene)
        return;
    bool video = request->kind == RECORD_VIDEO;
    ui_page_begin("record", (float)input->width, (float)input->height, 30, 12.5F);
    ui_text(UI_TITLE, video ? "Record a video" : "Record pictures");
    ui_separator();
    draw_range(viewer);
    struct ui_row folder = {.name = "into folder",
                            .help = video ? "manylight-clip-0001.mp4 is made in it"
                                          : "manylight-clip-0001 is made in it"};
    bool start = ui_text_field(&folder, request->folder, sizeof request->folder, "path, Enter") ==
                 UI_CHANGED;
    ui_space();
    start |= ui_button("Start", "Enter; Esc or Stop ends it") || ui_is_entered();
    ui_same_line();
    bool cancel = ui_button("Cancel", "Esc");
    ui_area_end();
    if (start)
        recorder_start(viewer);
    if (start || cancel)
        request->is_open = false;
}
