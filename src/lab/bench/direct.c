/* manylight bench direct: how true the share of the lights that is seen is, against time, by each
 * method of direct light. */
#include "lab/bench/bench.h"

#include "base/error.h"
#include "base/memory.h"

#include <string.h>

/* Variant with as little indirect light as possible. */
#define DIRECT_ALONE                                                                               \
    "technique=unshadowed,vpls=1,rsm-size=16,interleave=1,near-samples=1,clamp=none,adaptive=0,"   \
    "blur.radius=0,picture.samples=1"

/* --- Table 5.1: MIP maps and summed area tables, from one light to many ----------------------- */

enum { SIZES = 3, COUNTS = 3, FILTERS = 2 };

static const int sizes[SIZES] = {128, 256, 512}, counts[COUNTS] = {1, 10, 20};

/* Frames a second on a GeForce 8800 GTX, K = 4; there is a row more, of 1024 texels, where its
 * memory ran out. */
static const double published_fps[FILTERS][SIZES][COUNTS] = {
    {{258, 48, 28}, {228, 44, 25}, {189, 38, 20}},
    {{128, 15, 8.8}, {110, 13, 7.5}, {89, 11, 6}},
};

static const char *const filters[FILTERS] = {
    "MIP:direct=cssm,harmonics=4," DIRECT_ALONE,
    "SAT:direct=cssm,harmonics=4,cssm.prefilter=sat," DIRECT_ALONE,
};

/* Repeats the first light until there are `count` lights. */
static struct emitters repeat(const struct emitter *light, int count) {
    struct emitters many = {.items = mem_alloc((size_t)count, sizeof *many.items), .count = count};
    for (int i = 0; i < count; i++) {
        many.items[i] = *light;
        many.items[i].number = i;
    }
    return many;
}

static bool add_subject(const struct bench *bench, const struct stage *stage, const char *variant,
                        int size, struct measure_list *list) {
    struct measure_desc desc;
    char *maps = mem_printf("texels=%d,shadow-size=%d", size, size);
    bool ok = bench_prepare(bench, variant, &desc) && measure_assign(&desc, maps);
    desc.stage = stage;
    snprintf(desc.point, sizeof desc.point, "texels=%d lamps=%d", size, stage->emitters.count);
    measure_list_add(list, &desc);
    free(maps);
    return ok;
}

/* Measures all sizes of one filter with this number of lights. */
static bool time_filter(struct bench *bench, int filter, int count, double ms[SIZES]) {
    struct stage stage = *bench->stage;
    struct measure_list list = {0};
    int first = bench->results.subject_count;
    stage.emitters = repeat(&bench->stage->emitters.items[0], count);
    bool ok = true;
    for (int i = 0; ok && i < SIZES; i++)
        ok = add_subject(bench, &stage, filters[filter], sizes[i], &list);
    ok = ok && bench_time(bench, &list, REFERENCE_NONE);
    for (int i = 0; ok && i < SIZES; i++)
        ms[i] = results_value(&bench->results, first + i, gl.software ? "cpu" : "clock", NULL);
    emitters_free(&stage.emitters);
    free(list.items);
    return ok;
}

static void print_lights(double ms[FILTERS][COUNTS][SIZES]) {
    printf("Table 5.1: a frame%s, in brackets the thesis's\n  %-8s %-8s",
           gl.software ? ", CPU time" : "", "texels", "lights");
    printf(" %10s %10s %18s %18s %18s\n", "MIP ms", "SAT ms", "SAT over MIP", "MIP over 1 light",
           "SAT over 1 light");
    for (int s = 0; s < SIZES; s++)
        for (int c = 0; c < COUNTS; c++) {
            const double *mip = published_fps[0][s], *sat = published_fps[1][s];
            printf("  %-8d %-8d %10.1f %10.1f %9.2f (%6.2f) %9.2f (%6.2f) %9.2f (%6.2f)\n",
                   sizes[s], counts[c], ms[0][c][s], ms[1][c][s], ms[1][c][s] / ms[0][c][s],
                   mip[c] / sat[c], ms[0][c][s] / ms[0][0][s], mip[0] / mip[c],
                   ms[1][c][s] / ms[1][0][s], sat[0] / sat[c]);
        }
}

