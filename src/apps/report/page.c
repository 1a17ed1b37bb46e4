#include "apps/report/page.h"

#include "apps/bench/measure/result_rows.h"
#include "apps/report/chart.h"
#include "apps/report/embedded.h"
#include "apps/report/html.h"
#include "base/memory.h"
#include "scene/medium.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Colours of both schemes; tables scroll by themselves where they are wider than the window. */
static const char style[] =
    ":root{color-scheme:light dark;--back:#fff;--text:#1a1a1a;--soft:#5a5a5a;--line:#d4d4d4;"
    "--mark:#b3411e}\n"
    "@media(prefers-color-scheme:dark){:root{--back:#16181b;--text:#e6e6e6;--soft:#a3a3a3;"
    "--line:#3a3d42;--mark:#ff9a73}}\n"
    "body{background:var(--back);color:var(--text);font:16px/1.5 system-ui,sans-serif;margin:0 "
    "auto;"
    "max-width:72rem;padding:1rem 1.25rem 3rem}\n"
    "h1,h2{line-height:1.2}h2{margin-top:2.5rem}\n"
    ".wide{overflow-x:auto}table{border-collapse:collapse;font-variant-numeric:tabular-nums}\n"
    "th,td{padding:.25rem .6rem;border-bottom:1px solid var(--line);text-align:right;"
    "white-space:nowrap}th:first-child,td:first-child{text-align:left}\n"
    ".soft,.tick,figcaption{color:var(--soft);fill:var(--soft)}\n"
    "svg{width:100%;height:auto;font:13px system-ui,sans-serif;fill:var(--text)}\n"
    ".grid{stroke:var(--line);fill:none}.floor{stroke:var(--soft);stroke-dasharray:5 4;fill:none}\n"
    ".point circle{fill:var(--mark)}.point path{stroke:var(--line);fill:none}"
    ".point:hover path{stroke:var(--mark)}\n"
    ".pictures{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,20rem),1fr));"
    "gap:1.25rem;margin-bottom:1.25rem}\n"
    "figure{margin:0}figure img{width:100%;height:auto;display:block}"
    "figcaption{overflow-wrap:anywhere}\n"
    "summary{cursor:pointer}dt{color:var(--soft)}dl{display:grid;grid-template-columns:max-content "
    "1fr;gap:.1rem 1rem}dd{margin:0;overflow-wrap:anywhere}\n";

static const struct subject *subject_of(const struct report *report, int i) {
    return &report->results.subjects[i];
}

static double value_of(const struct report *report, int i, const char *what) {
    return results_value(&report->results, i, what, NULL);
}

static void print_fact(FILE *out, const char *name, const char *value) {
    fprintf(out, "<dt>%s</dt><dd>", name);
    html_print_text(out, value);
    fprintf(out, "</dd>\n");
}

static void print_count(FILE *out, const char *name, long count) {
    char text[32];
    snprintf(text, sizeof text, "%ld", count);
    print_fact(out, name, text);
}

static void print_facts(FILE *out, const struct report *report) {
    const struct stage *stage = report->stage;
    char size[32], noise[32];
    snprintf(size, sizeof size, "%dx%d", report->width, report->height);
    snprintf(noise, sizeof noise, "%.2g %%", 100 * report->noise);
    fprintf(out, "<dl>\n");
    print_fact(out, "scene", report->path);
    print_count(out, "triangles", (long)geometry_triangle_count(&stage->geometry));
    print_count(out, "materials", stage->scene.material_count);
    print_count(out, "lights", stage->emitters.count);
    if (stage->scene.environment)
        print_fact(out, "environment", "yes");
    if (medium_exists(&stage->scene.medium))
        print_fact(out, "medium", "yes");
    print_fact(out, "size", size);
    print_fact(out, "noise of the reference", noise);
    fprintf(out, "</dl>\n");
}

static void print_machine(FILE *out) {
    struct machine_cell cells[MACHINE_CELLS + 1];
    machine_cells_init(cells);
    fprintf(out, "<h2>Machine</h2>\n<dl>\n");
    for (int i = 0; i < MACHINE_CELLS; i++)
        print_fact(out, cells[i].name, cells[i].value);
    fprintf(out, "</dl>\n");
    machine_cells_free(cells);
}

