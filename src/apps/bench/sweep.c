/* manylight bench sweep: times and errors of variants over a grid of settings. */
#include "apps/bench/bench.h"

#include "measure/errors.h"

static bool measure(struct bench *bench, const struct measure_list *subjects) {
    return bench_time(bench, subjects, (enum truth_kind)bench->values.reference);
}

const struct bench_mode bench_sweep = {
    .name = "sweep",
    .help = "times and errors over a grid of settings\n"
            "Each variant at each point of the grid, its errors against the reference, if any.\n"
            "Without SCENE: the paper's four scenes, from the folder scenes.",
    .options = "vary size variant set frames warm-up reference noise cache" BENCH_CONTEXT,
    .variants = bench_variants,
    .measure = measure,
    .tables = {{"times and errors", {{"ms", "clock", NULL}, ERROR_COLUMNS(NULL)}}},
};
