/* The panel: two pictures beside each other, and how far they are apart. */
#include "viewer/panel/panel.h"

#include "shared/composite.h"
#include "viewer/reference/comparing.h"
#include "viewer/reference/tracing.h"

/* --- how they lie --- */

static void draw_layout(struct viewer *viewer) {
    static const char *const layouts[] = {"wipe", "side by side", "difference"};
    static const char *const helps[] = {"left picture, line, right picture (V steps through all)",
                                        "both as a whole (V)", "four times as bright (V)"};
    struct look *look = &viewer->look;
    int layout = look->layout;
    if (ui_explained_segments("layout", &layout, layouts, helps, SCREEN_LAYOUTS)) {
        look->layout = (enum screen_layout)layout;
        look->zoom = 0;
    }
    if (ui_flag(&(struct ui_row){.name = "right alone", .help = "M"},
                &viewer->shown.compare.only_right))
        viewer->shown.recompose = true;
}

/* --- how far they are apart --- */

static void draw_metric(const struct compare *compare, int i, const char *name, bool percent) {
    if (!compare->measured || !compare->has_values)
        ui_fact(name, metrics[i].help, "-");
    else if (percent)
        ui_fact(name, metrics[i].help, "%.1f %%", 100 * compare->values[i]);
    else
        ui_fact(name, metrics[i].help, "%.5g", compare->values[i]);
}

static int index_of(const char *name) {
    return (int)(metric_find(name) - metrics);
}

static const char *layer_title(int layer) {
    return layer == LAYER_DIRECT     ? "errors of direct light"
           : layer == LAYER_INDIRECT ? "errors of indirect light"
                                     : "errors of all light";
}

/* Draws relative RMSE and relative bias. */
static void draw_main_errors(const struct viewer *viewer) {
    const struct compare *compare = &viewer->shown.compare;
    double error, noise = viewer_reference_noise(viewer);
    const char *help =
        compare->mode == COMPARE_REFERENCE && noise > 0
            ? "relative RMSE: root of the mean of squared differences, over the mean of the right "
              "picture; the reference's noise is taken out"
            : "relative RMSE: root of the mean of squared differences, over the mean of the right "
              "picture; noise that the right picture has is in it";
    if (viewer_compared_error(viewer, &error))
        ui_fact(compare->mode == COMPARE_REFERENCE && noise > 0 ? "error, noise taken out"
                                                                : "error",
                help, "%.1f %%", 100 * error);
    else
        ui_fact("error", help, "-");
    draw_metric(compare, index_of("relative-bias"), "brighter by", true);
}

static void draw_heat(struct compare *compare) {
    const char *names[METRIC_COUNT];
    int of[METRIC_COUNT], count = 0, chosen = 0;
    for (int i = 0; i < METRIC_COUNT; i++)
        if (compare_has_metric(i)) {
            chosen = i == compare->heat_metric ? count : chosen;
            of[count] = i;
            names[count++] = metrics[i].name;
        }
    struct ui_row heat = {.name = "heat map", .help = "errors in place of the left picture"},
                  metric = {.name = "of", .help = metrics[compare->heat_metric].help};
    enum ui_result result = ui_flag(&heat, &compare->heat);
    if (compare->heat && ui_choice(&metric, &chosen, names, count)) {
        compare->heat_metric = of[chosen];
        result = UI_CHANGED;
    }
    if (result)
        compare->heat_drawn = false;
}

static void draw_errors(struct viewer *viewer) {
    struct compare *compare = &viewer->shown.compare;
    ui_heading(layer_title(viewer->shown.layer));
    draw_main_errors(viewer);
    draw_heat(compare);
    if (ui_section("All metrics", false))
        for (int i = 0; i < METRIC_COUNT; i++)
            if (compare_has_metric(i))
                draw_metric(compare, i, metrics[i].name, false);
}

/* --- all together --- */

static void draw_mode(struct viewer *viewer) {
    static const char *const modes[] = {"off", "technique", "reference"};
    struct compare *compare = &viewer->shown.compare;
    int mode = compare->mode;
    if (!ui_segments("compare", &mode, modes, COMPARE_MODES))
        return;
    compare->mode = (enum compare_mode)mode;
    viewer->panel.edits_right = mode == COMPARE_TECHNIQUE;
    viewer->shown.dirty = true;
    if (mode == COMPARE_REFERENCE)
        viewer_compare_reference(viewer);
}

void panel_draw_compare(struct viewer *viewer) {
    struct compare *compare = &viewer->shown.compare;
    draw_mode(viewer);
    if (compare->mode == COMPARE_REFERENCE && !viewer->tracing.view.lights) {
        struct ui_row row = {.name = "file", .help = "EXR, PFM, ... of the same view"};
        if (ui_text_field(&row, viewer->panel.reference_path, sizeof viewer->panel.reference_path,
                          "path, Enter"))
            viewer_load_reference(viewer, viewer->panel.reference_path);
    }
    if (viewer->shown.fixed_width > 0 &&
        ui_wide_button(
            "Fill the window again",
            "the picture has the reference's size; the reference and its table stay, and "
            "'reference' above shows them again"))
        viewer_fill_window(viewer);
    /* At once, though the right picture comes later: rows do not move under the mouse. */
    if (compare->mode != COMPARE_OFF) {
        draw_layout(viewer);
        draw_errors(viewer);
    }
}
