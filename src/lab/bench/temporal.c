/* manylight bench temporal: how steady moving pictures are. */
#include "lab/bench/bench.h"

#include "lab/measure/clip.h"

/* The clustering's starts beside what is compared anyway. */
static const char *const variants[] = {
    "instant-radiosity",
    "paper",
    "fast",
    "warm:technique=clustered,start=warm",
    "reseed:technique=clustered,start=reseed",
    NULL,
};

static const char *const scenes[] = {"scenes/moving-spot.glb", "scenes/metaballs.glb",
                                     "scenes/door.glb", NULL};

static bool measure(struct bench *bench, const struct measure_list *subjects) {
    struct clip_desc clip = {
        .stage = bench->stage,
        .subjects = subjects,
        .frames = bench->values.frames ? bench->values.frames : 50,
        .reference = bench_reference(bench, (enum reference_kind)bench->values.reference),
    };
    bench_expect(bench, clip_subjects(&clip));
    return bench_prepare(bench, reference_vpls, &clip.all_vpls) &&
           clip_measure(&bench->results, &clip);
}

const struct bench_mode bench_temporal = {
    .name = "temporal",
    .help =
        "flicker over a clip, VALs in use, and memory\n"
        "Flicker is the change from frame to frame beyond the change of the reference, over its\n"
        "mean. Without SCENE: moving-spot, metaballs and door.",
    .options = "size variant set frames reference noise" BENCH_CONTEXT,
    .variants = variants,
    .scenes = scenes,
    .measure = measure,
    .tables =
        {{"change beyond the reference's over its mean; travel of VALs' centres over that of VPLs",
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
           {"ever most", "most-resident", NULL}}}},
};
