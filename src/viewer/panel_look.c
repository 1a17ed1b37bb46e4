/* The panel's section of looking closely: how pictures lie in the window, and their pixels. */
#include "viewer/viewer.h"

#include "viewer/window/ui.h"

void panel_draw_look(struct viewer *viewer) {
    static const char *const layouts[] = {"wipe", "beside", "difference"};
    static const char *const zooms[] = {"fit", "1:1"};
    struct look *look = &viewer->look;
    int layout = look->layout, zoom = look->zoom > 0;
    if (viewer->shown.right && ui_segments("layout", &layout, layouts, SCREEN_LAYOUTS)) {
        look->layout = (enum screen_layout)layout;
        look->zoom = 0;
    }
    if (ui_segments("zoom", &zoom, zooms, 2))
        look_toggle(viewer);
    ui_value("a pixel takes", "%.3g", look_zoom(viewer));
    ui_flag(&(struct ui_row){.name = "inspector",
                             .help = "values of the pixel under the mouse (I): linear radiance"},
            &look->inspects);
}
