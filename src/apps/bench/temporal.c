/* manylight bench temporal: how steady moving pictures are. */
#include "apps/bench/bench.h"

#include "base/error.h"
#include "measure/clip.h"

/* The clustering's starts beside what is compared anyway. */
static const char *const usual[] = {
    "instant-radiosity",
    "paper",
    "fast",
    "warm:technique=clustered,start=warm",
    "reseed:technique=clustered,start=reseed",
    NULL,
};

static const struct table tables[] = {
    {"change beyond the reference's over its mean; travel of VALs' centres over that of VPLs",
     {{"flicker %", "flicker", NULL},
      {"worst %", "worst-flicker", NULL},
      {"at s", "worst-time", NULL},
      {"VALs least", "least-vals", NULL},
      {"most", "most-vals", NULL},
      {"travel", "travel", NULL}}},
    {"MiB",
     {{"GL objects", "gl-objects", NULL},
      {"of GL", "gpu-memory", NULL},
      {"resident", "resident-memory", NULL},
      {"ever most", "most-resident", NULL}}},
    {.title = NULL},
};

static bool check(struct bench *bench) {
    return bench->argument_count || error_set("SCENE is missing");
}

static bool measure(struct bench *bench, const struct measure_desc *descs, int count) {
    struct clip_desc clip = {
        .stage = &bench->stage,
        .subjects = descs,
        .count = count,
        .frames = bench->values.frames,
        .truth = bench_truth(bench, (enum truth_kind)bench->values.reference),
    };
    return bench_prepare(bench, &bench->stage, truth_vpls, &clip.reference) &&
           clip_measure(&bench->results, &clip);
}

static const struct option options[] = {
    {"frames", 0, OPTION_INT, BENCH_VALUE(frames), 50, 2, 100000,
     .help = "spread over each scene's clip"},
    {"reference", 0, OPTION_CHOICE, BENCH_VALUE(reference), TRUTH_VPLS, .choices = truth_names,
     .help = "all VPLs with a map each; or traced in each frame, of one bounce (centers: through\n"
             "pixels' centres)"},
    BENCH_SIZE(800),
    BENCH_VARIANTS,
    BENCH_SETTINGS,
    BENCH_NOISE,
    BENCH_CSV,
    BENCH_CONTEXT,
    {NULL},
};

const struct bench_mode bench_temporal = {
    .name = "temporal",
    .help = "flicker over a clip, VALs in use, and memory",
    .synopsis = "SCENE [SCENE ...] [OPTION ...]",
    .summary = "Measures how steady moving pictures are: what changes from frame to frame beyond\n"
               "what changes in the reference, over its mean.",
    .options = options,
    .check = check,
    .usual = usual,
    .measure = measure,
    .tables = tables,
};
