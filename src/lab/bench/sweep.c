/* manylight bench sweep: times and errors of variants over a grid of settings. */
#include "lab/bench/bench.h"

#include "lab/measure/errors.h"
#include "lab/measure/baseline.h"
#include "base/error.h"

static bool measure(struct bench *bench, const struct measure_list *subjects) {
    enum reference_kind kind = (enum reference_kind)bench->values.reference;
    bench_expect(bench, subjects->count + (bench->values.tracer ? BASELINE_SUBJECTS : 0));
    if (!bench->values.tracer)
        return bench_time(bench, subjects, kind);
    if (kind == REFERENCE_SEEN || kind == REFERENCE_AO)
        return error_set("--tracer has indirect light alone to compare, not --reference %s",
                         reference_names[kind]);
    if (kind == REFERENCE_NONE)
        kind = REFERENCE_PATH;
    struct reference_desc reference = bench_reference(bench, kind);
    return baseline_measure(&bench->results, subjects->items, &reference, reference_names[kind]) &&
           bench_time(bench, subjects, kind);
}

const struct bench_mode bench_sweep = {
    .name = "sweep",
    .help =
        "times and errors over a grid of settings\n"
        "Measures each variant at each point of the grid, and its errors against the reference,\n"
        "if any. Without SCENE: the paper's four scenes, from scenes/ here or the installed ones.",
    .options =
        "vary size variant set light frames warm-up reference tracer noise cache" BENCH_CONTEXT,
    .variants = bench_variants,
    .measure = measure,
    .tables = {{"times and errors",
                {{"ms", "clock", NULL}, {"CPU ms", "cpu", NULL}, ERROR_COLUMNS(NULL)}},
               {"CPU time of the denoised tracer over a technique's, where both err alike",
                {{"by rRMSE", "baseline-at-rmse", NULL}, {"by FLIP", "baseline-at-flip", NULL}}}},
};
