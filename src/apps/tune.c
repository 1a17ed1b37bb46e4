/* manylight tune: what frames cost on this machine, for those who choose by it. */
#include "apps/apps.h"
#include "apps/arguments.h"
#include "apps/options.h"

#include "apps/bench/measure/result_rows.h"
#include "base/clock.h"
#include "base/error.h"
#include "base/file/folder.h"
#include "base/file/output_file.h"
#include "base/log.h"
#include "base/memory.h"
#include "base/progress.h"
#include "quality/costs.h"
#include "quality/measure.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SCENES_MAX = 16 };

struct values {
    struct common_values common;
    struct context_desc context;
    const char *output;
    int size[2], frames;
};

static const struct option options[] = {
    {"size", 0, OPTION_SIZE, offsetof(struct values, size), 400, 1, 16384,
     .help = "size of the frames, pixels"},
    {"frames", 0, OPTION_INT, offsetof(struct values, frames), 3, 1, 1000,
     .help = "number of frames per choice after one\n"
             "warm-up frame; the fastest counts"},
    {"output", 'o', OPTION_TEXT, offsetof(struct values, output), .value_name = "FILE",
     .help = "file of the table [one per machine in $XDG_CACHE_HOME/manylight]"},
    CONTEXT_OPTIONS(struct values, context),
    {NULL},
};

static const struct arguments arguments = {
    .synopsis = "[SCENE ...] [OPTION ...]",
    .summary =
        "Times all choices of --max-error, --budget and the viewer's presets on this machine, "
        "prints\n"
        "the times and stores them for its OpenGL driver, its cores and the version of the "
        "program.\n"
        "--max-error then tries the cheapest choice first, --budget starts from the times, and "
        "the\n"
        "viewer shows them. --quality keeps its settings. Without a table, and with\n"
        "--shipped-costs, the costs that come with the program are used. Without SCENE: "
        "cornell-box\n"
        "and atrium; of several scenes the mean of ratios counts. Keep the machine idle meanwhile.",
    .options = options,
    .opens_scenes = true,
    .shows_progress = true,
    .max_positional = SCENES_MAX,
};

/* How far the work is. */
struct work {
    struct progress progress;
    int done, count; /* choices of all scenes */
};

/* The fastest of the frames, ms. */
static double time_frames(struct renderer *renderer, int frames) {
    double least = INFINITY;
    renderer->timers.enabled = false;
    renderer_render(renderer);
    for (int i = 0; i < frames; i++) {
        gl.Finish();
        double start = clock_ms();
        renderer_render(renderer);
        gl.Finish();
        least = fmin(least, clock_ms() - start);
    }
    return least;
}

/* Adds to the sum of logarithms that the cost holds meanwhile. */
static bool time_choice(const struct values *values, const struct stage *stage, struct cost *cost) {
    struct renderer renderer;
    struct measure_desc desc = measure_default(stage, values->size[0], values->size[1]);
    if (!measure_assign(&desc, cost->choice) || !measure_start(&renderer, &desc))
        return error_prefix("%s: %s", stage->name, cost->choice);
    cost->ms += log(time_frames(&renderer, values->frames));
    renderer_free(&renderer);
    return true;
}

static bool time_scene(const struct values *values, const char *path, struct costs *costs,
                       struct work *work) {
    struct stage stage;
    if (!stage_init(&stage, &(struct stage_desc){.path = path}))
        return false;
    bool ok = true;
    for (int i = 0; ok && i < costs->count; i++) {
        char note[256];
        snprintf(note, sizeof note, "%s: %s", stage.name, costs->items[i].choice);
        progress_show_work(&work->progress, (double)work->done++ / work->count, note);
        ok = time_choice(values, &stage, &costs->items[i]);
    }
    stage_free(&stage);
    return ok;
}

static bool time_all(const struct values *values, const char *const *scenes, int count,
                     struct costs *costs) {
    struct work work = {.count = count * costs->count};
    bool ok = true;
    progress_start(&work.progress, "choices");
    for (int i = 0; ok && i < count; i++)
        ok = time_scene(values, scenes[i], costs, &work);
    progress_end(&work.progress);
    for (int i = 0; i < costs->count; i++)
        costs->items[i].ms = exp(costs->items[i].ms / count);
    return ok;
}

static int by_cost(const void *a, const void *b) {
    const struct cost *x = a, *y = b;
    return (x->ms > y->ms) - (x->ms < y->ms);
}

static void print_table(const struct costs *costs) {
    double normal = costs_find(costs, NULL, "");
    printf("%10s %10s  %s\n", "ms", "of normal", "choice");
    for (int i = 0; i < costs->count; i++)
        printf("%10.3f %10.2f  %s\n", costs->items[i].ms, costs->items[i].ms / normal,
               costs->items[i].choice);
}

static bool tune(const struct values *values, const char *const *scenes, int count) {
    struct costs costs;
    struct context *context = context_create(&values->context);
    if (!context)
        return false;
    char *path = values->output ? mem_strdup(values->output) : costs_path();
    result_rows_print_machine();
    costs_list(&costs);
    bool ok = path && (!values->output || output_file_check(path, scenes, count)) &&
              time_all(values, scenes, count, &costs);
    if (ok) {
        qsort(costs.items, (size_t)costs.count, sizeof *costs.items, by_cost);
        print_table(&costs);
        ok = costs_write(&costs, path);
    }
    if (ok)
        printf("written to %s\n", path);
    costs_free(&costs);
    free(path);
    context_free(context);
    return ok;
}

int app_tune(int argc, char **argv) {
    static const char *const own[] = {"scenes/cornell-box.glb", "scenes/atrium.glb"};
    enum { OWN = sizeof own / sizeof *own };
    struct values values = {0};
    const char *scenes[SCENES_MAX];
    char *found[OWN] = {NULL};
    int count, status;
    if (!arguments_parse(&arguments, &values, argc, argv, scenes, &count, &status))
        return status;
    bool none = count == 0;
    for (int i = 0; none && i < OWN; i++)
        scenes[count++] = found[i] = folder_find_own(own[i]);
    if (values.output && output_file_is_stdout(values.output)) {
        error_set("-o -: standard output has the table for you; name a file");
        status = arguments_misuse(argv[0]);
    } else {
        status = tune(&values, scenes, count) ? STATUS_OK : arguments_fail(argv[0]);
    }
    for (int i = 0; i < OWN; i++)
        free(found[i]);
    return status;
}
