/* manylight bench budget: the error of the frame, step by step on the way from the truth. */
#include "apps/bench/bench.h"

#include "measure/accuracy.h"
#include "measure/errors.h"

static const struct table tables[] = {
    {"each step alone, against the one before", {ERROR_COLUMNS(AGAINST_BEFORE)}},
    {"against the truth", {ERROR_COLUMNS(AGAINST_TRUTH), {"its noise", "noise", NULL}}},
    {"but for edges: against the truth through pixels' centres", {ERROR_COLUMNS(AGAINST_CENTERS)}},
    {.title = NULL},
};

static bool measure(struct bench *bench, const struct measure_desc *descs, int count) {
    (void)count;
    struct truth_desc truth = bench_truth(bench, TRUTH_PATH);
    return budget_measure(&bench->results, descs, &truth);
}

static const struct option options[] = {
    BENCH_SIZE(800), BENCH_SETTINGS, BENCH_NOISE, BENCH_CACHE, BENCH_CSV, BENCH_CONTEXT, {NULL},
};

const struct bench_mode bench_budget = {
    .name = "budget",
    .help = "the error of the frame, step by step on the way from the truth",
    .synopsis = "[SCENE ...] [OPTION ...]",
    .summary = "Walks from a path-traced truth to the frame in steps that change one thing each,\n"
               "and tells the error of each. Without SCENE: the paper's four scenes.",
    .options = options,
    .usual = bench_no_variants,
    .measure = measure,
    .tables = tables,
};
