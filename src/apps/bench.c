/* manylight bench: times of the passes, and what they buy. */
#include "apps/bench.h"

#include "apps/apps.h"
#include "apps/bench_chart.h"
#include "apps/bench_errors.h"
#include "apps/bench_machine.h"
#include "apps/bench_rows.h"
#include "apps/bench_tables.h"
#include "apps/context_options.h"

#include "base/error.h"
#include "base/log.h"
#include "base/memory.h"

#include <stdlib.h>
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
             "                             and K are vpls, vals and terms; repeatable"},
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

/* The reference of the size at hand. */
struct inspection {
    struct bench_reference_desc desc;
    struct image reference;
};

static bool inspect(void *user, struct bench_case *measured, struct renderer *renderer) {
    struct inspection *inspection = user;
    struct image *reference = &inspection->reference;
    if (reference->width != measured->width || reference->height != measured->height) {
        image_free(reference);
        inspection->desc.width = measured->width;
        inspection->desc.height = measured->height;
        if (!bench_reference_get(&inspection->desc, reference))
            return false;
    }
    return bench_errors_of_frame(renderer, reference, &measured->errors);
}

/* All cases in groups that alternate. */
static bool measure_groups(struct bench_case *cases, int count, const struct stage *stage,
                           const struct bench_protocol *protocol) {
    for (int first = 0; first < count; first += BENCH_GROUP) {
        int group = count - first < BENCH_GROUP ? count - first : BENCH_GROUP;
        if (!bench_measure(&cases[first], group, stage, protocol))
            return false;
    }
    return true;
}

static struct bench_protocol choose_protocol(const struct bench_values *values, bool software) {
    struct bench_protocol protocol = bench_protocol_of(software);
    if (values->frames)
        protocol.frames = values->frames;
    if (values->warm_up)
        protocol.warm_up = values->warm_up;
    return protocol;
}

static bool measure_scene(struct bench_cases *cases, const struct bench_values *values,
                          const char *path, const struct sweep *sweep, bool software) {
    struct stage stage;
    if (!stage_init(&stage, &(struct stage_desc){.path = path}))
        return false;
    struct inspection inspection = {.desc = {.kind = values->reference,
                                             .cache = values->cache,
                                             .scene_path = path,
                                             .stage = &stage,
                                             .noise = (double)values->noise,
                                             .software = software}};
    struct bench_protocol protocol = choose_protocol(values, software);
    if (values->reference != BENCH_REFERENCE_NONE)
        protocol.inspect = inspect, protocol.user = &inspection;
    int first = cases->count;
    bool ok = bench_list_cases(cases, values, &stage, sweep);
    if (ok)
        log_note("%s: %d cases", stage.name, cases->count - first);
    ok = ok && measure_groups(&cases->items[first], cases->count - first, &stage, &protocol);
    image_free(&inspection.reference);
    stage_free(&stage);
    return ok;
}

static void print_sweep(const struct bench_cases *cases) {
    printf("%-16s %-18s %-28s %9s %9s %9s %9s %9s\n", "scene", "series", "settings", "ms",
           "rRMSE %", "bias %", "gradient", "FLIP");
    for (int i = 0; i < cases->count; i++) {
        const struct bench_case *c = &cases->items[i];
        printf("%-16s %-18s %-28s %9.2f", c->scene, c->series, c->label, c->wall_ms.median);
        if (c->errors.measured)
            printf(" %9.2f %+9.2f %9.4f %9.4f", 100 * c->errors.relative_rmse,
                   100 * c->errors.relative_bias, c->errors.gradient, c->errors.ldr_flip);
        printf("\n");
    }
}

static void print_machine(const struct bench_machine *machine) {
    printf("%s, %s, %s%s; %s, %d cores; commit %s\n\n", machine->vendor, machine->renderer,
           machine->version, machine->software ? " (software: passes timed with glFinish)" : "",
           machine->cpu, machine->cores, machine->commit);
}

static bool report(const struct bench_cases *cases, const struct bench_values *values,
                   const struct sweep *sweep, bool software) {
    struct bench_machine machine;
    bench_machine_read(&machine, software);
    print_machine(&machine);
    if (sweep->axis_count) {
        print_sweep(cases);
    } else {
        bench_print_table1(stdout, cases->items, cases->count);
        bench_print_ratios(stdout, cases->items, cases->count);
        for (int i = 0; i < cases->count; i++) {
            printf("\n");
            bench_print_table2(stdout, &cases->items[i]);
        }
    }
    return (!values->csv || bench_write_csv(values->csv, cases->items, cases->count, &machine)) &&
           (!values->json || bench_write_json(values->json, cases->items, cases->count, &machine));
}

static bool run(const struct bench_values *values, const char **scenes, int scene_count,
                const struct sweep *sweep) {
    struct context *context = context_create(&values->context);
    if (!context)
        return false;
    bool software = context_is_software(context), ok = true;
    struct bench_cases cases = {0};
    for (int i = 0; ok && i < scene_count; i++)
        ok = measure_scene(&cases, values, scenes[i], sweep, software);
    ok = ok && report(&cases, values, sweep, software);
    free(cases.items);
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
        return bench_chart(values.chart, values.output ? values.output : ".")
                   ? STATUS_OK
                   : arguments_fail(argv[0]);
    if (count == 0 && (count = pick_usual_scenes(scenes)) == 0) {
        error_set("no SCENE, and none of the usual ones is here");
        return arguments_misuse(argv[0]);
    }
    return run(&values, scenes, count, &sweep) ? STATUS_OK : arguments_fail(argv[0]);
}
