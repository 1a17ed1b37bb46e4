/* How the time of a frame grows with pixels, N, M and faces: slopes of log time over log size, 1
 * where the cost is in proportion and 0 where there is none. */
#include "apps/bench.h"

#include "apps/bench_machine.h"
#include "apps/bench_rows.h"
#include "base/log.h"
#include "base/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS_MAX = 64 };

struct growth {
    const char *name;
    double x[POINTS_MAX], ms[POINTS_MAX];
    int count;
};

double bench_log_slope(const double *x, const double *y, int count) {
    double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
    for (int i = 0; i < count; i++) {
        mean_x += log(x[i]) / count;
        mean_y += log(y[i]) / count;
    }
    for (int i = 0; i < count; i++) {
        xx += pow(log(x[i]) - mean_x, 2);
        xy += (log(x[i]) - mean_x) * (log(y[i]) - mean_y);
    }
    return xx > 0 ? xy / xx : 0;
}

static void add(struct growth *growth, double x, const struct bench_case *measured) {
    if (growth->count == POINTS_MAX)
        return;
    growth->x[growth->count] = x;
    growth->ms[growth->count++] = measured->wall_ms.median;
}

static void print_growth(const struct growth *growth, const char *scene, const char *series) {
    printf("  %-16s %-18s %-8s slope %5.2f :", scene, series, growth->name,
           bench_log_slope(growth->x, growth->ms, growth->count));
    for (int i = 0; i < growth->count; i++)
        printf("  %g: %.4g ms", growth->x[i], growth->ms[i]);
    printf("\n");
}

/* The grids of one axis each; pixels by halving the side twice. */
static bool parse_axes(const struct bench_values *values, struct sweep axes[3]) {
    char sizes[128];
    int w = values->size[0], h = values->size[1];
    snprintf(sizes, sizeof sizes, "size=%dx%d,%dx%d,%dx%d", (w + 3) / 4, (h + 3) / 4, (w + 1) / 2,
             (h + 1) / 2, w, h);
    memset(axes, 0, 3 * sizeof *axes);
    return sweep_parse(&axes[0], sizes) && sweep_parse(&axes[1], "vpls=256,1024,4096") &&
           sweep_parse(&axes[2], "vals=8,30,120");
}

static double size_of(int axis, const struct bench_case *c) {
    return axis == 0   ? (double)c->width * c->height
           : axis == 1 ? (int)settings_number(&c->settings, "vpls")
                       : (int)settings_number(&c->settings, "vals");
}

/* Prints the growth of each series of a scene's cases, of one axis. */
static void print_axis(int axis, const struct bench_case *cases, int count) {
    static const char *const names[] = {"pixels", "N", "M"};
    for (int i = 0; i < count;) {
        struct growth growth = {.name = names[axis]};
        int first = i;
        for (; i < count && strcmp(cases[i].series, cases[first].series) == 0; i++)
            add(&growth, size_of(axis, &cases[i]), &cases[i]);
        print_growth(&growth, cases[first].scene, cases[first].series);
    }
}

static bool measure_scene(struct bench_cases *all, const struct bench_values *values,
                          const char *path, const struct sweep axes[3], bool software) {
    struct stage stage;
    struct bench_protocol protocol = bench_choose_protocol(values, software);
    if (!stage_init(&stage, &(struct stage_desc){.path = path}))
        return false;
    log_note("%s", stage.name);
    bool ok = true;
    for (int axis = 0; ok && axis < 3; axis++) {
        int first = all->count;
        ok = bench_list_cases(all, values, &stage, &axes[axis]);
        int count = all->count - first;
        ok = ok && bench_measure_groups(&all->items[first], count, &stage, &protocol);
        if (ok)
            print_axis(axis, &all->items[first], count);
    }
    stage_free(&stage);
    return ok;
}

/* Over the scenes, at full size: the last case of each scene and series on the axis of pixels. */
static void print_faces(const struct bench_cases *all, const struct bench_values *values) {
    for (int i = 0; i < all->count && strcmp(all->items[i].scene, all->items[0].scene) == 0; i++) {
        const struct bench_case *base = &all->items[i];
        struct growth growth = {.name = "faces"};
        if (strncmp(base->label, "size=", 5) != 0 || base->width != values->size[0])
            continue;
        for (int k = 0; k < all->count; k++)
            if (strcmp(all->items[k].series, base->series) == 0 &&
                strcmp(all->items[k].label, base->label) == 0)
                add(&growth, all->items[k].faces, &all->items[k]);
        print_growth(&growth, "all scenes", base->series);
    }
}

bool bench_scaling(const struct bench_values *values, const char **scenes, int scene_count,
                   bool software) {
    struct bench_cases all = {0};
    struct bench_machine machine;
    struct sweep axes[3];
    bench_machine_read(&machine, software);
    bool ok = parse_axes(values, axes);
    for (int i = 0; ok && i < scene_count; i++)
        ok = measure_scene(&all, values, scenes[i], axes, software);
    if (ok)
        print_faces(&all, values);
    ok = ok && (!values->csv || bench_write_csv(values->csv, all.items, all.count, &machine)) &&
         (!values->json || bench_write_json(values->json, all.items, all.count, &machine));
    free(all.items);
    return ok;
}
