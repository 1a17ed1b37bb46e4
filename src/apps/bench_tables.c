#include "apps/bench_tables.h"

#include "shared/vpl.h"

#include <string.h>

/* GeForce 8800 GTX, 800 x 800, N = 1024, M = 30 [Dong 2009, Table 1]. Our scenes stand for the
 * paper's of the same kind and number of faces. */
static double paper_fps(const char *scene) {
    static const struct {
        const char *scene;
        double fps;
    } rows[] = {
        {"cornell-box", 20.4}, {"cornell-animal", 19.7}, {"cornell-horse", 19.7},
        {"atrium", 13.4},      {"sponza-98k", 13.4},     {"metaballs", 20.7},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (strcmp(rows[i].scene, scene) == 0)
            return rows[i].fps;
    return 0;
}

/* Cornell Horse [Dong 2009, Table 2]. */
static const struct {
    double ms, percent;
} paper_steps[STEP_COUNT] = {
    [STEP_DEFERRED] = {.4, .8}, [STEP_VPLS] = {.1, .2},         [STEP_CLUSTERING] = {.5, 1.0},
    [STEP_CSSM] = {4.2, 8.1},   [STEP_INDIRECT] = {35.0, 69.0}, [STEP_BLUR] = {10.7, 21.0},
};

void bench_print_table1(FILE *out, const struct bench_case *cases, int count) {
    fprintf(out, "Table 1: frame rates\n");
    fprintf(out, "  %-16s %-18s %9s %8s %6s %5s %9s %9s %9s %10s\n", "scene", "variant", "size",
            "faces", "VPLs", "VALs", "ms", "fps", "paper fps", "GPU memory");
    for (int i = 0; i < count; i++) {
        const struct bench_case *c = &cases[i];
        char size[24], paper[16] = "-";
        snprintf(size, sizeof size, "%dx%d", c->width, c->height);
        if (paper_fps(c->scene) > 0)
            snprintf(paper, sizeof paper, "%.1f", paper_fps(c->scene));
        fprintf(out, "  %-16s %-18s %9s %8u %6d %5d %9.2f %9.2f %9s %6.1f MiB\n", c->scene,
                c->series, size, c->faces, (int)settings_number(&c->settings, "vpls"),
                (int)settings_number(&c->settings, "vals"), c->wall_ms.median,
                1e3 / c->wall_ms.median, paper, c->gpu_memory);
    }
}

void bench_print_table2(FILE *out, const struct bench_case *measured) {
    double frame = bench_frame_ms(measured), sum = bench_sum_ms(measured);
    fprintf(out, "Table 2: %s, %s, %dx%d\n", measured->scene, measured->series, measured->width,
            measured->height);
    fprintf(out, "  %-24s %10s %7s %12s %8s\n", "step", "ms", "%", "paper ms", "paper %");
    for (int step = 0; step < STEP_COUNT; step++) {
        double ms = bench_step_ms(measured, (enum bench_step)step);
        if (step == STEP_OTHER && ms <= 0)
            continue;
        fprintf(out, "  %-24s %10.3f %7.1f", bench_step_names[step], ms, 100 * ms / frame);
        if (step == STEP_OTHER)
            fprintf(out, "\n");
        else
            fprintf(out, " %12.1f %8.1f\n", paper_steps[step].ms, paper_steps[step].percent);
    }
    const struct summary *whole = &measured->passes[0].ms;
    double pixels = (double)measured->width * measured->height;
    int slots = (int)settings_number(&measured->settings, "interleave") *
                (int)settings_number(&measured->settings, "interleave");
    fprintf(out,
            "  sum of passes %.3f ms, whole frame %.3f ms (p5 %.3f, p95 %.3f, min %.3f, max "
            "%.3f of %d), without timers %.3f ms\n",
            sum, frame, whole->p5, whole->p95, whole->minimum, whole->maximum, whole->count,
            measured->wall_ms.median);
    fprintf(out, "  %.3g ns per pixel, the indirect step %.3g ns per pixel and VPL\n",
            frame * 1e6 / pixels,
            bench_step_ms(measured, STEP_INDIRECT) * 1e6 * slots /
                (pixels * (int)settings_number(&measured->settings, "vpls")));
}

void bench_print_ratios(FILE *out, const struct bench_case *cases, int count) {
    const struct bench_case *base = NULL;
    for (int i = 0; i < count; i++) {
        if (!base || strcmp(base->scene, cases[i].scene) != 0)
            base = &cases[i];
        else
            fprintf(out, "  %s: %s takes %.2f times the frame of %s\n", base->scene,
                    cases[i].series, cases[i].wall_ms.median / base->wall_ms.median, base->series);
    }
}