/* --- figures ---------------------------------------------------------------------------------- */

/* Of a black reference errors are infinite. */
static bool is_shown(double value) {
    return value > 0 && isfinite(value);
}

static void print_chart(FILE *out, const struct report *report) {
    int count = 0;
    struct chart_point *points = mem_alloc((size_t)report->subjects.count, sizeof *points);
    for (int i = 0; i < report->subjects.count; i++) {
        double ms = value_of(report, i, "clock"), error = value_of(report, i, "relative-rmse");
        if (is_shown(ms) && is_shown(error))
            points[count++] = (struct chart_point){subject_of(report, i)->desc.variant, ms, error};
    }
    fprintf(out, "<h2>Error against time</h2>\n");
    if (count) {
        chart_print(out, &(struct chart){"ms of a frame", "relative RMSE of indirect light, %",
                                         points, count, 100 * report->noise});
        fprintf(out, "<p class=\"soft\">The dashed line is the noise of the reference.</p>\n");
    } else {
        fprintf(out,
                "<p>The reference has no indirect light, so no error is relative to it.</p>\n");
    }
    free(points);
}

/* Nothing where there is no number. */
static void print_cell(FILE *out, const char *format, double value) {
    char text[32];
    snprintf(text, sizeof text, format, value);
    fprintf(out, "<td>%s</td>", isfinite(value) ? text : "");
}

static double flicker_of(const struct report *report, int i) {
    const struct results *flicker = &report->flicker;
    const char *variant = subject_of(report, i)->desc.variant;
    for (int s = 0; s < flicker->subject_count; s++)
        if (strcmp(flicker->subjects[s].desc.variant, variant) == 0 &&
            results_find(flicker, s, "flicker", NULL))
            return results_value(flicker, s, "flicker", NULL);
    return NAN;
}

static void print_table_row(FILE *out, const struct report *report, int i) {
    const struct summary *clock = &results_find(&report->results, i, "clock", NULL)->figure;
    fprintf(out, "<tr><td>");
    html_print_text(out, subject_of(report, i)->desc.variant);
    const double times[] = {clock->value, clock->p5, clock->p95};
    static const char *const before[] = {"</td><td>", "</td><td>", " to "};
    for (int t = 0; t < 3; t++) {
        fprintf(out, "%s", before[t]);
        html_print_number(out, times[t]);
    }
    fprintf(out, "</td>");
    print_cell(out, "%.3g", value_of(report, i, "gpu-memory"));
    print_cell(out, "%.2f", value_of(report, i, "relative-rmse"));
    print_cell(out, "%+.2f", value_of(report, i, "relative-bias"));
    print_cell(out, "%.4f", value_of(report, i, "ldr-flip"));
    if (report->flicker.subject_count)
        print_cell(out, "%.2f", flicker_of(report, i));
    fprintf(out, "</tr>\n");
}

static void print_table(FILE *out, const struct report *report) {
    fprintf(out,
            "<h2>Figures</h2>\n<div class=\"wide\"><table>\n<tr><th></th><th>ms</th>"
            "<th>5 to 95 %%</th><th>MiB</th><th>rRMSE %%</th><th>bias %%</th><th>FLIP</th>%s"
            "</tr>\n",
            report->flicker.subject_count ? "<th>flicker %</th>" : "");
    for (int i = 0; i < report->subjects.count; i++)
        print_table_row(out, report, i);
    fprintf(out, "</table></div>\n<p class=\"soft\">Time: median of a frame without timers. RMSE "
                 "and bias are of the indirect layer over the reference's mean, FLIP of the "
                 "picture.");
    if (report->flicker.subject_count)
        fprintf(out,
                " Flicker: change of indirect light from frame to frame that the frames of all "
                "VPLs do not have, mean over %d frames.",
                report->flicker_frames);
    fprintf(out, "</p>\n");
}

/* --- pictures --------------------------------------------------------------------------------- */

/* What the ends of the false colours are, of the reference's mean. */
static const double false_colour_top = .25;

