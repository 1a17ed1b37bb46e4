/* manylight bench curves: errors against M, K, N and the size of maps. */
#include "apps/bench/bench.h"

#include "measure/accuracy.h"
#include "measure/errors.h"

static bool measure(struct bench *bench, const struct measure_list *subjects) {
    struct truth_desc truth = bench_truth(bench, TRUTH_CENTERS);
    return curves_measure(&bench->results, subjects->items, &truth);
}

const struct bench_mode bench_curves = {
    .name = "curves",
    .help =
        "errors against M, K, N and the size of maps, as in the paper's Fig. 10\n"
        "N against the path-traced truth, the others against ray-traced visibility from the same\n"
        "VPLs. Without SCENE: the paper's four scenes.",
    .options = "size set noise cache" BENCH_CONTEXT,
    .measure = measure,
    .tables = {{"errors along one setting", {ERROR_COLUMNS(NULL)}}},
};
