#include "lab/bench/bench.h"

#include "base/error.h"
#include "base/file/file.h"
#include "base/file/output_file.h"
#include "base/log.h"
#include "lab/measure/result_rows.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- progress --------------------------------------------------------------------------------- */

void bench_begin_part(struct bench *bench, int part) {
    struct bench_work *work = &bench->work;
    work->part = part;
    work->first = bench->results.subject_count;
    work->expected = 0;
    results_tell_work(&bench->results, NULL, 0);
}

void bench_expect(struct bench *bench, int subjects) {
    bench->work.expected = subjects;
}

/* So many of the part's subjects, as a share of all work: parts count alike. */
static double share_of(const struct bench *bench, double subjects) {
    const struct bench_work *work = &bench->work;
    return work->expected ? fmin(subjects / work->expected, 1) / bench->argument_count : 0;
}

static void show_work(void *user, const struct measure_desc *desc, double subjects) {
    struct bench *bench = user;
    struct bench_work *work = &bench->work;
    int committed = bench->results.committed - work->first;
    double done =
        (double)work->part / bench->argument_count + share_of(bench, committed + subjects);
    char note[2 * MEASURE_NAME_SIZE + SCENE_NAME_SIZE + 8] = "";
    if (desc)
        snprintf(note, sizeof note, "%s: %s %s", desc->stage->name, desc->variant, desc->point);
    else
        snprintf(note, sizeof note, "%s", bench->arguments[work->part]);
    progress_show_work(&work->progress, done, note);
}

/* --- rows ------------------------------------------------------------------------------------- */

static bool write_csv(const struct bench *bench) {
    return !bench->results.row_count ||
           result_rows_write(&bench->results, bench->mode->name, bench->values.csv);
}

/* Prints what is new of the first table, and writes all rows: a run that ends early leaves what it
 * has measured. A device or a pipe takes all rows at the end. */
static bool hear(void *user) {
    struct bench *bench = user;
    struct bench_work *work = &bench->work;
    const struct table *table = &bench->mode->tables[0];
    if (table->title) {
        log_show_line(NULL);
        work->last = results_print(&bench->results, work->printed, table, work->last);
        output_file_flush_stdout();
    }
    work->printed = bench->results.subject_count;
    return !bench->values.csv || file_is_stream(bench->values.csv) || write_csv(bench);
}

/* --- all -------------------------------------------------------------------------------------- */

static bool measure_scene(struct bench *bench, int part) {
    const struct bench_mode *mode = bench->mode;
    struct stage stage;
    struct measure_list subjects;
    int first = bench->results.subject_count;
    struct stage_desc desc = bench->values.stage;
    desc.path = bench->arguments[part];
    bench_begin_part(bench, part);
    if (!stage_init(&stage, &desc))
        return false;
    bench->stage = &stage;
    bench->work.last = -1;
    log_note("%s", stage.name);
    bool ok = bench_list(bench, mode->variants, NULL, &subjects) && mode->measure(bench, &subjects);
    log_show_line(NULL);
    for (const struct table *table = mode->tables; ok && table->title && table[1].title; table++)
        results_print(&bench->results, first, table + 1, -1);
    output_file_flush_stdout();
    free(subjects.items);
    stage_free(&stage);
    return ok;
}

static bool measure_all(struct bench *bench) {
    const struct bench_mode *mode = bench->mode;
    bool ok = true;
    bench->results.listener = hear;
    bench->results.work_listener = show_work;
    bench->results.user = bench;
    progress_start(&bench->work.progress, "subjects");
    for (int i = 0; ok && mode->measure && i < bench->argument_count; i++)
        ok = measure_scene(bench, i);
    ok = ok && (!mode->finish || mode->finish(bench));
    progress_end(&bench->work.progress);
    return ok;
}

bool bench_run(struct bench *bench, const struct bench_mode *mode) {
    const char *csv = bench->values.csv; /* what would be told after hours of measuring only */
    if (csv && output_file_is_stdout(csv))
        return error_set("--csv -: standard output has the tables; name a file");
    if (csv && !output_file_check(csv, bench->arguments, bench->argument_count))
        return false;
    struct context_desc desc = bench->values.context;
    desc.debug = desc.debug || mode == &bench_failures; /* it counts messages */
    bench->context = context_create(&desc);
    bench->mode = mode;
    if (bench->context)
        result_rows_print_machine();
    bool ok = bench->context && measure_all(bench) && (!csv || write_csv(bench)) &&
              (!mode->judge || mode->judge(bench));
    context_free(bench->context);
    return ok;
}