static bool print_figure(FILE *out, const struct report *report, const char *name,
                         const struct image *picture, bool is_difference) {
    fprintf(out, "<figure><img alt=\"");
    html_print_text(out, name);
    fprintf(out, "%s\" width=\"%d\" height=\"%d\" src=\"", is_difference ? ", difference" : "",
            report->width, report->height);
    if (!(is_difference
              ? embedded_print_difference(out, picture, &report->reference, false_colour_top)
              : embedded_print_picture(out, picture)))
        return false;
    fprintf(out, "\"><figcaption>");
    html_print_text(out, name);
    fprintf(out, "%s</figcaption></figure>\n", is_difference ? ", difference" : "");
    return true;
}

static bool print_pictures(FILE *out, const struct report *report) {
    fprintf(out, "<h2>Pictures</h2>\n<p class=\"soft\">Differences from the reference: blue is "
                 "darker, red is brighter, by up to a quarter of "
                 "the reference's mean.</p>\n"
                 "<div class=\"pictures\">\n");
    if (!print_figure(out, report, "path-traced reference", &report->reference, false))
        return false;
    fprintf(out, "</div>\n");
    for (int i = 0; i < report->subjects.count; i++) {
        const char *name = subject_of(report, i)->desc.variant;
        fprintf(out, "<div class=\"pictures\">\n");
        if (!print_figure(out, report, name, &report->pictures[i], false) ||
            !print_figure(out, report, name, &report->pictures[i], true))
            return false;
        fprintf(out, "</div>\n");
    }
    return true;
}

/* --- passes ----------------------------------------------------------------------------------- */

static void print_passes_of(FILE *out, const struct report *report, int subject) {
    const struct results *results = &report->results;
    double frame = value_of(report, subject, "frame");
    char *settings = measure_settings(&subject_of(report, subject)->desc);
    fprintf(out, "<details><summary>");
    html_print_text(out, subject_of(report, subject)->desc.variant);
    fprintf(out, "</summary>\n<p class=\"soft\">");
    html_print_text(out, *settings ? settings : "default settings");
    fprintf(out, "</p>\n<div class=\"wide\"><table><tr><th>pass</th><th>ms</th><th>%%</th></tr>\n");
    free(settings);
    for (int i = 0; i < results->row_count; i++) {
        const struct result *row = &results->rows[i];
        if (row->subject != subject || strncmp(row->what, "frame", 5) != 0)
            continue;
        fprintf(out, "<tr><td>");
        html_print_text(out, row->what);
        fprintf(out, "</td><td>%.3f</td><td>%.1f</td></tr>\n", row->figure.value,
                frame > 0 ? 100 * row->figure.value / frame : 0);
    }
    fprintf(out, "</table></div></details>\n");
}

static void print_passes(FILE *out, const struct report *report) {
    fprintf(out, "<h2>Times of passes</h2>\n<p class=\"soft\">Medians of frames with timers, which "
                 "take longer.</p>\n");
    for (int i = 0; i < report->subjects.count; i++)
        print_passes_of(out, report, i);
}

/* --- all -------------------------------------------------------------------------------------- */

static void print_choice(FILE *out, const struct report *report) {
    const struct quality_found *found = &report->found;
    if (report->asked <= 0)
        return;
    char *choice = quality_describe(&found->choice);
    fprintf(out, "<h2>What --max-error %.3g%% chooses</h2>\n<p>", 100 * report->asked);
    html_print_text(out, *choice ? choice : "the default settings");
    fprintf(out, ": its error is estimated as %.1f %%. ", 100 * found->error);
    fprintf(out, found->reached ? "It is the cheapest choice within the limit.</p>\n"
                                : "No choice is within the limit; it is the cheapest of those that "
                                  "nothing errs less than by a tenth.</p>\n");
    free(choice);
}

bool page_print(FILE *out, const struct report *report) {
    fprintf(out,
            "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
            "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n<title>");
    html_print_text(out, report->stage->name);
    fprintf(out, " - manylight report</title>\n<style>\n%s</style></head>\n<body>\n<h1>", style);
    html_print_text(out, report->stage->name);
    fprintf(out, "</h1>\n");
    print_facts(out, report);
    print_chart(out, report);
    print_table(out, report);
    print_choice(out, report);
    if (!print_pictures(out, report))
        return false;
    print_passes(out, report);
    print_machine(out);
    fprintf(out, "</body></html>\n");
    return true;
}
