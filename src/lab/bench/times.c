/* manylight bench times: Tables 1 and 2 of the paper [Dong 2009 §7], with its own figures beside
 * ours. */
#include "lab/bench/bench.h"

#include "base/error.h"

#include <string.h>

/* GeForce 8800 GTX, 800 x 800, N = 1024, M = 30 [Dong 2009, Table 1]. Our scenes stand for the
 * paper's of the same kind and number of faces. */
static const struct {
    const char *scene;
    double fps;
} paper_rates[] = {
    {"cornell-box", 20.4}, {"cornell-animal", 19.7}, {"cornell-horse", 19.7},
    {"atrium", 13.4},      {"sponza-98k", 13.4},     {"metaballs", 20.7},
};

/* Cornell Horse [Dong 2009, Table 2], and which passes of ours are the same. */
static const struct step {
    const char *name, *passes;
    double ms, percent;
} steps[] = {
    {"deferred rendering",
     "/gbuffer/shadow map/light maps/depth "
     "bounds/sums/range/basis/mips/direct/antialias/composite/",
     .4, .8},
    {"VPL generation", "/rsm/vpls/", .1, .2},
    {"VAL clustering", "/clustering/", .5, 1.0},
    {"VAL maps", "/maps/depth maps/", 4.2, 8.1},
    {"indirect illumination",
     "/gather/block visibility/near light/near field/adaptive/adaptive gather/"
     "adaptive near field/",
     35.0, 69.0},
    {"blur", "/blur/", 10.7, 21.0},
};

enum { STEPS = sizeof steps / sizeof *steps };

static const struct table rates = {NULL,
                                   {{"ms", "clock", NULL},
                                    {"fps", "fps", NULL},
                                    {"of first", "of-first", NULL},
                                    {"GPU MiB", "gpu-memory", NULL}}};

static void print_rates(const struct results *results, int first) {
    struct table table = rates;
    char title[64] = "Table 1, frame rates";
    for (size_t i = 0; i < sizeof paper_rates / sizeof *paper_rates; i++)
        if (strcmp(paper_rates[i].scene, results->subjects[first].scene) == 0)
            snprintf(title, sizeof title, "Table 1, frame rates (paper: %.1f fps)",
                     paper_rates[i].fps);
    table.title = title;
    results_print(results, first, &table, -1);
}

/* Of a pass directly below the frame: which step of the paper's it belongs to; STEPS: to none, -1:
 * it is the frame, or within another pass. */
static int step_of(const char *path) {
    char word[TIMER_PATH_SIZE];
    const char *name = strchr(path, '/');
    if (!name || strchr(name + 1, '/'))
        return -1;
    snprintf(word, sizeof word, "%s/", name);
    for (int i = 0; i < STEPS; i++)
        if (strstr(steps[i].passes, word))
            return i;
    return STEPS;
}

/* All passes, those within others too; adds up what belongs to each step. */
static void print_passes(const struct results *results, int subject, double frame,
                         double sums[STEPS + 1]) {
    const struct measure_desc *desc = &results->subjects[subject].desc;
    double pixels = measure_pixels(desc), pixel_vpls = measure_pixel_vpls(desc);
    for (int i = 0; i < results->row_count; i++) {
        const struct result *row = &results->rows[i];
        const struct summary *ms = &row->figure;
        if (row->subject != subject || strncmp(row->what, "frame", 5) != 0)
            continue;
        printf("  %-32s %9.3f %9.3f %9.3f %9.3f %9.3f %6.1f %9.3g", row->what, ms->value, ms->p5,
               ms->p95, ms->minimum, ms->maximum, 100 * ms->value / frame,
               1e6 * ms->value / pixels);
        printf(pixel_vpls > 0 ? " %9.3g\n" : "\n", 1e6 * ms->value / pixel_vpls);
        if (step_of(row->what) >= 0)
            sums[step_of(row->what)] += ms->value;
    }
}

static void print_times(const struct results *results, int subject) {
    const struct measure_desc *desc = &results->subjects[subject].desc;
    const struct result *whole = results_find(results, subject, "frame", NULL);
    double frame = whole->figure.value, sums[STEPS + 1] = {0}, sum = 0;
    printf("\nTable 2: %s, %s, %dx%d, medians of %d frames\n", results->subjects[subject].scene,
           desc->variant, desc->width, desc->height, whole->figure.count);
    printf("  %-32s %9s %9s %9s %9s %9s %6s %9s %9s\n", "pass", "ms", "p5", "p95", "min", "max",
           "%", "ns/pixel", measure_pixel_vpls(desc) > 0 ? "and VPL" : "");
    print_passes(results, subject, frame, sums);
    for (int i = 0; i <= STEPS; i++)
        sum += sums[i];
    printf("  sum of passes %.3f ms, whole frame %.3f ms, without timers %.3f ms\n", sum, frame,
           results_value(results, subject, "clock", NULL));
    printf("  %-32s %9s %9s %9s %9s\n", "step of the paper", "ms", "%", "paper ms", "paper %");
    for (int i = 0; i < STEPS; i++)
        printf("  %-32s %9.3f %9.1f %9.1f %9.1f\n", steps[i].name, sums[i], 100 * sums[i] / frame,
               steps[i].ms, steps[i].percent);
    if (sums[STEPS] > 0)
        printf("  %-32s %9.3f %9.1f\n", "other", sums[STEPS], 100 * sums[STEPS] / frame);
}

static bool measure(struct bench *bench, const struct measure_list *subjects) {
    int first = bench->results.subject_count;
    if (bench->values.picture && (subjects->count != 1 || bench->argument_count != 1))
        return error_set("--picture is of one SCENE and one --variant");
    bench_expect(bench, subjects->count);
    if (!bench_time(bench, subjects, REFERENCE_NONE))
        return false;
    print_rates(&bench->results, first);
    return true;
}

static bool finish(struct bench *bench) {
    for (int i = 0; i < bench->results.subject_count && !bench->values.whole_frames; i++)
        print_times(&bench->results, i);
    return true;
}

const struct bench_mode bench_times = {
    .name = "times",
    .help = "time of each pass of a frame, as in the paper's Tables 1 and 2\n"
            "Without SCENE: the paper's four scenes, from scenes/ here or the installed ones.",
    .options =
        "size variant set frames warm-up whole-frames picture light environment" BENCH_CONTEXT,
    .variants = bench_variants,
    .measure = measure,
    .finish = finish,
};
