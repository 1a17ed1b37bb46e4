/* manylight bench quality: whether --max-error is right, and as cheap as it can be. */
#include "lab/bench/bench.h"

#include "lab/measure/quality_check.h"
#include "lab/measure/baseline.h"
#include "base/file/image_file.h"

static bool check(struct bench *bench, const struct measure_desc *measure) {
    const struct bench_values *values = &bench->values;
    struct reference_desc desc = bench_reference(bench, REFERENCE_PATH);
    struct image reference;
    bool ok = values->reference_file ? image_read(&reference, values->reference_file)
                                     : reference_get(&desc, measure, &reference);
    if (!ok)
        return false;
    struct quality_check_desc checked = {measure,    values->settings.items, values->settings.count,
                                         &reference, values->passes,         values->estimates};
    bench_expect(bench,
                 quality_check_subjects(&checked) + (values->tracer ? BASELINE_SUBJECTS : 0));
    ok = quality_check(&bench->results, &checked);
    image_free(&reference);
    return ok;
}

static bool measure(struct bench *bench, const struct measure_list *subjects) {
    struct reference_desc reference = bench_reference(bench, REFERENCE_PATH);
    bool ok = true;
    for (int i = 0; ok && i < subjects->count; i++)
        ok = check(bench, &subjects->items[i]) &&
             (!bench->values.tracer ||
              baseline_measure(&bench->results, &subjects->items[i], &reference,
                               reference_names[reference.kind]));
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
    .options =
        "size set camera light noise cache passes estimates reference-file tracer" BENCH_CONTEXT,
    .measure = measure,
    .tables = {{"--max-error",
                {{"estimated %", "told", NULL},
                 {"error %", "error", NULL},
                 {"of asked", "of-asked", NULL},
                 {"CPU ms", "cpu", NULL},
                 {"of fastest", "of-fastest", NULL}}}},
};
