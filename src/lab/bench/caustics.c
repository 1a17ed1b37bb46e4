/* manylight bench caustics: Tables 8.1 and 8.2 of [Dong 2011 §8.5], times of airlight and of
 * caustics on surfaces and in a medium, with the thesis's own figures beside ours; and how they
 * grow with rays, pixels and lights. */
#include "lab/bench/bench.h"

#include "base/memory.h"

#include <cglm/vec3.h>
#include <string.h>

static const char *const scenes[] = {"scenes/ring.glb", "scenes/pawns.glb", "scenes/gem.glb", NULL};

/* Indirect light is as cheap as it can be. */
static const char *const variants[] = {
    "unshadowed:technique=unshadowed,vpls=64,rsm-size=64,samples=1,medium.scatter=.4,"
    "caustics.surface=patches,caustics.medium=lines",
    NULL};

/* GeForce GTX 280, 1024 x 1024, as many rays [Dong 2011, Table 8.1]. The caption there exchanges
 * surfaces and volume; our pawns stand for the Buddha. */
enum { STAGES = 3 };

static const char *const stage_names[STAGES] = {"airlight", "surface", "volume"};

static const struct {
    const char *scene;
    double ms[STAGES];
} paper_rows[] = {{"ring", {4.5, 15, 10}}, {"pawns", {5, 13, 9}}, {"gem", {5, 28, 21}}};

/* 16 times the rays take the thesis 2.1 to 2.8 times as long, 16 times the pixels 1.1 to
 * 1.5 times. */
static const char ray_axis[] = "caustics.size=128,256,512";

static double pass_of(const struct results *results, int subject, const char *name) {
    char path[64];
    snprintf(path, sizeof path, "frame/%s", name);
    return results_value(results, subject, path, NULL);
}

/* Rays serve surfaces and the medium alike. */
static void stages_of(const struct results *results, int subject, double ms[STAGES]) {
    double rays = pass_of(results, subject, "light rays") / 2;
    ms[0] = pass_of(results, subject, "airlight");
    ms[1] = pass_of(results, subject, "caustics") + rays;
    ms[2] = pass_of(results, subject, "light lines") + rays;
}

static double share_of(const double ms[STAGES], int stage) {
    double sum = ms[0] + ms[1] + ms[2];
    return sum > 0 ? 100 * ms[stage] / sum : 0;
}

static void print_stages(const struct results *results, int subject) {
    const char *scene = results->subjects[subject].scene;
    double ms[STAGES], frame = results_value(results, subject, "frame", NULL);
    stages_of(results, subject, ms);
    printf("\nTable 8.1: %s, %s, frame %.4g ms\n  %-10s %9s %9s %9s %9s %9s\n", scene,
           results->subjects[subject].desc.variant, frame, "stage", "ms", "% frame", "% of three",
           "paper ms", "paper %");
    for (int i = 0; i < STAGES; i++) {
        printf("  %-10s %9.4g %9.1f %9.1f", stage_names[i], ms[i], 100 * ms[i] / frame,
               share_of(ms, i));
        for (size_t p = 0; p < sizeof paper_rows / sizeof *paper_rows; p++)
            if (strcmp(paper_rows[p].scene, scene) == 0)
                printf(" %9.3g %9.1f", paper_rows[p].ms[i], share_of(paper_rows[p].ms, i));
        printf("\n");
    }
}

static void print_growth(const struct results *results, int first, int count, const char *of) {
    printf("\nTable 8.2: %s, over %s\n  %-24s %9s %9s %9s\n", results->subjects[first].scene, of,
           "", stage_names[0], stage_names[1], stage_names[2]);
    for (int i = first; i < first + count; i++) {
        const struct measure_desc *desc = &results->subjects[i].desc;
        double ms[STAGES];
        char size[32];
        stages_of(results, i, ms);
        snprintf(size, sizeof size, "%dx%d", desc->width, desc->height);
        printf("  %-10s %-13s %9.4g %9.4g %9.4g\n", size, desc->point, ms[0], ms[1], ms[2]);
    }
}

