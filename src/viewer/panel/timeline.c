#include "viewer/panel/panel.h"

#include "scene/animation.h"
#include "viewer/scene/animation.h"
#include "viewer/window/ui.h"

#include <math.h>

enum { TIMELINE_FPS = 25 }; /* as manylight render --fps has it */

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

static void draw_buttons(struct viewer *viewer) {
    if (ui_button(viewer->wish.play.on ? "Pause" : "Play", "Space"))
        viewer_toggle_play(viewer);
    ui_same_line();
    if (ui_button("<", "a frame back (,)"))
        timeline_step(viewer, -1);
    ui_same_line();
    if (ui_button(">", "a frame on (.)"))
        timeline_step(viewer, 1);
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
    if (ui_scrub("timeline", &time, (float)duration)) {
        viewer->wish.play.on = false;
        viewer_go_to(viewer, (double)time);
    }
    draw_buttons(viewer);
    if ((float)area->width > 30 * line) {
        ui_same_line();
        ui_text_right("frame %d of %d   %.2f of %.2f s", frame_of(viewer->placed.time),
                      frame_of(duration), viewer->placed.time, duration);
    }
    ui_area_end();
}
