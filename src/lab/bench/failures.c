/* manylight bench failures: errors where such methods break, held to what is promised. */
#include "lab/bench/bench.h"

#include "base/error.h"
#include "base/file/output_file.h"
#include "base/log.h"
#include "lab/measure/failures.h"

static const struct table table = {"per cent",
                                   {{"rRMSE", "relative-rmse", NULL},
                                    {"at most", "rmse-bound", NULL},
                                    {"bias", "relative-bias", NULL},
                                    {"at most", "bias-bound", NULL},
                                    {"worst", "worst", NULL},
                                    {"not finite", "non-finite", NULL},
                                    {"messages", "messages", NULL},
                                    {"holds", "holds", NULL}}};

/* All, where none is named. */
static bool check(struct bench *bench) {
    for (int i = 0; i < bench->argument_count; i++)
        if (!failure_row_find(bench->arguments[i]))
            return false;
    if (bench->argument_count == 0)
        for (const struct failure_row *row = failure_rows; row->name; row++)
            bench_add_argument(bench, row->name);
    return true;
}

static bool finish(struct bench *bench) {
    struct results *results = &bench->results;
    struct failure_desc desc = {.width = bench->values.size[0],
                                .height = bench->values.size[1],
                                .settings = &bench->values.settings,
                                .reference = bench_reference(bench, REFERENCE_CENTERS),
                                .context = bench->context,
                                .pictures = bench->values.output};
    for (int i = 0; i < bench->argument_count; i++) {
        int first = results->subject_count;
        bench_begin_part(bench, i);
        bench_expect(bench, FAILURE_COLUMNS);
        if (!failure_measure(results, failure_row_find(bench->arguments[i]), &desc))
            return false;
        log_show_line(NULL);
        results_print(results, first, &table, -1);
        output_file_flush_stdout();
    }
    return true;
}

static bool judge(struct bench *bench) {
    int broken = 0;
    for (int i = 0; i < bench->results.subject_count; i++)
        broken += results_value(&bench->results, i, "holds", NULL) == 0;
    return !broken || error_set("%d results are not what is promised", broken);
}

const struct bench_mode bench_failures = {
    .name = "failures",
    .help = "errors in known difficult cases, checked against bounds\n"
            "Each case is a small scene or a setting. --output writes one EXR file for each: the\n"
            "reference, and a layer for each column. The bounds are for 160x120 and --noise .02. "
            "Without NAME: all.",
    .arguments = "[NAME ...]",
    .options = "size set noise cache output" BENCH_CONTEXT,
    .check = check,
    .finish = finish,
    .judge = judge,
};
