/* manylight bench MODE: what frames cost, and what they buy. */
#include "apps/bench/bench.h"

#include "apps/apps.h"
#include "base/error.h"
#include "base/log.h"
#include "base/memory.h"
#include "base/output_file.h"
#include "base/text.h"
#include "measure/timing.h"
#include "measure/variant.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const struct bench_mode *const modes[] = {
    &bench_times,  &bench_sweep,    &bench_scaling,  &bench_budget,
    &bench_curves, &bench_temporal, &bench_failures, &bench_chart,
};

enum { MODES = sizeof modes / sizeof *modes };

const char *const bench_usual_variants[] = {"paper", "fast", NULL};
const char *const bench_no_variants[] = {":", NULL};

/* --- subjects --------------------------------------------------------------------------------- */

bool bench_prepare(const struct bench *bench, const struct stage *stage, const char *variant,
                   struct measure_desc *desc) {
    *desc = measure_default(stage, bench->values.size[0], bench->values.size[1],
                            bench->context && context_is_software(bench->context));
    return variant_apply(desc, variant) && measure_assign_text(desc, bench->settings);
}

/* At each point of the sweep. */
static bool list_variant(const struct bench *bench, const struct stage *stage,
                         const struct sweep *sweep, const char *variant,
                         struct measure_desc **descs, int *count) {
    bool ok = true;
    for (int i = 0; ok && i < (sweep->count ? sweep->count : 1); i++) {
        *descs = mem_resize(*descs, (size_t)*count + 1, sizeof **descs);
        struct measure_desc *desc = &(*descs)[(*count)++];
        ok = bench_prepare(bench, stage, variant, desc) &&
             (!sweep->count || sweep_apply(sweep->points[i], desc)) && measure_check(desc);
    }
    return ok;
}

struct measure_desc *bench_list(const struct bench *bench, const struct stage *stage,
                                const struct sweep *sweep, const char *const *usual, int *count) {
    const struct text_list *asked = &bench->values.variants;
    const char *const *names = asked->count          ? asked->items
                               : sweep->has_variants ? bench_no_variants
                                                     : usual;
    struct measure_desc *descs = NULL;
    bool ok = true;
    *count = 0;
    for (int i = 0; ok && (asked->count ? i < asked->count : names[i] != NULL); i++)
        ok = list_variant(bench, stage, sweep, names[i], &descs, count);
    if (!ok)
        free(descs), descs = NULL;
    return descs;
}

struct truth_desc bench_truth(const struct bench *bench, enum truth_kind kind) {
    return (struct truth_desc){kind, bench->values.cache, (double)bench->values.noise};
}

bool bench_time(struct bench *bench, const struct measure_desc *descs, int count,
                enum truth_kind kind) {
    return timing_measure(&bench->results, descs, count,
                          &(struct timing_desc){bench->values.warm_up, bench->values.frames,
                                                bench_truth(bench, kind)});
}

static bool measure_scene(struct bench *bench, const struct bench_mode *mode, const char *path) {
    struct stage *stage = &bench->stage;
    int count, first = bench->results.subject_count;
    if (!stage_init(stage, &(struct stage_desc){.path = path}))
        return false;
    struct measure_desc *descs = bench_list(bench, stage, &bench->sweep, mode->usual, &count);
    log_note("%s", stage->name);
    bool ok = descs && mode->measure(bench, descs, count);
    for (const struct table *table = mode->tables; ok && table && table->title; table++)
        results_print(stdout, &bench->results, first, table);
    free(descs);
    stage_free(stage);
    return ok;
}

/* --- the command line ------------------------------------------------------------------------- */

/* The paper's scenes [Dong 2009, Table 1], or what stands for them. */
static bool pick_usual_scenes(struct bench *bench) {
    static const char *const usual[] = {"scenes/cornell-box.glb", "scenes/cornell-animal.glb",
                                        "scenes/atrium.glb", "scenes/metaballs.glb"};
    bench->arguments = mem_resize(bench->arguments, 4, sizeof *bench->arguments);
    for (int i = 0; i < 4; i++)
        if (access(usual[i], R_OK) == 0)
            bench->arguments[bench->argument_count++] = usual[i];
        else
            log_note("%s is not here", usual[i]);
    return bench->argument_count || error_set("no SCENE, and none of the usual ones is here");
}

