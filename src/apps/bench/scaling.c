/* manylight bench scaling: how the time of a frame grows with pixels, N, M and faces: slopes of log
 * time over log size, 1 where the cost is in proportion and 0 where there is none. */
#include "apps/bench/bench.h"

#include "base/memory.h"
#include "measure/summary.h"

#include <stdlib.h>
#include <string.h>

/* What grows; pixels by doubling the side twice. */
static const struct axis {
    const char *name, *key, *values;
} axes[] = {{"pixels", "size=", NULL}, {"N", "vpls=", "256,1024,4096"}, {"M", "vals=", "8,30,120"}};

enum { AXES = sizeof axes / sizeof *axes };

static bool parse_axis(const struct bench *bench, const struct axis *axis, struct sweep *sweep) {
    int w = bench->values.size[0], h = bench->values.size[1];
    char sizes[96], text[128];
    snprintf(sizes, sizeof sizes, "%dx%d,%dx%d,%dx%d", (w + 3) / 4, (h + 3) / 4, (w + 1) / 2,
             (h + 1) / 2, w, h);
    snprintf(text, sizeof text, "%s%s", axis->key, axis->values ? axis->values : sizes);
    *sweep = (struct sweep){0};
    return sweep_parse(sweep, text);
}

static bool is_on(const struct subject *subject, const char *key) {
    return strncmp(subject->desc.point, key, strlen(key)) == 0;
}

static double size_of(const struct subject *subject, bool of_faces) {
    return of_faces                  ? subject->faces
           : is_on(subject, "size=") ? measure_pixels(&subject->desc)
                                     : atof(strchr(subject->desc.point, '=') + 1);
}

/* Whether a subject belongs to the growth that another one begins: of its variant; along one key in
 * its scene, or over all scenes at its point. */
static bool belongs(const struct subject *subject, const struct subject *first, const char *key) {
    return strcmp(subject->desc.variant, first->desc.variant) == 0 &&
           (key ? is_on(subject, key) && strcmp(subject->scene, first->scene) == 0
                : strcmp(subject->desc.point, first->desc.point) == 0);
}

/* key NULL: over faces. */
static void print_growth(const struct results *results, int first, const char *name,
                         const char *key) {
    const struct subject *begin = &results->subjects[first];
    double *x = mem_alloc(2 * (size_t)results->subject_count, sizeof *x);
    double *ms = x + results->subject_count;
    int count = 0;
    for (int i = first; i < results->subject_count; i++)
        if (belongs(&results->subjects[i], begin, key)) {
            x[count] = size_of(&results->subjects[i], !key);
            ms[count++] = results_value(results, i, "clock", NULL);
        }
    printf("  %-16s %-18s %-8s slope %5.2f :", key ? begin->scene : "all scenes",
           begin->desc.variant, name, log_slope(x, ms, count));
    for (int i = 0; i < count; i++)
        printf("  %g: %.4g ms", x[i], ms[i]);
    printf("\n");
    free(x);
}

static bool measure_axis(struct bench *bench, const struct stage *stage, const struct axis *axis) {
    struct sweep sweep;
    int count = 0, first = bench->results.subject_count;
    bool ok = parse_axis(bench, axis, &sweep);
    struct measure_desc *descs =
        ok ? bench_list(bench, stage, &sweep, bench_usual_variants, &count) : NULL;
    ok = descs && bench_time(bench, descs, count, TRUTH_NONE);
    for (int i = 0; ok && i < count; i += sweep.count)
        print_growth(&bench->results, first + i, axis->name, axis->key);
    free(descs);
    sweep_free(&sweep);
    return ok;
}

static bool measure(struct bench *bench, const struct measure_desc *descs, int count) {
    (void)count;
    bool ok = true;
    for (int i = 0; ok && i < AXES; i++)
        ok = measure_axis(bench, descs->stage, &axes[i]);
    return ok;
}

/* Over faces at full size. */
static bool finish(struct bench *bench) {
    const struct results *results = &bench->results;
    for (int i = 0; i < results->subject_count; i++)
        if (strcmp(results->subjects[i].scene, results->subjects[0].scene) == 0 &&
            is_on(&results->subjects[i], "size=") &&
            results->subjects[i].desc.width == bench->values.size[0])
            print_growth(results, i, "faces", NULL);
    return true;
}

static const struct option options[] = {
    BENCH_SIZE(800), BENCH_VARIANTS, BENCH_SETTINGS, BENCH_FRAMES, BENCH_CSV, BENCH_CONTEXT, {NULL},
};

const struct bench_mode bench_scaling = {
    .name = "scaling",
    .help = "how the time grows with pixels, N, M and faces",
    .synopsis = "[SCENE ...] [OPTION ...]",
    .summary =
        "Measures how the time of a frame grows with pixels, N, M and, over the scenes, with\n"
        "faces: slopes of log time over log size. Without SCENE: the paper's four scenes.",
    .options = options,
    .usual = bench_usual_variants,
    .measure = measure,
    .finish = finish,
};
