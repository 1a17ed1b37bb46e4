#define _POSIX_C_SOURCE 200809L
#include "apps/bench_plot.h"

#include "base/error.h"
#include "base/folder.h"
#include "base/memory.h"
#include "base/output_file.h"
#include "base/text.h"

#include <errno.h>
#include <float.h>
#include <math.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

/* Filled and open marks in turn, from dark to light and to dark again. */
static const struct style {
    int mark, dash;
    const char *color;
} styles[] = {
    {7, 1, "#1b3a6b"},  {4, 2, "#b5341b"},  {9, 3, "#2f7d4f"},  {12, 4, "#7a4fa3"},
    {5, 5, "#8a6d1a"},  {6, 1, "#1f8a99"},  {11, 2, "#a33a77"}, {8, 3, "#555555"},
    {13, 4, "#4f6bd1"}, {10, 5, "#c77d2e"},
};

enum { STYLE_COUNT = sizeof styles / sizeof *styles };

void plot_series_add(struct plot_series *series, const struct plot_point *point) {
    series->points = mem_resize(series->points, (size_t)series->count + 1, sizeof *series->points);
    series->points[series->count++] = *point;
}

void plot_add(struct plot *plot, const char *series, const struct plot_point *point) {
    for (int i = 0; i < plot->count; i++)
        if (strcmp(plot->series[i].name, series) == 0) {
            plot_series_add(&plot->series[i], point);
            return;
        }
    plot->series = mem_resize(plot->series, (size_t)plot->count + 1, sizeof *plot->series);
    struct plot_series *added = &plot->series[plot->count++];
    *added = (struct plot_series){0};
    snprintf(added->name, sizeof added->name, "%s", series);
    plot_series_add(added, point);
}

void plot_free(struct plot *plot) {
    for (int i = 0; i < plot->count; i++)
        free(plot->series[i].points);
    free(plot->series);
    free(plot->emphasis.points);
    *plot = (struct plot){0};
}

int plot_log_ticks(double low, double high, double *ticks, int count) {
    static const double fine[] = {1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8}, coarse[] = {1, 2, 5};
    bool is_fine = high < 20 * low;
    const double *steps = is_fine ? fine : coarse;
    int step_count = is_fine ? 10 : 3, used = 0;
    for (int decade = (int)floor(log10(low)); pow(10, decade) <= high; decade++)
        for (int i = 0; i < step_count; i++) {
            double tick = steps[i] * pow(10, decade);
            if (tick >= low && tick <= high && used < count)
                ticks[used++] = tick;
        }
    return used;
}

/* In double quotes for gnuplot. */
static void print_quoted(FILE *out, const char *text) {
    fputc('"', out);
    for (; *text; text++)
        fprintf(out, *text == '"' || *text == '\\' ? "\\%c" : "%c", *text);
    fputc('"', out);
}

/* Axes go beyond the values by this factor. */
static const double room = 1.25;

void plot_span(const struct plot *plot, bool of_y, double *low, double *high) {
    *low = DBL_MAX, *high = 0;
    for (int s = 0; s < plot->count; s++)
        for (int i = 0; i < plot->series[s].count; i++) {
            const struct plot_point *point = &plot->series[s].points[i];
            double value = of_y ? point->y : point->x;
            *low = value < *low ? value : *low;
            *high = value > *high ? value : *high;
        }
    *low /= room, *high *= room;
}

static void print_log_axis(FILE *out, const struct plot *plot, char axis) {
    double low, high, ticks[40];
    plot_span(plot, axis == 'y', &low, &high);
    int count = plot_log_ticks(low, high, ticks, 40);
    fprintf(out, "set logscale %c\nset %crange [%g:%g]\nset %ctics (", axis, axis, low, high, axis);
    for (int i = 0; i < count; i++)
        fprintf(out, "%s\"%g\" %g", i ? ", " : "", ticks[i], ticks[i]);
    fprintf(out, ")\n");
}

static void print_labels(FILE *out, const struct plot *plot) {
    static const char *const places[PLOT_SIDES] = {
        [PLOT_RIGHT_ABOVE] = "left offset 0.8,0.6",
        [PLOT_LEFT_BELOW] = "right offset -0.8,-0.6",
        [PLOT_RIGHT_BELOW] = "left offset 0.8,-0.6",
        [PLOT_LEFT_ABOVE] = "right offset -0.8,0.6",
    };
    for (int s = 0; s < plot->count; s++)
        for (int i = 0; i < plot->series[s].count; i++) {
            const struct plot_point *point = &plot->series[s].points[i];
            if (!point->label[0])
                continue;
            fprintf(out, "set label ");
            print_quoted(out, point->label);
            fprintf(out, " at %.9g,%.9g %s font ',9' front\n", point->x, point->y,
                    places[point->side]);
        }
}

