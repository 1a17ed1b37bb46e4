#define _XOPEN_SOURCE 700
#include "viewer/panel/timeline.h"

#include "scene/animation.h"
#include "viewer/files/recorder.h"
#include "viewer/scene/animation.h"
#include "viewer/window/ui.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static int frame_of(double time) {
    return (int)lround(time * TIMELINE_FPS);
}

static bool is_there(const struct viewer *viewer) {
    return viewer->has_scene && viewer->panel.is_open &&
           scene_duration(&viewer->document.scene) > 0;
}

float timeline_height(const struct viewer *viewer) {
    return is_there(viewer) ? 4.4F * ui_line_height() : 0;
}

void timeline_step(struct viewer *viewer, int frames) {
    if (!viewer->has_scene || scene_duration(&viewer->document.scene) <= 0)
        return;
    viewer->wish.play.on = false;
    viewer_go_to(viewer, (double)(frame_of(viewer->placed.time) + frames) / TIMELINE_FPS);
}

void timeline_ask(struct viewer *viewer, enum record_kind kind) {
    struct record_request *request = &viewer->record;
    char *folder = realpath(".", NULL);
    *request = (struct record_request){
        .is_open = true, .kind = kind, .to = (float)scene_duration(&viewer->document.scene)};
    snprintf(request->folder, sizeof request->folder, "%s", folder ? folder : ".");
    free(folder);
    viewer->wish.play.on = false;
}

static void draw_buttons(struct viewer *viewer) {
    bool records = viewer->recorder.on;
    if (ui_button(viewer->wish.play.on ? "Pause" : "Play", "Space"))
        viewer_toggle_play(viewer);
    ui_same_line();
    if (ui_button("<", "a frame back (,)"))
        timeline_step(viewer, -1);
    ui_same_line();
    if (ui_button(">", "a frame on (.)"))
        timeline_step(viewer, 1);
    ui_same_line();
    if (ui_button(records ? "Stop" : "Record", "the clip or a part of it, frame by frame, as PNG"))
        records ? recorder_stop(viewer) : timeline_ask(viewer, RECORD_PICTURES);
    if (records || !recorder_has_video())
        return;
    ui_same_line();
    if (ui_button("Video", "the clip or a part of it, through ffmpeg"))
        timeline_ask(viewer, RECORD_VIDEO);
}

void timeline_draw(struct viewer *viewer) {
    const struct rectangle *area = &viewer->shown.area;
    float height = timeline_height(viewer), line = ui_line_height();
    float time = (float)viewer->placed.time;
    double duration = scene_duration(&viewer->document.scene);
    if (!is_there(viewer))
        return;
    ui_area_begin("timeline", UI_BAR, (float)area->x, (float)(area->y + area->height),
                  (float)area->width, height);
    ui_disabled_begin(viewer->recorder.on);
    if (ui_scrub("timeline", &time, (float)duration)) {
        viewer->wish.play.on = false;
        viewer_go_to(viewer, (double)time);
    }
    ui_disabled_end();
    draw_buttons(viewer);
    if (viewer->recorder.on) {
        char text[96];
        recorder_tell(viewer, text, sizeof text);
        ui_same_line();
        ui_text_right("%s", text);
    } else if ((float)area->width > 30 * line) {
        ui_same_line();
        ui_text_right("frame %d of %d   %.2f of %.2f s", frame_of(viewer->placed.time),
                      frame_of(duration), viewer->placed.time, duration);
    }
    ui_area_end();
}

/* --- a clip is asked for --- */

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

void timeline_draw_request(struct viewer *viewer) {
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
