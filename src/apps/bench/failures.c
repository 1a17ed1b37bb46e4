/* manylight bench failures: errors where such methods break, held to what is promised. */
#include "apps/bench/bench.h"

#include "base/error.h"
#include "measure/failures.h"

static const struct table table = {"per cent",
                                   {{"rRMSE", "relative-rmse", NULL},
                                    {"at most", "rmse-bound", NULL},
                                    {"bias", "relative-bias", NULL},
                                    {"at most", "bias-bound", NULL},
                                    {"worst", "worst", NULL},
                                    {"not finite", "non-finite", NULL},
                                    {"messages", "messages", NULL},
                                    {"holds", "holds", NULL}}};

/* The i-th of those asked for, or of all; NULL after the last. */
static const struct failure_row *row_at(const struct bench *bench, int i) {
    if (!bench->argument_count)
        return failure_rows[i].name ? &failure_rows[i] : NULL;
    return i < bench->argument_count ? failure_row_find(bench->arguments[i]) : NULL;
}

static bool check(struct bench *bench) {
    for (int i = 0; i < bench->argument_count; i++)
        if (!failure_row_find(bench->arguments[i]))
            return false;
    return true;
}

static bool finish(struct bench *bench) {
    struct results *results = &bench->results;
    struct failure_desc desc = {.width = bench->values.size[0],
                                .height = bench->values.size[1],
                                .settings = bench->settings,
                                .truth = bench_truth(bench, TRUTH_CENTERS),
                                .context = bench->context,
                                .pictures = bench->values.output};
    const struct failure_row *row;
    int broken = 0;
    for (int i = 0; (row = row_at(bench, i)); i++) {
        int first = results->subject_count;
        if (!failure_measure(results, row, &desc))
            return false;
        results_print(stdout, results, first, &table);
        fflush(stdout);
        for (int k = first; k < results->subject_count; k++)
            broken += results_value(results, k, "holds", NULL) == 0;
    }
    return !broken || error_set("%d results are not what is promised", broken);
}

static const struct option options[] = {
    {"output", 'o', OPTION_TEXT, BENCH_VALUE(output), .value_name = "DIR",
     .help = "where a picture of each goes: the reference and all columns, differences below"},
    BENCH_SIZE(160),
    BENCH_SETTINGS,
    BENCH_NOISE,
    BENCH_CACHE,
    BENCH_CSV,
    BENCH_CONTEXT,
    {NULL},
};

const struct bench_mode bench_failures = {
    .name = "failures",
    .help = "errors where such methods break, held to what is promised",
    .synopsis = "[NAME ...] [OPTION ...]",
    .summary = "Measures the errors of known ways to break, each a small scene or a setting. What\n"
               "is promised is at 160x120 and --noise .02. Without NAME: all.",
    .options = options,
    .check = check,
    .usual = bench_no_variants,
    .finish = finish,
};