static bool time_lights(struct bench *bench) {
    double ms[FILTERS][COUNTS][SIZES];
    for (int filter = 0; filter < FILTERS; filter++)
        for (int c = 0; c < COUNTS; c++)
            if (!time_filter(bench, filter, counts[c], ms[filter][c]))
                return false;
    print_lights(ms);
    return true;
}

/* --- Tables 7.1 and 7.2: where the time of variance soft shadow maps goes --------------------- */

enum { STEPS = 5, SHARES = 3 };

enum { DIRECT_TABLES_SUBJECTS = FILTERS * COUNTS * SIZES + SHARES };

static const int share_sizes[SHARES] = {512, 1024, 2048};

/* Plant, 141,000 faces, GeForce GTX 285, 1024 x 768, ms; and our passes of the same step. */
static const struct step {
    const char *name, *passes[2];
    double published[SHARES];
} steps[STEPS] = {
    {"G-buffer", {"frame/gbuffer"}, {1.7, 2, 2}},
    {"shadow map", {"frame/shadow map", "frame/light maps"}, {.17, .25, .5}},
    {"least and greatest depth", {"frame/depth bounds"}, {.18, .3, 1}},
    {"summed area table", {"frame/sums"}, {2.1, 4.8, 17.9}},
    {"soft shadow", {"frame/direct"}, {2.5, 3.5, 4.4}},
};

static double step_ms(const struct results *results, int subject, const struct step *step) {
    double sum = 0;
    for (int i = 0; i < 2 && step->passes[i]; i++)
        sum += results_value(results, subject, step->passes[i], NULL);
    return sum;
}

static void print_shares(const struct results *results, int first) {
    double all[SHARES] = {0}, published[SHARES] = {0};
    printf("Tables 7.1 and 7.2: share of the steps of variance soft shadow maps, %%, in brackets "
           "the thesis's\n  %-26s",
           "texels");
    for (int i = 0; i < SHARES; i++) {
        printf(" %17d", share_sizes[i]);
        for (int s = 0; s < STEPS; s++) {
            all[i] += step_ms(results, first + i, &steps[s]);
            published[i] += steps[s].published[i];
        }
    }
    for (int s = 0; s < STEPS; s++) {
        printf("\n  %-26s", steps[s].name);
        for (int i = 0; i < SHARES; i++)
            printf(" %8.1f (%6.1f)", 100 * step_ms(results, first + i, &steps[s]) / all[i],
                   100 * steps[s].published[i] / published[i]);
    }
    printf("\n  %-26s", "all, ms");
    for (int i = 0; i < SHARES; i++)
        printf(" %8.1f (%6.2f)", all[i], published[i]);
    printf("\n");
}

static bool time_shares(struct bench *bench) {
    struct stage stage = *bench->stage;
    struct measure_list list = {0};
    int first = bench->results.subject_count;
    stage.emitters = repeat(&bench->stage->emitters.items[0], 1);
    bool ok = true;
    for (int i = 0; ok && i < SHARES; i++)
        ok = add_subject(bench, &stage, "VSSM:direct=vssm," DIRECT_ALONE, share_sizes[i], &list);
    ok = ok && bench_time(bench, &list, REFERENCE_NONE);
    if (ok)
        print_shares(&bench->results, first);
    emitters_free(&stage.emitters);
    free(list.items);
    return ok;
}

/* Measures tables 5.1, 7.1 and 7.2 of the thesis as ratios and shares. The scene's first light must
 * be a lamp. Error: there is none, or of a renderer. */
static bool direct_tables(struct bench *bench) {
    if (bench->stage->emitters.count == 0)
        return error_set("%s has no lamp for the tables", bench->stage->name);
    return time_shares(bench) && time_lights(bench);
}

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
    bench_expect(bench, list.count + (bench->values.tables ? DIRECT_TABLES_SUBJECTS : 0));
    ok = ok && bench_time(bench, &list, REFERENCE_SEEN);
    free(list.items);
    return ok && (!bench->values.tables || direct_tables(bench));
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
    .options =
        "vary size variant set frames warm-up noise cache light environment tables" BENCH_CONTEXT,
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
