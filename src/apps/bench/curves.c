/* manylight bench curves: errors against M, K, N and the size of maps. */
#include "apps/bench/bench.h"

#include "measure/accuracy.h"
#include "measure/errors.h"

static const struct table tables[] = {
    {"errors along one setting", {ERROR_COLUMNS(NULL)}},
    {.title = NULL},
};

static bool measure(struct bench *bench, const struct measure_desc *descs, int count) {
    (void)count;
    struct truth_desc truth = bench_truth(bench, TRUTH_CENTERS);
    return curves_measure(&bench->results, descs, &truth);
}

static const struct option options[] = {
    BENCH_SIZE(800), BENCH_SETTINGS, BENCH_NOISE, BENCH_CACHE, BENCH_CSV, BENCH_CONTEXT, {NULL},
};

const struct bench_mode bench_curves = {
    .name = "curves",
    .help = "errors against M, K, N and the size of maps",
    .synopsis = "[SCENE ...] [OPTION ...]",
    .summary = "Measures errors along one setting at a time, as in the paper's Fig. 10: M, K and\n"
               "the size of maps against ray-traced visibility from the same VPLs, N against the\n"
               "path-traced truth. Without SCENE: the paper's four scenes.",
    .options = options,
    .usual = bench_no_variants,
    .measure = measure,
    .tables = tables,
};
