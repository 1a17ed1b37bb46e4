/* manylight bench passes: how the mean of passes converges. */
#include "lab/bench/bench.h"

#include "lab/measure/errors.h"

#include <math.h>
#include <stdio.h>

static struct measure_desc point_of(const struct measure_desc *desc, int passes) {
    struct measure_desc point = *desc;
    snprintf(point.point, sizeof point.point, "passes=%d", passes);
    return point;
}

/* Adds the mean of the passes so far. */
static bool add_mean(struct results *results, const struct measure_desc *point,
                     struct renderer *renderer, const struct image *reference) {
    struct image mean;
    double noise = 100 * reference_noise(reference);
    if (!renderer_read_layers(renderer, &mean))
        return false;
    results_begin(results, point);
    bool ok = errors_add(results, &mean, reference, reference_names[REFERENCE_PATH]);
    double all = results_value(results, results->subject_count - 1, "relative-rmse", NULL);
    results_add(results, "noise", "", "%", noise);
    results_add(results, "error", reference_names[REFERENCE_PATH], "%",
                sqrt(fmax(all * all - noise * noise, 0)));
    image_free(&mean);
    return ok && results_commit(results);
}

static int passes_subjects(int count) {
    int subjects = 0;
    for (int passes = 1; passes <= count; passes *= 2)
        subjects++;
    return subjects;
}

static bool add_means(struct results *results, const struct measure_desc *desc,
                      struct renderer *renderer, const struct image *reference, int count) {
    int next = 1, subjects = passes_subjects(count), added = 0;
    for (int pass = 1; next <= count; pass++) {
        struct measure_desc point = point_of(desc, next);
        renderer_add_pass(renderer, pass - 1);
        gl.Finish();
        results_tell_work(results, &point, (double)pass / count * subjects - added);
        if (pass < next)
            continue;
        if (!add_mean(results, &point, renderer, reference))
            return false;
        next *= 2;
        added++;
    }
    return true;
}

/* Adds a subject for each power of two up to `count` passes, whose point is "passes=K", with the
 * errors of the mean of K; "noise", the reference's; and "error", the relative RMSE of the indirect
 * layer without that noise, as squares. Error: of the reference or the renderer. */
static bool passes_measure(struct results *results, const struct measure_desc *desc,
                           const struct reference_desc *reference, int count) {
    struct renderer renderer;
    struct image exact;
    if (!reference_get(reference, desc, &exact))
        return false;
    bool ok = measure_start_mean(&renderer, desc);
    if (ok) {
        ok = add_means(results, desc, &renderer, &exact, count);
        renderer_free(&renderer);
    }
    image_free(&exact);
    return ok;
}

static bool measure(struct bench *bench, const struct measure_list *subjects) {
    struct reference_desc reference = bench_reference(bench, REFERENCE_PATH);
    bool ok = true;
    bench_expect(bench, subjects->count * passes_subjects(bench->values.passes));
    for (int i = 0; ok && i < subjects->count; i++)
        ok = passes_measure(&bench->results, &subjects->items[i], &reference, bench->values.passes);
    return ok;
}

const struct bench_mode bench_passes = {
    .name = "passes",
    .help = "error of the mean of 1, 2, 4 ... passes of render --passes\n"
            "Errors are against the path-traced reference; the last column subtracts its squared\n"
            "noise. Without SCENE: the paper's four scenes.",
    .options = "size set variant noise cache light environment passes" BENCH_CONTEXT,
    .measure = measure,
    .tables = {{"the mean of passes", {ERROR_COLUMNS(NULL), {"without noise %", "error", NULL}}}},
};
