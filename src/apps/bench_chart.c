#include "apps/bench_chart.h"

#include "apps/bench_csv.h"
#include "base/error.h"
#include "base/memory.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct columns {
    int scene, width, height, series, label, quantity, median, renderer;
};

static bool find_columns(const struct csv *csv, struct columns *c) {
    return csv_find(csv, "scene", &c->scene) && csv_find(csv, "width", &c->width) &&
           csv_find(csv, "height", &c->height) && csv_find(csv, "series", &c->series) &&
           csv_find(csv, "label", &c->label) && csv_find(csv, "quantity", &c->quantity) &&
           csv_find(csv, "median", &c->median) && csv_find(csv, "gl_renderer", &c->renderer);
}

static bool same(const struct csv *csv, int a, int b, int column) {
    return strcmp(csv_cell(csv, a, column), csv_cell(csv, b, column)) == 0;
}

static bool same_case(const struct csv *csv, const struct columns *c, int a, int b) {
    return same(csv, a, b, c->scene) && same(csv, a, b, c->width) && same(csv, a, b, c->height) &&
           same(csv, a, b, c->series) && same(csv, a, b, c->label);
}

/* The clock's time of the case whose error stands in the row; 0 when there is none. */
static double time_of(const struct csv *csv, const struct columns *c, int row) {
    for (int i = 0; i < csv->row_count; i++)
        if (strcmp(csv_cell(csv, i, c->quantity), "wall") == 0 && same_case(csv, c, i, row))
            return atof(csv_cell(csv, i, c->median));
    return 0;
}

/* "vals=8 terms=2" as "M=8 K=2". */
static void shorten(char *label, size_t size, const char *from) {
    static const char *const names[][2] = {{"vpls", "N"}, {"vals", "M"}, {"terms", "K"}};
    char word[40];
    label[0] = '\0';
    for (int length; sscanf(from, "%39s%n", word, &length) == 1; from += length) {
        const char *rest = strchr(word, '='), *name = word;
        for (size_t i = 0; rest && i < sizeof names / sizeof *names; i++)
            if (strncmp(word, names[i][0], (size_t)(rest - word)) == 0 &&
                names[i][0][rest - word] == '\0')
                name = names[i][1];
        size_t used = strlen(label);
        if (used + sizeof word + 2 < size)
            sprintf(label + used, "%s%s%s", used ? " " : "", name, name == word ? "" : rest);
    }
}

static bool is_on_front(const struct plot *plot, const struct plot_point *point) {
    for (int s = 0; s < plot->count; s++)
        for (int i = 0; i < plot->series[s].count; i++) {
            const struct plot_point *other = &plot->series[s].points[i];
            if (other->x <= point->x && other->y <= point->y &&
                (other->x < point->x || other->y < point->y))
                return false;
        }
    return true;
}

static int compare_x(const void *a, const void *b) {
    double x = ((const struct plot_point *)a)->x, y = ((const struct plot_point *)b)->x;
    return (x > y) - (x < y);
}

struct plot_series plot_pareto_front(const struct plot *plot) {
    struct plot_series front = {.name = "Pareto front"};
    for (int s = 0; s < plot->count; s++)
        for (int i = 0; i < plot->series[s].count; i++) {
            if (!is_on_front(plot, &plot->series[s].points[i]))
                continue;
            plot_series_add(&front, &plot->series[s].points[i]);
        }
    if (front.count)
        qsort(front.points, (size_t)front.count, sizeof *front.points, compare_x);
    return front;
}

/* Where a label lies in the chart, both axes over [0, 1]. */
static bool overlaps(const struct plot_point *a, const struct plot_point *b, double decades_x,
                     double decades_y) {
    return fabs(log10(a->x / b->x)) < .11 * decades_x && fabs(log10(a->y / b->y)) < .03 * decades_y;
}

static double decades(const struct plot *plot, bool of_y) {
    double low = INFINITY, high = 0;
    for (int s = 0; s < plot->count; s++)
        for (int i = 0; i < plot->series[s].count; i++) {
            const struct plot_point *point = &plot->series[s].points[i];
            low = fmin(low, of_y ? point->y : point->x);
            high = fmax(high, of_y ? point->y : point->x);
        }
    return log10(1.5 * high / low); /* with the axes' own room */
}

/* Drops labels that would lie on others; those of the front go first. */
static void thin_labels(struct plot *plot) {
    double decades_x = decades(plot, false), decades_y = decades(plot, true);
    struct plot_series kept = {0};
    for (int turn = 0; turn < 2; turn++)
        for (int s = 0; s < plot->count; s++)
            for (int i = 0; i < plot->series[s].count; i++) {
                struct plot_point *point = &plot->series[s].points[i];
                if (is_on_front(plot, point) != (turn == 0))
                    continue;
                for (int k = 0; k < kept.count; k++)
                    if (overlaps(point, &kept.points[k], decades_x, decades_y))
                        point->label[0] = '\0';
                if (point->label[0])
                    plot_series_add(&kept, point);
            }
    free(kept.points);
}

static bool draw_scene(const struct csv *csv, const struct columns *c, int scene_row,
                       const char *folder, bool *drawn) {
    struct plot plot = {.x_label = "time of a frame, ms",
                        .y_label = "relative RMSE of indirect light, %",
                        .log_y = true};
    for (int row = 0; row < csv->row_count; row++) {
        if (!same(csv, row, scene_row, c->scene) ||
            strcmp(csv_cell(csv, row, c->quantity), "relative-rmse") != 0)
            continue;
        struct plot_point point = {.x = time_of(csv, c, row),
                                   .y = 100 * atof(csv_cell(csv, row, c->median))};
        shorten(point.label, sizeof point.label, csv_cell(csv, row, c->label));
        if (point.x > 0 && point.y > 0)
            plot_add(&plot, csv_cell(csv, row, c->series), &point);
    }
    bool ok = true;
    if (plot.count) {
        const char *scene = csv_cell(csv, scene_row, c->scene);
        char *title =
            mem_printf("%s, %sx%s, %s", scene, csv_cell(csv, scene_row, c->width),
                       csv_cell(csv, scene_row, c->height), csv_cell(csv, scene_row, c->renderer));
        char *path = mem_printf("%s/%s", folder, scene);
        plot.title = title;
        plot.emphasis = plot_pareto_front(&plot);
        thin_labels(&plot);
        ok = plot_draw(&plot, path);
        if (ok)
            printf("%s.svg\n%s.png\n", path, path);
        free(path);
        free(title);
        *drawn = true;
    }
    plot_free(&plot);
    return ok;
}

static bool is_first_of_scene(const struct csv *csv, const struct columns *c, int row) {
    for (int i = 0; i < row; i++)
        if (same(csv, i, row, c->scene))
            return false;
    return true;
}

bool bench_chart(const char *csv_path, const char *folder) {
    struct csv csv;
    struct columns columns;
    if (!csv_read(&csv, csv_path))
        return false;
    bool drawn = false;
    bool ok = find_columns(&csv, &columns);
    for (int row = 0; ok && row < csv.row_count; row++)
        if (is_first_of_scene(&csv, &columns, row))
            ok = draw_scene(&csv, &columns, row, folder, &drawn);
    csv_free(&csv);
    if (ok && !drawn)
        ok = error_set("nothing has both a time and an error (bench --sweep ... --reference path)");
    return ok || error_prefix("%s", csv_path);
}
