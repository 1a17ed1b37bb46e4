/* The panel: the reference of this view, and the accuracy that speed costs. */
#include "viewer/panel/panel.h"

#include "viewer/files/screenshot.h"
#include "viewer/reference/comparing.h"
#include "viewer/reference/tracing.h"

#include <stdio.h>

/* What is good enough, for the button below the rows. */
static const double wanted_error = .05;

/* --- the table --- */

/* Three digits, and no power of ten; seconds from a thousand on. */
static void tell_ms(double ms, char *text, size_t size) {
    if (ms >= 1000)
        snprintf(text, size, ms < 1e5 ? "%.3g s" : "%.0f s", ms / 1000);
    else
        snprintf(text, size, ms < 100 ? "%.3g ms" : "%.0f ms", ms);
}

static bool is_present(const struct viewer *viewer, const struct method_row *row) {
    return row->technique == viewer->wish.technique &&
           renderer_settings_same(&row->settings, &viewer->wish.settings, row->technique->parts);
}

/* The row that was clicked, or -1. Its name must differ from that of a preset's button. */
static int draw_rows(struct viewer *viewer) {
    const struct method_table *table = &viewer->tracing.table;
    int clicked = -1, cheapest = method_table_cheapest(table, wanted_error);
    for (int i = 0; i < table->count; i++) {
        const struct method_row *row = &table->rows[i];
        char name[48], ms[24] = "", error[24] = "";
        snprintf(name, sizeof name, "%s##row", row->name);
        if (row->state == ROW_MEASURED)
            tell_ms(row->ms, ms, sizeof ms);
        if (row->has_error)
            snprintf(error, sizeof error, "%.1f %%", 100 * row->error);
        if (row->state == ROW_LEFT_OUT)
            snprintf(error, sizeof error, "too slow here");
        if (ui_list_item(0, name, ms, error, i == cheapest ? 1 : 0, is_present(viewer, row)) &&
            row->state == ROW_MEASURED)
            clicked = i;
    }
    if (cheapest >= 0 && !viewer_is_measuring(viewer) &&
        ui_wide_button("Take the cheapest below 5 %", table->rows[cheapest].name))
        clicked = cheapest;
    return clicked;
}

static void draw_table(struct viewer *viewer) {
    const struct method_table *table = &viewer->tracing.table;
    if (table->count == 0)
        return;
    if (viewer->panel.shows_table)
        ui_show_here();
    viewer->panel.shows_table = false;
    ui_heading("time of a frame, error of indirect light, noise taken out");
    if (viewer_is_measuring(viewer) && viewer->tracing.samples > 0)
        ui_text(UI_DIM, "measuring %s, %d of %d ...", table->rows[table->next].name,
                table->next + 1, table->count);
    else
        ui_text(UI_DIM, viewer_is_measuring(viewer)
                            ? "waiting for the first samples of the reference ..."
                            : "A click on a row takes it.");
    int clicked = draw_rows(viewer);
    if (clicked >= 0)
        viewer_take_row(viewer, clicked);
}

/* --- the reference --- */

/* A line that is always there: rows do not move under the mouse. */
static void draw_notice(const struct viewer *viewer) {
    const struct tracing *tracing = &viewer->tracing;
    if (tracing->view.lights && !tracing->of_view)
        ui_text(UI_WARNING, "The reference is of another view.");
    else if (tracing->samples > 0 && !viewer_has_reference_size(viewer))
        ui_text(UI_WARNING, "The reference is of another size, %d x %d: Compare shows it.",
                tracing->view.width, tracing->view.height);
    else
        ui_text(UI_DIM, "%s",
                tracing->samples > 0        ? "The reference is of this view."
                : viewer_is_tracing(viewer) ? "tracing the first samples ..."
                                            : "Nothing has been traced.");
}

static void draw_percent(const char *name, const char *help, bool is_known, double value) {
    ui_fact(name, help, is_known ? "%.1f %%" : "-", 100 * value);
}

static void draw_state(const struct viewer *viewer) {
    const struct tracing *tracing = &viewer->tracing;
    draw_notice(viewer);
    ui_value("samples a pixel", "%d%s", tracing->samples,
             viewer_is_tracing(viewer) && tracing->samples > 0 ? " ..." : "");
    draw_percent("its noise",
                 "standard error of the reference's indirect light, RMS over its mean: it falls "
                 "with the samples",
                 tracing->samples > 0, tracing->noise);
    draw_percent("error of indirect light",
                 "relative RMSE of the picture's indirect light, with the reference's noise taken "
                 "out: the error of layer indirect in Compare",
                 tracing->has_error, tracing->error);
}

static void draw_save(struct viewer *viewer) {
    ui_disabled_begin(viewer->tracing.samples == 0);
    if (ui_wide_button("Save the reference",
                       "as EXR with all layers, as manylight reference writes it"))
        viewer_save_reference(viewer);
    ui_disabled_end();
}

void panel_draw_reference(struct viewer *viewer) {
    if (viewer_is_tracing(viewer)) {
        if (ui_wide_button("Stop tracing", "what has been traced stays"))
            reference_tracer_stop(&viewer->tracing.tracer);
    } else if (ui_wide_button(
                   "Trace a reference of this view",
                   "by the path tracer, in the background: it is shown right of the wipe "
                   "as it gets cleaner")) {
        viewer_trace(viewer);
    }
    if (ui_wide_button("Measure speed and accuracy",
                       "times every preset and technique on this view, against its reference; a "
                       "click on one takes it")) {
        viewer_measure(viewer);
        viewer->panel.shows_table = true;
    }
    draw_save(viewer);
    draw_state(viewer);
    draw_table(viewer);
}
