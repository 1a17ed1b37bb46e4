/* manylight bench passes: how the mean of passes converges. */
#include "lab/bench/bench.h"

#include "lab/measure/errors.h"
#include "lab/measure/passes.h"

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
