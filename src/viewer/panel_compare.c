/* The panel: two pictures beside each other, and how far they are apart. */
#include "viewer/panel.h"

static void draw_errors(struct viewer *viewer) {
    struct compare *compare = &viewer->shown.compare;
    const char *names[METRIC_COUNT];
    ui_space();
    for (int i = 0; i < METRIC_COUNT; i++) {
        names[i] = metrics[i].name;
        if (compare->measured && compare->is_known[i])
            ui_value(metrics[i].name, "%.5g", compare->values[i]);
        else
            ui_value(metrics[i].name, "%s", measuring_is_slow(i) && compare->flip ? "..." : "-");
    }
    ui_space();
    struct ui_row heat = {.name = "heat map", .help = "errors in place of the left picture"},
                  metric = {.name = "of", .help = metrics[compare->heat_metric].help};
    enum ui_result result = ui_flag(&heat, &compare->heat);
    if (compare->heat && ui_choice(&metric, &compare->heat_metric, names, METRIC_COUNT))
        result = UI_CHANGED;
    if (result)
        compare->heat_drawn = false;
    if (ui_flag(&(struct ui_row){.name = "FLIP",
                                 .help = "looks at neighbourhoods: comes a while after the others"},
                &compare->flip))
        compare->measured = false;
}

void panel_draw_compare(struct viewer *viewer) {
    static const char *const modes[] = {"off", "technique", "reference"};
    struct compare *compare = &viewer->shown.compare;
    int mode = compare->mode;
    if (ui_segments("compare", &mode, modes, COMPARE_MODES)) {
        compare->mode = (enum compare_mode)mode;
        viewer->panel.edits_right = mode == COMPARE_TECHNIQUE;
        viewer->shown.dirty = true;
    }
    if (mode == COMPARE_REFERENCE && !viewer->tracing.view.lights) {
        struct ui_row row = {.name = "file", .help = "EXR, PFM, ... of the same view"};
        if (ui_text_field(&row, viewer->panel.reference_path, sizeof viewer->panel.reference_path,
                          "path, Enter"))
            viewer_load_reference(viewer, viewer->panel.reference_path);
    }
    if (viewer->shown.fixed_width > 0 &&
        ui_wide_button("Fill the window again",
                       "ends the comparison: the picture has the reference's size now")) {
        viewer_forget_truth(viewer);
        compare->mode = COMPARE_OFF;
        viewer->shown.fixed_width = viewer->shown.fixed_height = 0;
        viewer->shown.dirty = true;
    }
    if (viewer->shown.right) {
        if (ui_flag(&(struct ui_row){.name = "right alone", .help = "M"}, &compare->only_right))
            viewer->shown.recompose = true;
        draw_errors(viewer);
    }
}