static void print_data(FILE *out, const char *name, const struct plot_series *series) {
    fprintf(out, "$%s << EOD\n", name);
    for (int i = 0; i < series->count; i++)
        fprintf(out, "%.9g %.9g\n", series->points[i].x, series->points[i].y);
    fprintf(out, "EOD\n");
}

static void print_curves(FILE *out, const struct plot *plot) {
    fprintf(out, "plot \\\n");
    if (plot->emphasis.count) {
        fprintf(out, "  $front with steps lc rgb '#bbbbbb' lw 4 title ");
        print_quoted(out, plot->emphasis.name);
        fprintf(out,
                ", \\\n  $front with points pt 6 ps 2.6 lw 1.5 lc rgb '#777777' notitle, \\\n");
    }
    for (int i = 0; i < plot->count; i++) {
        const struct style *style = &styles[i % STYLE_COUNT];
        fprintf(out, "  $s%d with linespoints lc rgb '%s' pt %d ps 1.1 dt %d lw 1.3 title ", i,
                style->color, style->mark, style->dash);
        print_quoted(out, plot->series[i].name);
        fprintf(out, i + 1 < plot->count ? ", \\\n" : "\n");
    }
}

/* To stdout: the file is ours to write. */
static void print_script(FILE *out, const struct plot *plot, const char *terminal) {
    fprintf(out, "set encoding utf8\nset key outside right top vertical Left reverse noenhanced\n"
                 "set grid lc rgb '#dddddd'\nset border lc rgb '#444444'\n");
    fprintf(out, "set title noenhanced ");
    print_quoted(out, plot->title);
    fprintf(out, "\nset xlabel ");
    print_quoted(out, plot->x_label);
    fprintf(out, "\nset ylabel ");
    print_quoted(out, plot->y_label);
    fprintf(out, "\n");
    if (!plot->linear_x)
        print_log_axis(out, plot, 'x');
    if (plot->log_y)
        print_log_axis(out, plot, 'y');
    for (int i = 0; i < plot->count; i++) {
        char name[16];
        snprintf(name, sizeof name, "s%d", i);
        print_data(out, name, &plot->series[i]);
    }
    if (plot->emphasis.count)
        print_data(out, "front", &plot->emphasis);
    print_labels(out, plot);
    fprintf(out, "set terminal %s\n", terminal);
    print_curves(out, plot);
}

/* Starts gnuplot on the script. Where what it draws comes out, or -1 after an error. */
static int start_gnuplot(char *script, pid_t *child) {
    char program[] = "gnuplot";
    char *arguments[] = {program, script, NULL};
    int ends[2];
    posix_spawn_file_actions_t actions;
    if (pipe(ends) != 0) {
        error_set("cannot run gnuplot: %s", strerror(errno));
        return -1;
    }
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addclose(&actions, ends[0]);
    int failure = posix_spawnp(child, program, &actions, NULL, arguments, environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    if (!failure)
        return ends[0];
    close(ends[0]);
    error_set("cannot run gnuplot: %s", strerror(failure));
    return -1;
}

static bool run_gnuplot(char *script, struct text *picture) {
    pid_t child;
    int status, drawing = start_gnuplot(script, &child);
    char chunk[1 << 14];
    if (drawing < 0)
        return false;
    for (ssize_t got; (got = read(drawing, chunk, sizeof chunk)) > 0;)
        text_append(picture, chunk, (size_t)got);
    close(drawing);
    waitpid(child, &status, 0);
    return (WIFEXITED(status) && WEXITSTATUS(status) == 0) || error_set("gnuplot failed");
}

static bool draw_as(const struct plot *plot, const char *path, char *script, const char *terminal) {
    struct output_text lines;
    struct text picture = {0};
    output_text_init(&lines);
    print_script(lines.stream, plot, terminal);
    bool ok = output_text_end(&lines, script) && run_gnuplot(script, &picture) &&
              output_file_write(path, picture.data, picture.length);
    remove(script);
    free(picture.data);
    return ok;
}

bool plot_draw(const struct plot *plot, const char *path) {
    static const char *const terminals[][2] = {
        {"svg size 900,560 font 'DejaVu Sans,11' background 'white' noenhanced", "svg"},
        {"pngcairo size 1350,840 fontscale 1.3 font 'DejaVu Sans,11' noenhanced", "png"},
    };
    char *script = mem_printf("%s.gnuplot", path);
    bool ok = folder_make_for(script);
    for (int i = 0; ok && i < 2; i++) {
        char *file = mem_printf("%s.%s", path, terminals[i][1]);
        ok = draw_as(plot, file, script, terminals[i][0]);
        free(file);
    }
    free(script);
    return ok;
}
