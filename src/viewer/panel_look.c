/* The panel's section of looking closely: how large pixels are, and their values. */
#include "viewer/viewer.h"

#include "viewer/window/ui.h"

void panel_draw_look(struct viewer *viewer) {
    static const char *const zooms[] = {"fit", "1:1"};
    struct look *look = &viewer->look;
    int zoom = look->zoom > 0;
    float percent = (float)(100 * look_zoom(viewer));
    struct ui_row enlarged = {
        .name = "enlarged, %",
        .help =
            "100: a pixel of the picture is one of the window; Ctrl Shift wheel, and Ctrl Shift "
            "drag moves the picture",
        .differs = look->zoom > 0};
    if (!viewer->shown.left)
        return;
    if (ui_segments("zoom", &zoom, zooms, 2))
        look_toggle(viewer);
    enum ui_result result = ui_float(&enlarged, &percent, 10, 100 * LOOK_ZOOM_MOST);
    if (result == UI_RESET)
        look->zoom = 0;
    else if (result == UI_CHANGED)
        look_enlarge(viewer, (double)percent / 100);
    ui_flag(&(struct ui_row){.name = "inspector",
                             .help = "values of the pixel under the mouse (I): linear radiance"},
            &look->inspects);
}
