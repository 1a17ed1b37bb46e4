#include "apps/bench/run.h"

#include "apps/bench/measure/journal.h"
#include "apps/bench/measure/result_rows.h"
#include "base/error.h"
#include "base/file/file.h"
#include "base/file/output_file.h"
#include "base/log.h"
#include "base/text.h"
#include "gl/screen.h"

#include "sources.h"

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
    double done = (double)work->part / bench->argument_count +
                  share_of(bench, committed + subjects) - work->resumed;
    char note[2 * MEASURE_NAME_SIZE + SCENE_NAME_SIZE + 8] = "";
    if (desc)
        snprintf(note, sizeof note, "%s: %s %s", desc->stage->name, desc->variant, desc->point);
    else
        snprintf(note, sizeof note, "%s", bench->arguments[work->part]);
    progress_show_work(&work->progress, done / (1 - work->resumed), note);
}

/* --- rows ------------------------------------------------------------------------------------- */

/* Prints what is new of the first table. */
static void hear(void *user, bool resumed) {
    struct bench *bench = user;
    struct bench_work *work = &bench->work;
    const struct table *table = &bench->mode->tables[0];
    if (resumed)
        work->resumed += share_of(bench, 1);
    if (table->title) {
        log_show_line(NULL);
        work->last = results_print(&bench->results, work->printed, table, work->last);
        output_file_flush_stdout();
    }
    work->printed = bench->results.subject_count;
}

/* What makes no other rows, or shows in them. */
static const char not_identity[] = "csv restart cache output gl-debug quiet verbose progress";

static bool is_identity(const struct option *option) {
    for (struct word word = {.at = not_identity}; word_next(&word);)
        if (word_is(&word, option->name))
            return false;
    return true;
}

/* On one line. */
static void add_line(struct text *text, const char *name, const char *value) {
    text_print(text, "%s ", name);
    for (; *value; value++)
        text_print(text, "%c", *value == '\n' ? ' ' : *value);
    text_print(text, "\n");
}

static void add_option(struct text *text, const struct option *option, const void *values) {
    char value[1024];
    if (option->type == OPTION_LIST) {
        const struct text_list *list =
            (const struct text_list *)((const char *)values + option->offset);
        for (int i = 0; i < list->count; i++)
            add_line(text, option->name, list->items[i]);
        return;
    }
    option_format(option, values, value, sizeof value);
    add_line(text, option->name, value);
}

static const char screen_passes[] = "screen passes";

/* All that makes a run another one; the caller frees the text. */
static char *identity_of(const struct bench *bench, const struct option *options) {
    struct machine_cell cells[MACHINE_CELLS + 1];
    struct text text = {0};
    add_line(&text, "mode", bench->mode->name);
    for (int i = 0; i < bench->argument_count; i++)
        add_line(&text, "of", bench->arguments[i]);
    for (const struct option *option = options; option->name; option++)
        if (is_identity(option))
            add_option(&text, option, &bench->values);
    machine_cells_init(cells);
    for (int i = 0; i < MACHINE_CELLS; i++)
        add_line(&text, cells[i].name, cells[i].value);
    machine_cells_free(cells);
    add_line(&text, "sources", MANYLIGHT_SOURCES);
    add_line(&text, screen_passes, screen_way_names[screen_way()]);
    return text.data;
}

/* Which way is faster may be told otherwise the next time: a run goes on in its own. */
static void keep_screen_way(const char *csv) {
    char *name = journal_value(csv, screen_passes);
    for (int way = 0; name && screen_way_names[way]; way++)
        if (strcmp(screen_way_names[way], name) == 0)
            screen_set_way((enum screen_way)way);
    free(name);
}

/* Where --csv is a file. A device or a pipe takes all rows at the end. */
static bool open_journal(struct bench *bench, const struct option *options) {
    const char *csv = bench->values.csv;
    if (!csv || file_is_stream(csv))
        return true;
    if (!bench->values.restart)
        keep_screen_way(csv);
    char *identity = identity_of(bench, options);
    bench->results.journal = journal_open(
        &(struct journal_desc){csv, bench->mode->name, identity, bench->values.restart});
    free(identity);
    return bench->results.journal;
}

/* A run that has failed keeps what it has. */
static void leave_journal(const struct bench *bench) {
    struct journal *journal = bench->results.journal;
    if (!journal)
        return;
    if (bench->results.committed == 0 && journal_left(journal) == 0)
        journal_finish(journal);
    else
        log_note("%s.part keeps what is measured; the same command goes on from there",
                 bench->values.csv);
}

static bool write_csv(struct bench *bench) {
    struct results *results = &bench->results;
    return (!bench->values.csv || !results->row_count ||
            result_rows_write(results, bench->mode->name, bench->values.csv)) &&
           (!results->journal || journal_finish(results->journal));
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
    results_set_stage(&bench->results, &stage);
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

bool bench_run(struct bench *bench, const struct bench_mode *mode, const struct option *options) {
    const char *csv = bench->values.csv; /* what would be told after hours of measuring only */
    if (csv && output_file_is_stdout(csv))
        return error_set("--csv -: standard output has the tables; name a file");
    if (csv && !output_file_check(csv, bench->arguments, bench->argument_count))
        return false;
    struct context_desc desc = bench->values.context;
    desc.debug = desc.debug || mode == &bench_failures; /* it counts messages */
    bool ok = !strstr(mode->options, BENCH_CONTEXT) || (bench->context = context_create(&desc));
    bench->mode = mode;
    if (bench->context)
        result_rows_print_machine();
    ok = ok && (!bench->context || open_journal(bench, options)) && measure_all(bench) &&
         write_csv(bench);
    if (!ok)
        leave_journal(bench);
    ok = ok && (!mode->judge || mode->judge(bench));
    journal_close(bench->results.journal);
    context_free(bench->context);
    return ok;
}
