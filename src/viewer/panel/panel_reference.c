/* The panel: the reference of this view, and the accuracy that speed costs. */
#include "viewer/panel/panel.h"

#include "viewer/files/screenshot.h"
#include "viewer/reference/comparing.h"
#include "viewer/reference/tracing.h"

#include <math.h>
#include <stdio.h>

/* What is good enough, for the line across the chart and the button below it. */
static const double wanted_error = .05;

static uint32_t dot_color(int i) {
    static const unsigned char colors[][3] = {
        {108, 182, 255}, {240, 168, 72},  {126, 211, 133}, {232, 120, 150},
        {186, 148, 240}, {150, 156, 168}, {90, 206, 206},  {222, 206, 110},
        {198, 110, 66},  {96, 124, 230},  {230, 230, 236}, {176, 214, 64},
        {214, 92, 214},  {122, 96, 78},   {60, 148, 110},  {255, 176, 176}};
    const unsigned char *c = colors[(size_t)i % (sizeof colors / sizeof *colors)];
    return UI_RGBA(c[0], c[1], c[2], 255);
}

/* --- the chart --- */

/* Both axes are logarithmic. */
struct plot {
    float x, y, width, height;
    double least_ms, most_ms, least_error, most_error;
};

static float place(double value, double least, double most) {
    return (float)(log(value / least) / log(most / least));
}

static float x_of(const struct plot *plot, double ms) {
    return plot->x + plot->width * place(ms, plot->least_ms, plot->most_ms);
}

/* An error of less than a thousandth is drawn as that. */
static float y_of(const struct plot *plot, double error) {
    double drawn = fmin(fmax(error, plot->least_error), plot->most_error);
    return plot->y + plot->height * (1 - place(drawn, plot->least_error, plot->most_error));
}

static bool is_drawn(const struct chart_dot *dot) {
    return dot->state == DOT_MEASURED && dot->has_error;
}

static struct plot plot_of(const struct chart *chart, const struct ui_canvas *canvas) {
    float line = ui_line_height();
    struct plot plot = {canvas->x + 2.6F * line,
                        canvas->y + .6F * line,
                        canvas->width - 3.2F * line,
                        canvas->height - 2.4F * line,
                        1e9,
                        0,
                        wanted_error / 2,
                        wanted_error * 2};
    for (int i = 0; i < chart->count; i++) {
        const struct chart_dot *dot = &chart->dots[i];
        if (!is_drawn(dot))
            continue;
        plot.least_ms = fmin(plot.least_ms, dot->ms / 1.5);
        plot.most_ms = fmax(plot.most_ms, dot->ms * 1.5);
        plot.least_error = fmin(plot.least_error, fmax(dot->error, 1e-3) / 1.3);
        plot.most_error = fmax(plot.most_error, dot->error * 1.3);
    }
    return plot;
}

/* Lines at some multiples of powers of ten; each with its number where there is room for it. */
static double tick(int i) {
    static const double steps[] = {1, 2, 3, 5, 7};
    return steps[i % 5] * pow(10, i / 5 - 3);
}

static void tell_tick(double ms, char *text, size_t size) {
    snprintf(text, size, ms >= 1000 ? "%g s" : "%g ms", ms >= 1000 ? ms / 1000 : ms);
}

static void draw_times(const struct plot *plot) {
    float line = ui_line_height(), free_from = plot->x;
    for (int i = 0; i < 50; i++) {
        char text[32];
        double value = tick(i);
        if (value < plot->least_ms || value > plot->most_ms)
            continue;
        float x = x_of(plot, value);
        ui_draw_line(x, plot->y, x, plot->y + plot->height, UI_RGBA(54, 58, 68, 255), 1);
        tell_tick(value, text, sizeof text);
        if (x < free_from)
            continue;
        ui_draw_text(x, plot->y + plot->height + .2F * line, .5F, UI_DIM, text);
        free_from = x + 3.6F * line;
    }
    ui_draw_text(plot->x + plot->width, plot->y + plot->height + 1.1F * line, 1, UI_DIM,
                 "time of a frame");
}

static void draw_errors(const struct plot *plot) {
    float line = ui_line_height(), free_to = plot->y + plot->height;
    for (int i = 0; i < 50; i++) {
        char text[32];
        double percent = tick(i);
        if (percent / 100 < plot->least_error || percent / 100 > plot->most_error)
            continue;
        float y = y_of(plot, percent / 100);
        ui_draw_line(plot->x, y, plot->x + plot->width, y, UI_RGBA(54, 58, 68, 255), 1);
        snprintf(text, sizeof text, "%g %%", percent);
        if (y > free_to)
            continue;
        ui_draw_text(plot->x - .3F * line, y - .6F * line, 1, UI_DIM, text);
        free_to = y - 1.2F * line;
    }
}

