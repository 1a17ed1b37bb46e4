/* manylight bench sweep: times and errors of variants over a grid of settings. */
#include "apps/bench/bench.h"

#include "measure/errors.h"

static const struct table tables[] = {
    {"times and errors", {{"ms", "clock", NULL}, ERROR_COLUMNS(NULL)}},
    {.title = NULL},
};

static bool measure(struct bench *bench, const struct measure_desc *descs, int count) {
    return bench_time(bench, descs, count, (enum truth_kind)bench->values.reference);
}

static const struct option options[] = {
    {"vary", 0, OPTION_LIST, BENCH_VALUE(axes), .value_name = "KEY=A,B..C",
     .help = "settings, technique or size: a grid over all; vals=2..128 is powers of two; N, M\n"
             "and K are vpls, vals and terms; repeatable"},
    {"reference", 0, OPTION_CHOICE, BENCH_VALUE(reference), .choices = truth_names,
     .help = "measure errors too, against one bounce path-traced (centers: through pixels'\n"
             "centres), or all VPLs with a map each"},
    BENCH_SIZE(800),
    BENCH_VARIANTS,
    BENCH_SETTINGS,
    BENCH_FRAMES,
    BENCH_NOISE,
    BENCH_CACHE,
    BENCH_CSV,
    BENCH_CONTEXT,
    {NULL},
};

const struct bench_mode bench_sweep = {
    .name = "sweep",
    .help = "times and errors over a grid of settings",
    .synopsis = "[SCENE ...] [--vary KEY=A,B..C ...] [OPTION ...]",
    .summary = "Measures time and, against a reference, errors of each variant at each point of a\n"
               "grid. Without SCENE: the paper's four scenes, from the folder scenes.",
    .options = options,
    .usual = bench_usual_variants,
    .measure = measure,
    .tables = tables,
};
