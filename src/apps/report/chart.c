#include "apps/report/chart.h"

#include "apps/report/html.h"
#include "base/memory.h"

#include <math.h>
#include <stdlib.h>

/* Units of the drawing; the browser scales it. */
static const double width = 760, height = 420, left = 64, right = 190, top = 16, bottom = 48;

/* One axis: from and to are powers of ten or 2 or 5 times these. */
struct axis {
    double from, to;
};

static double step_below(double value) {
    double power = pow(10, floor(log10(value))), digit = value / power;
    return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

static double step_after(double step) {
    double power = pow(10, floor(log10(step) + 1e-9)), digit = step / power;
    return power * (digit < 1.5 ? 2 : digit < 3 ? 5 : 10);
}

static void axis_take(struct axis *axis, double value) {
    if (!(value > 0 && isfinite(value)))
        return;
    axis->from = axis->from > 0 ? fmin(axis->from, value) : value;
    axis->to = fmax(axis->to, value);
}

static void axis_round(struct axis *axis) {
    if (!(axis->from > 0))
        *axis = (struct axis){1, 10};
    axis->from = step_below(axis->from * .9);
    axis->to = step_after(step_below(axis->to * 1.05));
}

static double share_of(const struct axis *axis, double value) {
    return log(value / axis->from) / log(axis->to / axis->from);
}

static double x_of(const struct axis *axis, double value) {
    return left + (width - left - right) * share_of(axis, value);
}

static double y_of(const struct axis *axis, double value) {
    return height - bottom - (height - top - bottom) * share_of(axis, value);
}

static void print_axes(FILE *out, const struct chart *chart, const struct axis *x,
                       const struct axis *y) {
    for (double at = x->from; at <= x->to * 1.001; at = step_after(at))
        fprintf(out,
                "<path class=\"grid\" d=\"M%.1f %.1fV%.1f\"/><text class=\"tick\" x=\"%.1f\" "
                "y=\"%.1f\" text-anchor=\"middle\">%g</text>\n",
                x_of(x, at), top, height - bottom, x_of(x, at), height - bottom + 18, at);
    for (double at = y->from; at <= y->to * 1.001; at = step_after(at))
        fprintf(out,
                "<path class=\"grid\" d=\"M%.1f %.1fH%.1f\"/><text class=\"tick\" x=\"%.1f\" "
                "y=\"%.1f\" text-anchor=\"end\">%g</text>\n",
                left, y_of(y, at), width - right, left - 6, y_of(y, at) + 4, at);
    fprintf(out,
            "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\">%s</text>\n"
            "<text transform=\"translate(16 %.1f) rotate(-90)\" text-anchor=\"middle\">%s</text>\n",
            (left + width - right) / 2, height - 10, chart->x_title, (top + height - bottom) / 2,
            chart->y_title);
}

struct label {
    const struct chart_point *point;
    double y;
};

static int compare_labels(const void *a, const void *b) {
    double x = ((const struct label *)a)->y, y = ((const struct label *)b)->y;
    return (x > y) - (x < y);
}

/* Names stand in a column on the right, in the order of their points, none over another. */
static void print_points(FILE *out, const struct chart *chart, const struct axis *x,
                         const struct axis *y) {
    const double line = 17;
    struct label *labels = mem_alloc((size_t)chart->count, sizeof *labels);
    for (int i = 0; i < chart->count; i++)
        labels[i] = (struct label){&chart->points[i], y_of(y, chart->points[i].y)};
    qsort(labels, (size_t)chart->count, sizeof *labels, compare_labels);
    double low = top + 8;
    for (int i = 0; i < chart->count; i++)
        low = labels[i].y = fmax(labels[i].y, low + (i ? line : 0));
    double over = low - (height - bottom);
    for (int i = chart->count - 1; over > 0 && i >= 0; i--) {
        double most = i + 1 < chart->count ? labels[i + 1].y - line : height - bottom;
        labels[i].y = fmin(labels[i].y, most);
    }
    for (int i = 0; i < chart->count; i++) {
        const struct chart_point *point = labels[i].point;
        double px = x_of(x, point->x), py = y_of(y, point->y), text_x = width - right + 14;
        fprintf(out,
                "<g class=\"point\"><path d=\"M%.1f %.1fL%.1f %.1f\"/><circle cx=\"%.1f\" "
                "cy=\"%.1f\" r=\"5\"><title>",
                px, py, text_x - 3, labels[i].y, px, py);
        html_print_text(out, point->name);
        fprintf(out, ": ");
        html_print_number(out, point->x);
        fprintf(out, ", %.4g</title></circle><text x=\"%.1f\" y=\"%.1f\">", point->y, text_x,
                labels[i].y + 4);
        html_print_text(out, point->name);
        fprintf(out, "</text></g>\n");
    }
    free(labels);
}

void chart_print(FILE *out, const struct chart *chart) {
    struct axis x = {0}, y = {0};
    for (int i = 0; i < chart->count; i++) {
        axis_take(&x, chart->points[i].x);
        axis_take(&y, chart->points[i].y);
    }
    axis_take(&y, chart->floor);
    axis_round(&x);
    axis_round(&y);
    fprintf(out, "<svg viewBox=\"0 0 %g %g\" role=\"img\" aria-label=\"%s against %s\">\n", width,
            height, chart->y_title, chart->x_title);
    print_axes(out, chart, &x, &y);
    if (chart->floor > 0)
        fprintf(out,
                "<path class=\"floor\" d=\"M%.1f %.1fH%.1f\"><title>noise of the reference: "
                "%.3g</title></path>\n",
                left, y_of(&y, chart->floor), width - right, chart->floor);
    print_points(out, chart, &x, &y);
    fprintf(out, "</svg>\n");
}
