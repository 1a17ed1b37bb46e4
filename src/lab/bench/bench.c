/* manylight bench MODE: what frames cost, and what they buy. */
#include "lab/bench/bench.h"

#include "apps/subcommands.h"
#include "base/error.h"
#include "base/file/folder.h"
#include "base/log.h"
#include "base/memory.h"
#include "lab/measure/timing.h"

#include <assert.h>
#include <string.h>
#include <unistd.h>

static const struct bench_mode *const bench_modes[] = {
    &bench_times,   &bench_sweep,    &bench_budget,   &bench_curves, &bench_passes,
    &bench_quality, &bench_temporal, &bench_failures, &bench_direct, NULL,
};

const char *const bench_variants[] = {"paper", "fast", NULL};
static const char *const defaults_alone[] = {":", NULL};

/* [Dong 2009, Table 1], or what stands for them. */
static const char *const paper_scenes[] = {"scenes/cornell-box.glb", "scenes/cornell-animal.glb",
                                           "scenes/atrium.glb", "scenes/metaballs.glb", NULL};

/* --- subjects --------------------------------------------------------------------------------- */

bool bench_prepare(const struct bench *bench, const char *variant, struct measure_desc *desc) {
    const struct bench_values *values = &bench->values;
    *desc = measure_default(bench->stage, values->size[0], values->size[1]);
    return variant_apply(desc, variant) &&
           measure_assign_all(desc, values->settings.items, values->settings.count);
}

bool bench_list(const struct bench *bench, const char *const *variants, const char *axis,
                struct measure_list *list) {
    const struct text_list *asked = &bench->values.variants, *axes = &bench->values.axes;
    bool ok = true;
    *list = (struct measure_list){0};
    variants = variants ? variants : defaults_alone;
    for (int i = 0; ok && (asked->count ? i < asked->count : variants[i] != NULL); i++) {
        struct measure_desc desc;
        ok = bench_prepare(bench, asked->count ? asked->items[i] : variants[i], &desc);
        measure_list_add(list, &desc);
    }
    for (int i = 0; ok && i < axes->count; i++)
        ok = measure_vary(list, axes->items[i]);
    ok = ok && (!axis || measure_vary(list, axis));
    for (int i = 0; ok && i < list->count; i++)
        ok = measure_check(&list->items[i]);
    return ok;
}

struct reference_desc bench_reference(const struct bench *bench, enum reference_kind kind) {
    return (struct reference_desc){kind, bench->values.cache, (double)bench->values.noise};
}

bool bench_time(struct bench *bench, const struct measure_list *subjects,
                enum reference_kind kind) {
    return timing_measure(&bench->results, subjects,
                          &(struct timing_desc){bench->values.warm_up, bench->values.frames,
                                                bench->values.whole_frames, bench->values.picture,
                                                bench_reference(bench, kind)});
}

/* --- the command line ------------------------------------------------------------------------- */

#define VALUE(member) offsetof(struct bench_values, member)

/* Of all modes. */
static const struct option options[] = {
    {"vary", 0, OPTION_LIST, VALUE(axes), .value_name = "KEY=A,B..C",
     .help = "setting, technique or size to vary; vals=2..128: powers of\n"
             "two; N, M, K: vpls, vals, terms; repeatable, for a grid"},
    {"size", 's', OPTION_SIZE, VALUE(size), 800, 1, 16384, .help = "size of the picture, pixels"},
    {"variant", 0, OPTION_LIST, VALUE(variants),
     .help = "variant to measure, listed below; repeatable"},
    {"set", 0, OPTION_LIST, VALUE(settings), .value_name = "KEY=VALUE",
     .help = "setting of all variants (manylight render --help-all); repeatable"},
    {"frames", 0, OPTION_INT, VALUE(frames), 0, 0, 100000,
     .help = "number of measured frames; 0: 5 on\n"
             "software OpenGL, else 100; for a clip 50"},
    {"warm-up", 0, OPTION_INT, VALUE(warm_up), 0, 0, 100000,
     .help = "number of frames before the measured\n"
             "ones; 0: 1 on software OpenGL, else 10"},
    {"whole-frames", 0, OPTION_FLAG, VALUE(whole_frames),
     .help = "time whole frames alone, not their passes: half the frames"},
    {"picture", 0, OPTION_TEXT, VALUE(picture), .value_name = "FILE.exr",
     .help =
         "write the first frame, the picture of manylight render; of one SCENE and one --variant"},
    {"passes", 0, OPTION_INT, VALUE(passes), 256, 1, 65536,
     .help = "largest number of passes; also measures each power of two below"},
    {"reference", 0, OPTION_CHOICE, VALUE(reference), .choices = reference_names,
     .help = "reference with as many bounces: path-traced, path-traced at pixel centres\n"
             "(centers), all VPLs with a map each (vpls; the default for a clip), or\n"
             "the visible fraction of direct light (seen), or ambient occlusion (ao)"},
    {"tracer", 0, OPTION_FLAG, VALUE(tracer),
     .help =
         "also measure the denoised path tracer with 1 to 16 samples per pixel, by default\n"
         "against --reference path; sweep on software OpenGL: its CPU time at each\n"
         "variant's error (\"< curve\": below that of 1 sample, \"> curve\": above that of 16)"},
    {"estimates", 0, OPTION_FLAG, VALUE(estimates),
     .help = "only estimate the error of each choice: no times, no fixed settings for comparison"},
    {"camera", 0, OPTION_TEXT, VALUE(stage.camera), .value_name = "NAME|N",
     .help = "camera by name or number [the first], with changes: \"0 eye=0,1,3 forward=0,0,-1\""},
    {"light", 0, OPTION_TEXT, VALUE(stage.light), .value_name = "NAME|N,...",
     .help = "lights that shine [all]: \"emitters\", \"sky\", \"lamp,1\""},
    {"environment", 0, OPTION_TEXT, VALUE(stage.environment.path), .value_name = "FILE",
     .help = "environment map in place of the scene's: panorama, .hdr or .exr, in W/(sr m2)"},
    {"noise", 0, OPTION_FLOAT, VALUE(noise), .01, 1e-4, 1, .value_name = "X%",
     .help = "noise of a path-traced reference: standard error over mean"},
    {"cache", 0, OPTION_TEXT, VALUE(cache), .value_name = "DIR",
     .help = "folder of the references [$XDG_CACHE_HOME/manylight]"},
    {"reference-file", 0, OPTION_TEXT, VALUE(reference_file), .value_name = "FILE",
     .help = "file of a reference for the scene in this size, in place of the cache"},
    {"output", 'o', OPTION_TEXT, VALUE(output), .value_name = "DIR", .help = "folder for pictures"},
    {"csv", 0, OPTION_TEXT, VALUE(csv), .value_name = "FILE",
     .help = "file for all results, one row each, written after each measurement"},
    CONTEXT_OPTIONS(struct bench_values, context),
};

