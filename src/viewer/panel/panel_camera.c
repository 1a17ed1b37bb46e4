/* The panel's section of the camera: its lens, the pace of flying, and views that are kept. */
#include "viewer/panel/panel.h"

#include "viewer/scene/camera_hand.h"
#include "viewer/scene/placed.h"

#include <cglm/cglm.h>

#include <stdio.h>
#include <string.h>

static void draw_lens(struct viewer *viewer) {
    struct camera *camera = &viewer->placed.orbit.camera;
    float degrees = glm_deg(camera->fov_y), most = 4 * viewer->document.geometry.radius;
    struct ui_row field = {.name = "field of view",
                           .help = "degrees, from top to bottom; Shift and the wheel",
                           .even = true},
                  height = {.name = "half height, m",
                            .help = "half of the height that is in sight, metres"};
    bool changed = camera->orthographic
                       ? ui_float(&height, &camera->y_extent, 1e-3F * most, most)
                       : ui_float(&field, &degrees, CAMERA_FIELD_LEAST, CAMERA_FIELD_MOST);
    if (changed && !camera->orthographic)
        camera->fov_y = glm_rad(degrees);
    if (changed)
        camera_hand_touch(viewer);
}

static void draw_speed(struct viewer *viewer) {
    float radius = viewer->document.geometry.radius, speed = camera_hand_speed(viewer);
    struct ui_row row = {.name = "flying, m/s",
                         .help = "W A S D Q E; the wheel, while one of them or the right button is "
                                 "held",
                         .differs = viewer->hand.fly_speed > 0};
    enum ui_result result = ui_float(&row, &speed, 1e-3F * radius, 10 * radius);
    if (result != UI_NOTHING)
        viewer->hand.fly_speed = result == UI_RESET ? 0 : speed / radius;
}

/* Numbered buttons, five a line. */
static void draw_views(struct viewer *viewer) {
    int shown = 0;
    for (int i = 0; i < SESSION_VIEWS; i++) {
        char name[24];
        snprintf(name, sizeof name, "view %d", i + 1);
        if (!*viewer->placed.views[i])
            continue;
        if (shown++ % 5 > 0)
            ui_same_line();
        if (ui_button(name, "Alt and its number"))
            views_go(viewer, i);
    }
    if (ui_wide_button("Keep this view", "Ctrl and a number, from 1 to 9; saved with the settings"))
        views_keep(viewer, views_free(viewer));
}

void panel_draw_camera(struct viewer *viewer) {
    draw_lens(viewer);
    draw_speed(viewer);
    ui_space();
    draw_views(viewer);
}
