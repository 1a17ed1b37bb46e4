/* manylight bench scaling: how the time of a frame grows with pixels, N, M and faces: slopes of log
 * time over log size, 1 where the cost is in proportion and 0 where there is none. */
#include "lab/bench/bench.h"

#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

/* What grows; pixels by doubling the side twice. */
static const struct axis {
    const char *name, *values;
} axes[] = {{"pixels", NULL}, {"N", "vpls=256,1024,4096"}, {"M", "vals=8,30,120"}};

enum { AXES = sizeof axes / sizeof *axes, SIZES = 3 /* of each */ };

static double size_of(const struct subject *subject, const char *of) {
    return strcmp(of, "faces") == 0    ? subject->faces
           : strcmp(of, "pixels") == 0 ? measure_pixels(&subject->desc)
                                       : atof(strchr(subject->desc.point, '=') + 1);
}

/* Of count subjects, each so many after the one before. */
static void print_growth(const struct results *results, int first, int step, int count,
                         const char *of, const char *where) {
    double *x = mem_alloc(2 * (size_t)count, sizeof *x), *ms = x + count;
    for (int i = 0; i < count; i++) {
        x[i] = size_of(&results->subjects[first + i * step], of);
        ms[i] = results_value(results, first + i * step, "clock", NULL);
    }
    printf("  %-16s %-18s %-8s slope %5.2f :", where, results->subjects[first].desc.variant, of,
           log_slope(x, ms, count));
    for (int i = 0; i < count; i++)
        printf("  %g: %.4g ms", x[i], ms[i]);
    printf("\n");
    free(x);
}

static bool measure_axis(struct bench *bench, const struct axis *axis) {
    int w = bench->values.size[0], h = bench->values.size[1], first = bench->results.subject_count;
    char sizes[128];
    struct measure_list subjects;
    snprintf(sizes, sizeof sizes, "size=%dx%d,%dx%d,%dx%d", (w + 3) / 4, (h + 3) / 4, (w + 1) / 2,
             (h + 1) / 2, w, h);
    bool ok = bench_list(bench, bench_variants, axis->values ? axis->values : sizes, &subjects) &&
              bench_time(bench, &subjects, REFERENCE_NONE);
    for (int i = 0; ok && i < subjects.count; i += SIZES)
        print_growth(&bench->results, first + i, 1, SIZES, axis->name, bench->stage->name);
    free(subjects.items);
    return ok;
}

static bool measure(struct bench *bench, const struct measure_list *subjects) {
    int variants = subjects->count;
    bool ok = true;
    bench_expect(bench, AXES * SIZES * variants);
    for (int i = 0; ok && i < AXES; i++)
        ok = measure_axis(bench, &axes[i]);
    return ok;
}

/* Over faces: the last size of pixels of each variant, at the same place in each scene's subjects. */
static bool finish(struct bench *bench) {
    const struct results *results = &bench->results;
    int per_scene = results->subject_count / bench->argument_count;
    for (int i = SIZES - 1; i < per_scene / AXES; i += SIZES)
        print_growth(results, i, per_scene, bench->argument_count, "faces", "all scenes");
    return true;
}

const struct bench_mode bench_scaling = {
    .name = "scaling",
    .help =
        "growth of a frame's time with pixels, N, M and faces\n"
        "Prints slopes of log time over log size; for faces over all scenes. Without SCENE: the\n"
        "paper's four scenes.",
    .options = "size variant set frames warm-up" BENCH_CONTEXT,
    .variants = bench_variants,
    .measure = measure,
    .finish = finish,
};