/* "a=1", "b=2" as "a=1,b=2"; the caller frees it. */
static char *join(const struct text_list *list) {
    struct text text = {0};
    for (int i = 0; i < list->count; i++)
        text_print(&text, "%s%s", i ? "," : "", list->items[i]);
    return text.data;
}

/* Everything that the arguments alone can get wrong: variants and settings are tried. */
static bool check(struct bench *bench, const struct bench_mode *mode) {
    int count;
    bench->settings = join(&bench->values.settings);
    for (int i = 0; i < bench->values.axes.count; i++)
        if (!sweep_parse(&bench->sweep, bench->values.axes.items[i]))
            return false;
    struct measure_desc *tried = bench_list(bench, NULL, &bench->sweep, mode->usual, &count);
    free(tried);
    return tried && (mode->check             ? mode->check(bench)
                     : bench->argument_count ? true
                                             : pick_usual_scenes(bench));
}

/* What would be told after hours of measuring only. */
static bool check_output(const struct bench *bench) {
    const char *csv = bench->values.csv;
    bool ok = !csv || output_file_check(csv);
    for (int i = 0; csv && ok && i < bench->argument_count; i++)
        ok = output_file_is_not(csv, bench->arguments[i]);
    return ok;
}

static bool run(struct bench *bench, const struct bench_mode *mode) {
    if (!check_output(bench))
        return false;
    struct context_desc desc = bench->values.context;
    desc.debug = desc.debug || mode == &bench_failures; /* it counts messages */
    bool ok = mode->needs_no_context || (bench->context = context_create(&desc));
    for (int i = 0; ok && mode->measure && i < bench->argument_count; i++)
        ok = measure_scene(bench, mode, bench->arguments[i]);
    ok = ok && (!mode->finish || mode->finish(bench));
    if (bench->values.csv && bench->results.row_count) /* what there is, if it failed half-way */
        ok = results_write(&bench->results, mode->name, bench->values.csv) && ok;
    context_free(bench->context);
    return ok;
}

static void print_variants(FILE *out, const void *values) {
    (void)values;
    variants_print(out);
}

static int run_mode(const struct bench_mode *mode, int argc, char **argv) {
    struct bench bench = {.arguments = mem_alloc((size_t)argc, sizeof *bench.arguments)};
    const struct arguments arguments = {
        .synopsis = mode->synopsis,
        .summary = mode->summary,
        .options = mode->options,
        .max_positional = argc,
        .print_more = option_find(mode->options, "variant") ? print_variants : NULL,
    };
    int status;
    char name[32];
    snprintf(name, sizeof name, "bench %s", mode->name);
    argv[0] = name;
    if (arguments_parse(&arguments, &bench.values, argc, argv, bench.arguments,
                        &bench.argument_count, &status)) {
        if (!check(&bench, mode))
            status = arguments_misuse(name);
        else
            status = run(&bench, mode) ? STATUS_OK : arguments_fail(name);
    }
    sweep_free(&bench.sweep);
    free(bench.settings);
    results_free(&bench.results);
    free(bench.arguments);
    return status;
}

static void print_help(FILE *out) {
    fprintf(out, "usage: manylight bench MODE [SCENE ...] [OPTION ...]\n\n"
                 "Measures what frames cost, and how true they are.\n\n");
    for (int i = 0; i < MODES; i++)
        fprintf(out, "  %-10s %s\n", modes[i]->name, modes[i]->help);
    fprintf(out, "\nmanylight bench MODE --help lists a mode's options.\n");
}

int app_bench(int argc, char **argv) {
    for (int i = 0; argc > 1 && i < MODES; i++)
        if (strcmp(argv[1], modes[i]->name) == 0)
            return run_mode(modes[i], argc - 1, argv + 1);
    if (argc > 1 && (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0)) {
        print_help(stdout);
        return STATUS_OK;
    }
    error_set(argc > 1 ? "no mode is called '%s' (--help lists them)" : "MODE is missing",
              argc > 1 ? argv[1] : "");
    return arguments_misuse(argv[0]);
}
