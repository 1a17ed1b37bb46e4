/* manylight bench: times of the passes, and what they buy. */
#include "apps/bench.h"

#include "apps/apps.h"
#include "apps/bench_chart.h"
#include "apps/context_options.h"
#include "apps/failures.h"
#include "apps/temporal.h"

#include "base/error.h"
#include "base/log.h"
#include "base/output_file.h"

#include <unistd.h>

enum { SCENES_MAX = 32 };

static const struct option options[] = {
    {"size", 's', OPTION_SIZE, offsetof(struct bench_values, size), 800, 1, 16384,
     .help = "of the picture, pixels"},
    {"variant", 0, OPTION_LIST, offsetof(struct bench_values, variants),
     .help = "what to compare, of the list below; repeatable"},
    {"set", 0, OPTION_LIST, offsetof(struct bench_values, settings), .value_name = "KEY=VALUE",
     .help = "a setting of all variants (manylight render --help); repeatable"},
    {"sweep", 0, OPTION_LIST, offsetof(struct bench_values, sweeps), .value_name = "KEY=A,B..C",
     .help = "vary settings, technique or size over a grid: vals=2..128 is powers of two; N, M\n"
             "and K are vpls, vals and terms; repeatable"},
    {"frames", 0, OPTION_INT, offsetof(struct bench_values, frames), 0, 0, 100000,
     .help = "measured per case; 0 = 5 on software OpenGL, else 100"},
    {"warm-up", 0, OPTION_INT, offsetof(struct bench_values, warm_up), 0, 0, 100000,
     .help = "frames before; 0 = 1 on software OpenGL, else 10"},
    {"reference", 0, OPTION_CHOICE, offsetof(struct bench_values, reference),
     .choices = bench_reference_names,
     .help = "measure errors too, against one bounce path-traced, or all VPLs with a map each"},
    {"noise", 0, OPTION_FLOAT, offsetof(struct bench_values, noise), .01, 1e-4, 1,
     .help = "of a path-traced reference: standard error over mean"},
    {"cache", 0, OPTION_TEXT, offsetof(struct bench_values, cache), .value_name = "DIR",
     .help = "where references are kept [$XDG_CACHE_HOME/manylight]"},
    {"csv", 0, OPTION_TEXT, offsetof(struct bench_values, csv), .value_name = "FILE",
     .help = "write every quantity of every case"},
    {"json", 0, OPTION_TEXT, offsetof(struct bench_values, json), .value_name = "FILE",
     .help = "the same as JSON"},
    {"scaling", 0, OPTION_FLAG, offsetof(struct bench_values, scaling),
     .help = "how the time grows with pixels, N, M and faces"},
    {"budget", 0, OPTION_FLAG, offsetof(struct bench_values, budget),
     .help = "no times: the error of the frame, step by step on the way from the truth"},
    {"curves", 0, OPTION_FLAG, offsetof(struct bench_values, curves),
     .help = "no times: the error against M, K, N and map size, drawn into --output"},
    {"temporal", 0, OPTION_FLAG, offsetof(struct bench_values, temporal),
     .help = "no times: flicker over each scene's clip, of --frames [50] frames spread over it"},
    {"failures", 0, OPTION_FLAG, offsetof(struct bench_values, failures),
     .help = "no times: the errors where such methods break; names of rows stand for SCENEs,\n"
             "and pictures go to --output"},
    {"chart", 0, OPTION_TEXT, offsetof(struct bench_values, chart), .value_name = "FILE.csv",
     .help = "measure nothing: draw time against error, a chart a scene, from a sweep's --csv"},
    {"output", 'o', OPTION_TEXT, offsetof(struct bench_values, output), .value_name = "DIR",
     .help = "where charts go [.]"},
    CONTEXT_OPTIONS(struct bench_values, context),
    {NULL},
};

static const struct arguments arguments = {
    .synopsis = "[SCENE ...] [OPTION ...]",
    .summary = "Measures how long frames take, pass by pass, as in the paper's Tables 1 and 2.\n"
               "Without SCENE: the paper's four scenes, from the folder scenes.",
    .options = options,
    .max_positional = SCENES_MAX,
    .print_more = bench_print_variants,
};

/* The paper's scenes [Dong 2009, Table 1], or what stands for them. */
static const char *const usual_scenes[] = {"scenes/cornell-box.glb", "scenes/cornell-animal.glb",
                                           "scenes/atrium.glb", "scenes/metaballs.glb"};

enum { USUAL_SCENES = sizeof usual_scenes / sizeof *usual_scenes };

static int pick_usual_scenes(const char **scenes) {
    int count = 0;
    for (int i = 0; i < USUAL_SCENES; i++)
        if (access(usual_scenes[i], R_OK) == 0)
            scenes[count++] = usual_scenes[i];
        else
            log_note("%s is not here", usual_scenes[i]);
    return count;
}

/* Told before hours of measuring. */
static bool check_output(const char *output, const char **scenes, int scene_count) {
    bool ok = !output || output_file_check(output);
    for (int i = 0; output && ok && i < scene_count; i++)
        ok = output_file_is_not(output, scenes[i]);
    return ok;
}

/* One of the modes that render. */
static bool run(const struct bench_values *values, const char **scenes, int scene_count,
                const struct sweep *sweep) {
    struct context_desc desc = values->context;
    desc.debug = desc.debug || values->failures; /* the suite counts messages */
    if (!check_output(values->csv, scenes, scene_count) ||
        !check_output(values->json, scenes, scene_count))
        return false;
    struct context *context = context_create(&desc);
    if (!context)
        return false;
    bool software = context_is_software(context);
    bool ok = values->failures   ? bench_failures(values, scenes, scene_count, context)
              : values->temporal ? bench_temporal(values, scenes, scene_count, software)
              : values->budget   ? bench_budgets(values, scenes, scene_count, software)
              : values->curves   ? bench_all_curves(values, scenes, scene_count, software)
              : values->scaling  ? bench_scaling(values, scenes, scene_count, software)
                                 : bench_times(values, scenes, scene_count, sweep, software);
    context_free(context);
    return ok;
}

int app_bench(int argc, char **argv) {
    struct bench_values values;
    const char *scenes[SCENES_MAX];
    struct sweep sweep = {0};
    int count, status;
    if (!arguments_parse(&arguments, &values, argc, argv, scenes, &count, &status))
        return status;
    for (int i = 0; i < values.sweeps.count; i++)
        if (!sweep_parse(&sweep, values.sweeps.items[i]))
            return arguments_misuse(argv[0]);
    if (values.chart)
        return bench_chart(values.chart, bench_output(&values)) ? STATUS_OK
                                                                : arguments_fail(argv[0]);
    if (count == 0 && !values.failures && (count = pick_usual_scenes(scenes)) == 0) {
        error_set("no SCENE, and none of the usual ones is here");
        return arguments_misuse(argv[0]);
    }
    return run(&values, scenes, count, &sweep) ? STATUS_OK : arguments_fail(argv[0]);
}