enum { OPTIONS = sizeof options / sizeof *options };

static bool has_option(const struct bench_mode *mode, const char *name) {
    for (struct word word = {.at = mode->options}; word_next(&word);)
        if (word_is(&word, name))
            return true;
    return false;
}

void bench_add_argument(struct bench *bench, const char *argument) {
    size_t count = (size_t)bench->argument_count++;
    bench->arguments = mem_resize(bench->arguments, count + 1, sizeof *bench->arguments);
    bench->arguments[count] = argument;
}

static bool pick_scenes(struct bench *bench, const char *const *scenes) {
    scenes = scenes ? scenes : paper_scenes;
    for (int i = 0; scenes[i]; i++) {
        assert(i < BENCH_OWN_MAX);
        char *path = bench->own_scenes[i] = folder_find_own(scenes[i]);
        if (access(path, R_OK) == 0)
            bench_add_argument(bench, path);
        else
            log_note("%s is not here", path);
    }
    return bench->argument_count ||
           error_set("no SCENE, and none of the usual ones is in scenes/ here or in the "
                     "program's share/manylight/scenes");
}

/* Everything that the arguments alone can get wrong: variants and settings are tried. */
static bool check(struct bench *bench, const struct bench_mode *mode) {
    struct measure_list tried;
    bool ok = bench_list(bench, mode->variants, NULL, &tried);
    free(tried.items);
    return ok && (mode->check ? mode->check(bench)
                              : bench->argument_count || pick_scenes(bench, mode->scenes));
}

static void print_variants(FILE *out, const void *values) {
    (void)values;
    variants_print(out);
}

static int run_mode(const struct bench_mode *mode, int argc, char **argv) {
    struct bench bench = {.arguments = mem_alloc((size_t)argc, sizeof *bench.arguments)};
    struct option table[OPTIONS + 1] = {{NULL}};
    char synopsis[64], name[32];
    int status;
    for (int i = 0, used = 0; i < OPTIONS; i++)
        if (has_option(mode, options[i].name))
            table[used++] = options[i];
    snprintf(synopsis, sizeof synopsis, "%s [OPTION ...]",
             mode->arguments ? mode->arguments : "[SCENE ...]");
    snprintf(name, sizeof name, "bench %s", mode->name);
    argv[0] = name;
    if (arguments_parse(
            &(struct arguments){.synopsis = synopsis,
                                .summary = mode->help,
                                .options = table,
                                .max_positional = argc,
                                .opens_scenes = mode->measure != NULL,
                                .shows_progress = mode->measure != NULL,
                                .print_more = has_option(mode, "variant") ? print_variants : NULL},
            &bench.values, argc, argv, bench.arguments, &bench.argument_count, &status)) {
        if (!check(&bench, mode))
            status = arguments_misuse(name);
        else
            status = bench_run(&bench, mode) ? STATUS_OK : arguments_fail(name);
    }
    results_free(&bench.results);
    for (int i = 0; i < BENCH_OWN_MAX; i++)
        free(bench.own_scenes[i]);
    free(bench.arguments);
    return status;
}

static void print_help(FILE *out) {
    fprintf(out, "usage: manylight bench MODE [SCENE ...] [OPTION ...]\n\n"
                 "Measures times and errors of frames.\n\n");
    for (const struct bench_mode *const *mode = bench_modes; *mode; mode++)
        fprintf(out, "  %-10s %.*s\n", (*mode)->name, (int)strcspn((*mode)->help, "\n"),
                (*mode)->help);
    fprintf(out, "\nmanylight bench MODE --help lists a mode's options.\n");
}

int app_bench(int argc, char **argv) {
    for (const struct bench_mode *const *mode = bench_modes; argc > 1 && *mode; mode++)
        if (strcmp(argv[1], (*mode)->name) == 0)
            return run_mode(*mode, argc - 1, argv + 1);
    if (argc > 1 && arguments_is_help(argv[1])) {
        print_help(stdout);
        return STATUS_OK;
    }
    error_set(argc > 1 ? "no mode is called '%s' (--help lists them)" : "MODE is missing",
              argc > 1 ? argv[1] : "");
    return arguments_misuse(argv[0]);
}
