/* manylight bench quality: whether --max-error is right, and as cheap as it can be. */
#include "apps/bench/bench.h"

#include "apps/bench/measure/quality_check.h"
#include "apps/bench/measure/rival.h"
#include "base/file/image_file.h"

static bool check(struct bench *bench, const struct measure_desc *measure) {
    const struct bench_values *values = &bench->values;
    struct truth_desc desc = bench_truth(bench, TRUTH_PATH);
    struct image truth;
    bool ok = values->truth ? image_read(&truth, values->truth) : truth_get(&desc, measure, &truth);
    if (!ok)
        return false;
    struct quality_check_desc checked = {measure, values->settings.items, values->settings.count,
                                         &truth,  values->passes,         values->told};
    bench_expect(bench, quality_check_subjects(&checked) + (values->tracer ? RIVAL_SUBJECTS : 0));
    ok = quality_check(&bench->results, &checked);
    image_free(&truth);
    return ok;
}

static bool measure(struct bench *bench, const struct measure_list *subjects) {
    struct truth_desc truth = bench_truth(bench, TRUTH_PATH);
    bool ok = true;
    for (int i = 0; ok && i < subjects->count; i++)
        ok = check(bench, &subjects->items[i]) &&
             (!bench->values.tracer ||
              rival_measure(&bench->results, &subjects->items[i], &truth, truth_names[truth.kind]));
    return ok;
}

const struct bench_mode bench_quality = {
    .name = "quality",
    .help =
        "render --max-error: estimated against measured errors, times against the fastest\n"
        "Draws each choice of --max-error, and fixed settings for comparison. Then prints for 2,\n"
        "4, 8, 16 and 30 %: the choice, its estimated error, its error without the noise of the\n"
        "reference, that error over the limit, and its CPU time over that of the fastest choice\n"
        "within the limit. Without SCENE: the paper's four scenes.",
    .options = "size set camera light noise cache passes told truth tracer" BENCH_CONTEXT,
    .measure = measure,
    .tables = {{"--max-error",
                {{"told %", "told", NULL},
                 {"error %", "error", NULL},
                 {"of asked", "of-asked", NULL},
                 {"CPU ms", "cpu", NULL},
                 {"of fastest", "of-fastest", NULL}}}},
};
