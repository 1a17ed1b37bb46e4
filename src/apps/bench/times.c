/* manylight bench times: Tables 1 and 2 of the paper [Dong 2009 §7], with its own figures beside
 * ours. */
#include "apps/bench/bench.h"

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
    {"deferred rendering", "/gbuffer/shadow map/direct/antialias/composite/", .4, .8},
    {"VPL generation", "/rsm/vpls/", .1, .2},
    {"VAL clustering", "/clustering/", .5, 1.0},
    {"CSSM", "/cssm/map views/depth maps/", 4.2, 8.1},
    {"indirect illumination", "/gather/block visibility/near light/near field/", 35.0, 69.0},
    {"blur", "/blur/", 10.7, 21.0},
};

enum { STEPS = sizeof steps / sizeof *steps };

static void print_rates(const struct results *results) {
    int first = 0;
    printf("\nTable 1: frame rates\n  %-16s %-18s %9s %8s %10s %8s %9s %10s %8s\n", "scene",
           "variant", "size", "faces", "ms", "fps", "paper fps", "GPU memory", "of first");
    for (int i = 0; i < results->subject_count; i++) {
        const struct subject *subject = &results->subjects[i];
        char size[24], paper[16] = "-";
        double ms = results_value(results, i, "clock", NULL);
        snprintf(size, sizeof size, "%dx%d", subject->desc.width, subject->desc.height);
        for (size_t k = 0; k < sizeof paper_rates / sizeof *paper_rates; k++)
            if (strcmp(paper_rates[k].scene, subject->scene) == 0)
                snprintf(paper, sizeof paper, "%.1f", paper_rates[k].fps);
        if (strcmp(results->subjects[first].scene, subject->scene) != 0)
            first = i;
        printf("  %-16s %-18s %9s %8u %10.2f %8.2f %9s %6.1f MiB %8.2f\n", subject->scene,
               subject->desc.variant, size, subject->faces, ms, 1e3 / ms, paper,
               results_value(results, i, "gpu-memory", NULL),
               ms / results_value(results, first, "clock", NULL));
    }
}

/* The pass of a row directly below the frame; NULL: another row. */
static const char *top_pass(const struct result *row) {
    const char *name = row->what + strlen("frame/");
    return strncmp(row->what, "frame/", strlen("frame/")) == 0 && !strchr(name, '/') ? name : NULL;
}

static bool belongs(const struct step *step, const char *pass) {
    char word[TIMER_PATH_SIZE];
    snprintf(word, sizeof word, "/%s/", pass);
    return strstr(step->passes, word);
}

/* All passes, those within others too. Returns the sum of those that are in no other. */
static double print_passes(const struct results *results, int subject, double frame) {
    const struct measure_desc *desc = &results->subjects[subject].desc;
    double sum = 0, pixels = measure_pixels(desc), pixel_vpls = measure_pixel_vpls(desc);
    for (int i = 0; i < results->row_count; i++) {
        const struct result *row = &results->rows[i];
        if (row->subject != subject || strncmp(row->what, "frame", 5) != 0)
            continue;
        const struct summary *ms = &row->figure;
        printf("  %-32s %9.3f %9.3f %9.3f %9.3f %9.3f %6.1f %9.3g", row->what, ms->value, ms->p5,
               ms->p95, ms->minimum, ms->maximum, 100 * ms->value / frame,
               1e6 * ms->value / pixels);
        if (pixel_vpls > 0)
            printf(" %9.3g", 1e6 * ms->value / pixel_vpls);
        printf("\n");
        sum += top_pass(row) ? ms->value : 0;
    }
    return sum;
}

static double step_ms(const struct results *results, int subject, const struct step *step) {
    double sum = 0;
    for (int i = 0; i < results->row_count; i++) {
        const struct result *row = &results->rows[i];
        if (row->subject == subject && top_pass(row) && belongs(step, top_pass(row)))
            sum += row->figure.value;
    }
    return sum;
}

static void print_steps(const struct results *results, int subject) {
    const struct measure_desc *desc = &results->subjects[subject].desc;
    const struct result *whole = results_find(results, subject, "frame", NULL);
    double frame = whole->figure.value;
    printf(
        "\nTable 2: %s, %s, %dx%d, medians of %d frames\n  %-32s %9s %9s %9s %9s %9s %6s %9s %9s\n",
        results->subjects[subject].scene, desc->variant, desc->width, desc->height,
        whole->figure.count, "pass", "ms", "p5", "p95", "min", "max", "%", "ns/pixel", "and VPL");
    double sum = print_passes(results, subject, frame);
    printf("  sum of passes %.3f ms, whole frame %.3f ms, without timers %.3f ms\n", sum, frame,
           results_value(results, subject, "clock", NULL));
    printf("  %-32s %9s %9s %9s %9s\n", "step of the paper", "ms", "%", "paper ms", "paper %");
    for (const struct step *step = steps; step < steps + STEPS; step++) {
        double ms = step_ms(results, subject, step);
        printf("  %-32s %9.3f %9.1f %9.1f %9.1f\n", step->name, ms, 100 * ms / frame, step->ms,
               step->percent);
        sum -= ms;
    }
    if (sum > 1e-6)
        printf("  %-32s %9.3f %9.1f\n", "other", sum, 100 * sum / frame);
}

static bool measure(struct bench *bench, const struct measure_desc *descs, int count) {
    return bench_time(bench, descs, count, TRUTH_NONE);
}

static bool finish(struct bench *bench) {
    results_print_machine(stdout, context_is_software(bench->context));
    print_rates(&bench->results);
    for (int i = 0; i < bench->results.subject_count; i++)
        print_steps(&bench->results, i);
    return true;
}

static const struct option options[] = {
    BENCH_SIZE(800), BENCH_VARIANTS, BENCH_SETTINGS, BENCH_FRAMES, BENCH_CSV, BENCH_CONTEXT, {NULL},
};

const struct bench_mode bench_times = {
    .name = "times",
    .help = "time of a frame, pass by pass, as in the paper's Tables 1 and 2",
    .synopsis = "[SCENE ...] [OPTION ...]",
    .summary = "Measures how long frames take, pass by pass, as in the paper's Tables 1 and 2.\n"
               "Without SCENE: the paper's four scenes, from the folder scenes.",
    .options = options,
    .usual = bench_usual_variants,
    .measure = measure,
    .finish = finish,
};