/* A subject for each place of the axis. */
static bool measure_axis(struct bench *bench, const char *axis, const char *of) {
    int first = bench->results.subject_count;
    struct measure_list subjects;
    bool ok = bench_list(bench, variants, axis, &subjects) &&
              bench_time(bench, &subjects, REFERENCE_NONE);
    if (ok)
        print_growth(&bench->results, first, subjects.count, of);
    free(subjects.items);
    return ok;
}

/* --- lights ----------------------------------------------------------------------------------- */

enum { COUNTS = 3 };

/* Whole frames of the thesis, from frames a second with one, two and four lights [Dong 2011 §8.5]:
 * not linear, as told. */
static const struct {
    int lights;
    double paper_ms;
} light_counts[COUNTS] = {{1, 1000 / 37.}, {2, 1000 / 21.5}, {4, 1000 / 2.9}};

/* All like the first, whose light they share. */
static struct emitters divide(const struct emitter *light, int count) {
    struct emitters many = {.items = mem_alloc((size_t)count, sizeof *many.items), .count = count};
    for (int i = 0; i < count; i++) {
        many.items[i] = *light;
        many.items[i].number = i;
        glm_vec3_divs(many.items[i].intensity, (float)count, many.items[i].intensity);
    }
    return many;
}

/* The first variant under so many lights. */
static bool time_lights(struct bench *bench, const struct measure_desc *subject, int count) {
    struct stage stage = *bench->stage;
    struct measure_desc desc = *subject;
    struct measure_list list = {0};
    stage.emitters = divide(&bench->stage->emitters.items[0], count);
    desc.stage = &stage;
    snprintf(desc.point, sizeof desc.point, "lights=%d", count);
    measure_list_add(&list, &desc);
    bool ok = bench_time(bench, &list, REFERENCE_NONE);
    emitters_free(&stage.emitters);
    free(list.items);
    return ok;
}

static void print_lights(const struct results *results, int first) {
    double one = results_value(results, first, "frame", NULL);
    printf("\nTable 8.2: %s, over lights\n  %-10s", results->subjects[first].scene, "lights");
    for (int i = 0; i < STAGES; i++)
        printf(" %9s", stage_names[i]);
    printf(" %9s %9s %9s %9s\n", "frame", "over one", "paper ms", "over one");
    for (int i = 0; i < COUNTS; i++) {
        double ms[STAGES], frame = results_value(results, first + i, "frame", NULL);
        stages_of(results, first + i, ms);
        printf("  %-10d %9.4g %9.4g %9.4g %9.4g %9.2f %9.3g %9.2f\n", light_counts[i].lights, ms[0],
               ms[1], ms[2], frame, frame / one, light_counts[i].paper_ms,
               light_counts[i].paper_ms / light_counts[0].paper_ms);
    }
}

static bool measure_lights(struct bench *bench, const struct measure_desc *subject) {
    int first = bench->results.subject_count;
    if (bench->stage->emitters.count == 0)
        return true;
    for (int i = 0; i < COUNTS; i++)
        if (!time_lights(bench, subject, light_counts[i].lights))
            return false;
    print_lights(&bench->results, first);
    return true;
}

/* --- the mode --------------------------------------------------------------------------------- */

static bool measure(struct bench *bench, const struct measure_list *subjects) {
    int w = bench->values.size[0], h = bench->values.size[1], first = bench->results.subject_count;
    char sizes[96];
    snprintf(sizes, sizeof sizes, "size=%dx%d,%dx%d,%dx%d", (w + 3) / 4, (h + 3) / 4, (w + 1) / 2,
             (h + 1) / 2, w, h);
    bench_expect(bench, 7 * subjects->count + COUNTS);
    if (!bench_time(bench, subjects, REFERENCE_NONE))
        return false;
    for (int i = 0; i < subjects->count; i++)
        print_stages(&bench->results, first + i);
    return measure_axis(bench, ray_axis, "rays a side") && measure_axis(bench, sizes, "pixels") &&
           measure_lights(bench, &subjects->items[0]);
}

const struct bench_mode bench_caustics = {
    .name = "caustics",
    .help = "times of airlight and caustics, as in Tables 8.1 and 8.2 of [Dong 2011]\n"
            "and how they grow with rays, pixels and lights. Without SCENE: ring, pawns and gem.",
    .options = "size variant set frames warm-up light" BENCH_CONTEXT,
    .variants = variants,
    .scenes = scenes,
    .measure = measure,
};
