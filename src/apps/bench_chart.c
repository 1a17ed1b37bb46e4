#include "apps/bench_chart.h"

#include "apps/bench_csv.h"
#include "base/error.h"
#include "base/memory.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct columns {
    int scene, faces, width, height, series, label, quantity, median, renderer;
};

static bool find_columns(const struct csv *csv, struct columns *c) {
    return csv_find(csv, "scene", &c->scene) && csv_find(csv, "faces", &c->faces) &&
           csv_find(csv, "width", &c->width) && csv_find(csv, "height", &c->height) &&
           csv_find(csv, "series", &c->series) && csv_find(csv, "label", &c->label) &&
           csv_find(csv, "quantity", &c->quantity) && csv_find(csv, "median", &c->median) &&
           csv_find(csv, "gl_renderer", &c->renderer);
}

static bool same(const struct csv *csv, int a, int b, int column) {
    return strcmp(csv_cell(csv, a, column), csv_cell(csv, b, column)) == 0;
}

/* Two scenes may have one name. */
static bool same_scene(const struct csv *csv, const struct columns *c, int a, int b) {
    return same(csv, a, b, c->scene) && same(csv, a, b, c->faces);
}

static bool same_case(const struct csv *csv, const struct columns *c, int a, int b) {
    return same_scene(csv, c, a, b) && same(csv, a, b, c->width) && same(csv, a, b, c->height) &&
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

/* A rectangle of the chart, both axes over [0, 1]. */
struct box {
    double x, y, half_width, half_height;
};

static bool overlap(const struct box *a, const struct box *b) {
    return fabs(a->x - b->x) < a->half_width + b->half_width &&
           fabs(a->y - b->y) < a->half_height + b->half_height;
}

/* The logarithms that an axis goes from and over. */
struct axis {
    double low, length;
};

static struct axis axis_of(const struct plot *plot, bool of_y) {
    double low, high;
    plot_span(plot, of_y, &low, &high);
    return (struct axis){log10(low), log10(high / low)};
}

/* What is drawn so far. */
struct drawing {
    struct axis axes[2];
    struct box *boxes;
    int count;
};

static void drawing_add(struct drawing *drawing, struct box box) {
    drawing->boxes = mem_resize(drawing->boxes, (size_t)drawing->count + 1, sizeof *drawing->boxes);
    drawing->boxes[drawing->count++] = box;
}

/* Half the height of a line and half the width of a letter, as gnuplot's fonts have it here. */
static const double half_line = .016, half_letter = .0062, mark = .009;

static struct box mark_box(const struct drawing *drawing, const struct plot_point *point) {
    const struct axis *x = &drawing->axes[0], *y = &drawing->axes[1];
    return (struct box){(log10(point->x) - x->low) / x->length,
                        (log10(point->y) - y->low) / y->length, mark, mark};
}

static struct box label_box(const struct drawing *drawing, const struct plot_point *point,
                            enum plot_side side) {
    struct box box = mark_box(drawing, point);
    box.half_width = half_letter * (double)strlen(point->label);
    box.half_height = half_line;
    double aside = box.half_width + 1.1 * mark, off = half_line;
    box.x += side == PLOT_RIGHT_ABOVE || side == PLOT_RIGHT_BELOW ? aside : -aside;
    box.y += side == PLOT_RIGHT_ABOVE || side == PLOT_LEFT_ABOVE ? off : -off;
    return box;
}

/* The first side where the label lies on nothing and not beyond the chart's sides; false where
 * there is none. */
static bool place_label(struct drawing *drawing, struct plot_point *point) {
    for (int side = 0; side < PLOT_SIDES; side++) {
        struct box box = label_box(drawing, point, (enum plot_side)side);
        bool is_free = fabs(box.x - .5) + box.half_width < .5;
        for (int i = 0; is_free && i < drawing->count; i++)
            is_free = !overlap(&box, &drawing->boxes[i]);
        if (!is_free)
            continue;
        point->side = (enum plot_side)side;
        drawing_add(drawing, box);
        return true;
    }
    return false;
}

/* Puts labels where they lie on no mark and on no other label, those of the front first; drops them
 * where there is no such place. */
static void place_labels(struct plot *plot) {
    struct drawing drawing = {.axes = {axis_of(plot, false), axis_of(plot, true)}};
    for (int turn = 0; turn < 3; turn++)
        for (int s = 0; s < plot->count; s++)
            for (int i = 0; i < plot->series[s].count; i++) {
                struct plot_point *point = &plot->series[s].points[i];
                if (turn == 0)
                    drawing_add(&drawing, mark_box(&drawing, point));
                else if (is_on_front(plot, point) == (turn == 1) && point->label[0] &&
                         !place_label(&drawing, point))
                    point->label[0] = '\0';
            }
    free(drawing.boxes);
}

/* Of a scene's chart, without the ending; to be freed. Any but the first of a name tell their faces
 * too. */
static char *chart_path(const struct csv *csv, const struct columns *c, int scene_row,
                        const char *folder) {
    const char *scene = csv_cell(csv, scene_row, c->scene);
    for (int i = 0; i < scene_row; i++)
        if (same(csv, i, scene_row, c->scene))
            return mem_printf("%s/%s-%s", folder, scene, csv_cell(csv, scene_row, c->faces));
    return mem_printf("%s/%s", folder, scene);
}

static bool draw_scene(const struct csv *csv, const struct columns *c, int scene_row,
                       const char *folder, bool *drawn) {
    struct plot plot = {.x_label = "time of a frame, ms",
                        .y_label = "relative RMSE of indirect light, %",
                        .log_y = true};
    for (int row = 0; row < csv->row_count; row++) {
        if (!same_scene(csv, c, row, scene_row) ||
            strcmp(csv_cell(csv, row, c->quantity), "relative-rmse") != 0)
            continue;
        struct plot_point point = {.x = time_of(csv, c, row),
                                   .y = 100 * atof(csv_cell(csv, row, c->median))};
        const char *series = csv_cell(csv, row, c->series), *label = csv_cell(csv, row, c->label);
        shorten(point.label, sizeof point.label, label[0] ? label : series);
        if (point.x > 0 && point.y > 0)
            plot_add(&plot, series, &point);
    }
    bool ok = true;
    if (plot.count) {
        char *title =
            mem_printf("%s (%s faces), %sx%s, %s", csv_cell(csv, scene_row, c->scene),
                       csv_cell(csv, scene_row, c->faces), csv_cell(csv, scene_row, c->width),
                       csv_cell(csv, scene_row, c->height), csv_cell(csv, scene_row, c->renderer));
        char *path = chart_path(csv, c, scene_row, folder);
        plot.title = title;
        plot.emphasis = plot_pareto_front(&plot);
        place_labels(&plot);
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
        if (same_scene(csv, c, i, row))
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