/* Three digits, and no power of ten; seconds from a thousand on. */
static void tell_ms(double ms, char *text, size_t size) {
    if (ms >= 1000)
        snprintf(text, size, ms < 1e5 ? "%.3g s" : "%.0f s", ms / 1000);
    else
        snprintf(text, size, ms < 100 ? "%.3g ms" : "%.0f ms", ms);
}

static void tell_dot(const struct chart_dot *dot, char *text, size_t size) {
    char ms[24];
    tell_ms(dot->ms, ms, sizeof ms);
    snprintf(text, size, "%s: %s, error %.1f %%", dot->name, ms, 100 * dot->error);
}

static bool is_under_mouse(const struct ui_canvas *canvas, float x, float y) {
    return canvas->hovered && hypotf(canvas->mouse_x - x, canvas->mouse_y - y) < ui_line_height();
}

/* The dot that was clicked, or -1. */
static int draw_dots(const struct chart *chart, const struct plot *plot,
                     const struct ui_canvas *canvas) {
    int clicked = -1;
    char text[96];
    for (int i = 0; i < chart->count; i++) {
        const struct chart_dot *dot = &chart->dots[i];
        if (!is_drawn(dot))
            continue;
        float x = x_of(plot, dot->ms), y = y_of(plot, dot->error);
        ui_draw_disc(x, y, 5, dot_color(i));
        if (!is_under_mouse(canvas, x, y))
            continue;
        ui_draw_ring(x, y, 8, UI_RGBA(255, 255, 255, 255), 1.5F);
        tell_dot(dot, text, sizeof text);
        ui_tooltip(text);
        if (canvas->clicked)
            clicked = i;
    }
    return clicked;
}

static int draw_plot(const struct chart *chart) {
    struct ui_canvas canvas;
    ui_canvas_begin("chart", 13 * ui_line_height(), &canvas);
    struct plot plot = plot_of(chart, &canvas);
    int clicked = -1;
    if (plot.most_ms > 0) {
        float y = y_of(&plot, wanted_error);
        draw_times(&plot);
        draw_errors(&plot);
        ui_draw_line(plot.x, y, plot.x + plot.width, y, UI_RGBA(240, 168, 72, 255), 1.2F);
        clicked = draw_dots(chart, &plot, &canvas);
    }
    ui_canvas_end();
    return clicked;
}

static bool is_present(const struct viewer *viewer, const struct chart_dot *dot) {
    return dot->technique == viewer->wish.technique &&
           renderer_settings_same(&dot->settings, &viewer->wish.settings, dot->technique->parts);
}

/* The same as rows. The name must differ from that of a preset's button. */
static int draw_rows(struct viewer *viewer) {
    const struct chart *chart = &viewer->tracing.chart;
    int clicked = -1, cheapest = chart_cheapest(chart, wanted_error);
    for (int i = 0; i < chart->count; i++) {
        const struct chart_dot *dot = &chart->dots[i];
        char name[48], ms[24] = "", error[24] = "";
        snprintf(name, sizeof name, "%s##row", dot->name);
        if (dot->state == DOT_MEASURED)
            tell_ms(dot->ms, ms, sizeof ms);
        if (dot->has_error)
            snprintf(error, sizeof error, "%.1f %%", 100 * dot->error);
        if (dot->state == DOT_LEFT_OUT)
            snprintf(error, sizeof error, "too slow here");
        if (ui_list_item(dot_color(i), name, ms, error, i == cheapest ? 1 : 0,
                         is_present(viewer, dot)) &&
            dot->state == DOT_MEASURED)
            clicked = i;
    }
    if (cheapest >= 0 && !viewer_is_charting(viewer) &&
        ui_wide_button("Take the cheapest below 5 %", chart->dots[cheapest].name))
        clicked = cheapest;
    return clicked;
}

static void draw_chart(struct viewer *viewer) {
    const struct chart *chart = &viewer->tracing.chart;
    if (chart->count == 0)
        return;
    if (viewer->panel.shows_chart)
        ui_show_here();
    viewer->panel.shows_chart = false;
    ui_heading("error of indirect light, noise taken out, over time");
    if (viewer_is_charting(viewer) && viewer->tracing.samples > 0)
        ui_text(UI_DIM, "measuring %s, %d of %d ...", chart->dots[chart->next].name,
                chart->next + 1, chart->count);
    else
        ui_text(UI_DIM, viewer_is_charting(viewer)
                            ? "waiting for the first samples of the reference ..."
                            : "A click on a dot or a row takes it.");
    int clicked = draw_plot(chart), row = draw_rows(viewer);
    clicked = row >= 0 ? row : clicked;
    if (clicked >= 0)
        viewer_take_dot(viewer, clicked);
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
    if (ui_wide_button("Chart speed and accuracy",
                       "times every preset and technique on this view, against its reference; a "
                       "click on one takes it")) {
        viewer_chart(viewer);
        viewer->panel.shows_chart = true;
    }
    draw_save(viewer);
    draw_state(viewer);
    draw_chart(viewer);
}
