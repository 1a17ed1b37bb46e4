/* manylight bench direct: how true the share of the lights that is seen is, against time, by each
 * method of direct light. */
#include "lab/bench/bench.h"

#include <stdlib.h>

/* Variant with as little indirect light as possible. */
#define DIRECT_ALONE                                                                               \
    "technique=unshadowed,vpls=1,rsm-size=16,interleave=1,near-samples=1,clamp=none,adaptive=0,"   \
    "blur.radius=0,picture.samples=1"

/* A method along its main setting. */
struct series {
    const char *variant, *axis;
};

static const struct series of_lamps[] = {
    {"hard:direct=hard," DIRECT_ALONE, "shadow-size=512,2048"},
    {"samples:direct=samples," DIRECT_ALONE, "samples.points=4,16,64"},
    {"pcss:direct=pcss," DIRECT_ALONE, "light-taps=12,24,48,96,192"},
    {"cssm:direct=cssm," DIRECT_ALONE, "harmonics=4,8,16"},
    {"cssm by sums:direct=cssm,cssm.prefilter=sat," DIRECT_ALONE, "harmonics=4,8,16"},
    {"vssm:direct=vssm," DIRECT_ALONE, "texels=256,512,1024,2048"},
    {"msm:direct=msm," DIRECT_ALONE, "texels=256,512,1024,2048"},
    {NULL, NULL},
};

/* A sky's lights are the same whichever method the lamps have. */
static const struct series of_skies[] = {
    {"even parts:" DIRECT_ALONE, "sky.lights=15,30,60,120"},
    {"rectangles:fit=rectangles," DIRECT_ALONE, "sky.lights=30,60"},
    {"shadow rays:" DIRECT_ALONE, "sky.shadow-rays=3,16"},
    {NULL, NULL},
};

static bool add_series(const struct bench *bench, const struct series *series,
                       struct measure_list *list) {
    struct measure_list points = {0};
    struct measure_desc desc;
    bool ok = bench_prepare(bench, series->variant, &desc);
    measure_list_add(&points, &desc);
    ok = ok && measure_vary(&points, series->axis);
    for (int i = 0; ok && i < points.count; i++)
        measure_list_add(list, &points.items[i]);
    free(points.items);
    return ok;
}

/* Those of --variant at the points of --vary, through pixels' centres as the reference is; or all
 * methods. */
static bool list_methods(const struct bench *bench, const struct measure_list *asked,
                         struct measure_list *list) {
    const struct series *series = bench->stage->emitters.sky ? of_skies : of_lamps;
    bool ok = true;
    for (int i = 0; ok && bench->values.variants.count && i < asked->count; i++) {
        measure_list_add(list, &asked->items[i]);
        ok = measure_assign(&list->items[i], "picture.samples=1");
    }
    for (; ok && !bench->values.variants.count && series->variant; series++)
        ok = add_series(bench, series, list);
    return ok;
}

static bool measure(struct bench *bench, const struct measure_list *subjects) {
    struct measure_list list = {0};
    bool ok = list_methods(bench, subjects, &list);
    bench_expect(bench, list.count);
    ok = ok && bench_time(bench, &list, REFERENCE_SEEN);
    free(list.items);
    return ok;
}

static const char *const scenes[] = {"scenes/table.glb", "scenes/plant.glb", NULL};

const struct bench_mode bench_direct = {
    .name = "direct",
    .help = "visible fraction of the lights by each method of direct light\n"
            "Varies the main setting of each method, or for an environment the settings of its\n"
            "lights, and compares with the path tracer. Errors are over the pixels where the\n"
            "unoccluded lights reach 1 % of their maximum; the column \"faint too\" has all "
            "pixels. The\n"
            "squared noise of the reference is subtracted. Frames have next to no indirect light.\n"
            "Without SCENE: table and plant.",
    .options = "vary size variant set frames warm-up noise cache light environment" BENCH_CONTEXT,
    .scenes = scenes,
    .measure = measure,
    .tables = {{"share of the lights that is seen",
                {{"ms", "clock", NULL},
                 {"CPU ms", "cpu", NULL},
                 {"RMS %", "visible-share", NULL},
                 {"bias %", "visible-bias", NULL},
                 {"faint too", "visible-share-all", NULL},
                 {"noise %", "visible-noise", NULL},
                 {"GPU MiB", "gpu-memory", NULL}}}},
};
