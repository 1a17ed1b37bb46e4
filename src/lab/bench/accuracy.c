/* manylight bench budget, curves: the error of the frame, step by step on the way from the
 * reference, and against M, K, N and the size of maps. */
#include "lab/bench/bench.h"

#include "lab/measure/accuracy.h"
#include "lab/measure/errors.h"
#include "lab/measure/baseline.h"

static bool measure_budget(struct bench *bench, const struct measure_list *subjects) {
    struct reference_desc reference = bench_reference(bench, REFERENCE_PATH);
    bench_expect(bench, budget_subjects() + (bench->values.tracer ? BASELINE_SUBJECTS : 0));
    return budget_measure(&bench->results, subjects->items, &reference) &&
           (!bench->values.tracer ||
            baseline_measure(&bench->results, subjects->items, &reference, AGAINST_REFERENCE));
}

static bool measure_curves(struct bench *bench, const struct measure_list *subjects) {
    struct reference_desc reference = bench_reference(bench, REFERENCE_CENTERS);
    bench_expect(bench, curves_subjects(subjects->items));
    return curves_measure(&bench->results, subjects->items, &reference);
}

const struct bench_mode bench_budget = {
    .name = "budget",
    .help = "errors of a frame, approximation by approximation, from the reference on\n"
            "Each step changes one thing. Without SCENE: the paper's four scenes.",
    .options = "size set tracer noise cache" BENCH_CONTEXT,
    .measure = measure_budget,
    .tables = {{"each step alone, against the one before", {ERROR_COLUMNS(AGAINST_BEFORE)}},
               {"against the reference",
                {ERROR_COLUMNS(AGAINST_REFERENCE), {"its noise", "noise", NULL}}},
               {"but for edges: against the reference through pixels' centres",
                {ERROR_COLUMNS(AGAINST_CENTERS)}}},
};

const struct bench_mode bench_curves = {
    .name = "curves",
    .help =
        "errors over M, K, N and the map size, as in the paper's Fig. 10\n"
        "N is compared with the path tracer, the others with ray-traced visibility of the same\n"
        "VPLs. Without SCENE: the paper's four scenes.",
    .options = "size set noise cache" BENCH_CONTEXT,
    .measure = measure_curves,
    .tables = {{"errors along one setting", {ERROR_COLUMNS(NULL)}}},
};
