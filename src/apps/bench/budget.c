/* manylight bench budget: the error of the frame, step by step on the way from the truth. */
#include "apps/bench/bench.h"

#include "measure/accuracy.h"
#include "measure/errors.h"

static bool measure(struct bench *bench, const struct measure_list *subjects) {
    struct truth_desc truth = bench_truth(bench, TRUTH_PATH);
    return budget_measure(&bench->results, subjects->items, &truth);
}

const struct bench_mode bench_budget = {
    .name = "budget",
    .help = "the error of the frame, step by step on the way from the truth\n"
            "Each step changes one thing. Without SCENE: the paper's four scenes.",
    .options = "size set noise cache" BENCH_CONTEXT,
    .measure = measure,
    .tables = {{"each step alone, against the one before", {ERROR_COLUMNS(AGAINST_BEFORE)}},
               {"against the truth", {ERROR_COLUMNS(AGAINST_TRUTH), {"its noise", "noise", NULL}}},
               {"but for edges: against the truth through pixels' centres",
                {ERROR_COLUMNS(AGAINST_CENTERS)}}},
};
