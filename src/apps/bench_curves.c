#include "apps/bench_curves.h"

#include "apps/bench_errors.h"
#include "apps/bench_picture.h"
#include "apps/bench_plot.h"
#include "base/error.h"
#include "base/log.h"
#include "base/memory.h"
#include "base/output_file.h"

#include "version.h"

#include <stdlib.h>
#include <string.h>

/* No interleaving, no blocks but of one pixel, no blur, no near field, no edges: the visibility
 * alone. */
#define VISIBILITY_ALONE "clamp=disk,visibility-block=1,interleave=1,blur-radius=0,samples=1"
#define CSSM "technique=clustered,path=paper," VISIBILITY_ALONE
#define HARD "technique=clustered,path=fast,visibility=hard," VISIBILITY_ALONE
#define PCSS "technique=clustered,path=fast,visibility=pcss," VISIBILITY_ALONE

enum { VALUES_MAX = 10, SERIES_MAX = 4 };

struct curve_series {
    const char *name, *assignments;
    bool traced; /* visibility by ray tracing */
};

static const struct curve {
    const char *setting, *title, *x_label;
    bool against_truth;     /* else against ray-traced visibility from the same VPLs */
    int values[VALUES_MAX]; /* ends with 0 */
    struct curve_series series[SERIES_MAX];
} curves_table[] = {
    {
        .setting = "vals",
        .title = "error of visibility against M",
        .x_label = "VALs, M",
        .values = {2, 4, 8, 16, 30, 60, 120, 1024},
        .series = {{"CSSM", CSSM, false}, {"PCSS", PCSS, false}, {"hard", HARD, false}},
    },
    {
        .setting = "terms",
        .title = "error of visibility against K",
        .x_label = "terms of the Fourier series, K",
        .values = {1, 2, 4, 8, 16},
        .series = {{"CSSM", CSSM, false}},
    },
    {
        .setting = "map-size",
        .title = "error of visibility against the size of maps",
        .x_label = "paraboloid map, texels a side",
        .values = {64, 128, 256, 512},
        .series = {{"CSSM", CSSM, false}, {"PCSS", PCSS, false}, {"hard", HARD, false}},
    },
    {
        .setting = "vpls",
        .title = "error of the frame but for edges against N",
        .x_label = "VPLs, N",
        .against_truth = true,
        .values = {64, 128, 256, 512, 1024, 2048, 4096},
        .series = {{"the frame", "technique=clustered,path=fast,samples=1", false},
                   {"the paper's frame", "technique=clustered,path=paper", false},
                   {"all VPLs, ray-traced", HARD, true}},
    },
};

enum { CURVES = sizeof curves_table / sizeof *curves_table };

/* What the points of a scene are held against. */
struct standards {
    struct image truth, visibility;
};

static bool init_standards(struct standards *standards, const struct bench_case *base,
                           const struct bench_reference_desc *truth) {
    struct bench_case exact = *base;
    struct bench_reference_desc centers = *truth;
    centers.kind = BENCH_REFERENCE_CENTERS;
    *standards = (struct standards){0};
    return bench_reference_get(&centers, &standards->truth) && bench_assign_all(&exact, HARD) &&
           bench_picture_trace(&exact, truth->stage, truth->software, &standards->visibility);
}

static void free_standards(struct standards *standards) {
    image_free(&standards->truth);
    image_free(&standards->visibility);
}

static bool measure_point(struct curve_point *point, const struct curve *curve,
                          const struct curve_series *series, const struct bench_case *base,
                          const struct bench_reference_desc *truth,
                          const struct standards *standards) {
    struct bench_case prepared = *base;
    char assignment[64];
    struct image picture = {0};
    snprintf(assignment, sizeof assignment, "%s=%d", curve->setting, point->value);
    snprintf(prepared.label, sizeof prepared.label, "%s", assignment);
    log_note("%s: %s, %s", base->scene, assignment, series->name);
    bool ok =
        bench_assign_all(&prepared, series->assignments) && bench_assign(&prepared, assignment) &&
        (series->traced
             ? bench_picture_trace(&prepared, truth->stage, truth->software, &picture)
             : bench_picture_render(&prepared, truth->stage, truth->software, &picture)) &&
        bench_errors_between(&picture,
                             curve->against_truth ? &standards->truth : &standards->visibility,
                             &point->errors);
    image_free(&picture);
    return ok;
}

static bool measure_series(struct curves *curves, const struct curve *curve,
                           const struct curve_series *series, const struct bench_case *base,
                           const struct bench_reference_desc *truth,
                           const struct standards *standards) {
    for (int i = 0; i < VALUES_MAX && curve->values[i]; i++) {
        struct curve_point *point = &curves->points[curves->count++];
        *point = (struct curve_point){curve->setting, series->name, curve->values[i], {0}};
        if (!measure_point(point, curve, series, base, truth, standards))
            return false;
    }
    return true;
}

bool curves_measure(struct curves *curves, const struct bench_case *base,
                    const struct bench_reference_desc *truth) {
    struct standards standards;
    *curves = (struct curves){.width = base->width, .height = base->height};
    memcpy(curves->scene, base->scene, sizeof curves->scene);
    curves->points = mem_alloc(CURVES * SERIES_MAX * VALUES_MAX, sizeof *curves->points);
    bool ok = init_standards(&standards, base, truth);
    for (const struct curve *c = curves_table; c < curves_table + CURVES; c++)
        for (int i = 0; ok && i < SERIES_MAX && c->series[i].name; i++)
            ok = measure_series(curves, c, &c->series[i], base, truth, &standards);
    free_standards(&standards);
    return ok;
}

void curves_free(struct curves *curves) {
    free(curves->points);
    *curves = (struct curves){0};
}

void curves_print(FILE *out, const struct curves *curves) {
    fprintf(out, "%s, %dx%d\n  %-24s %-22s  rRMSE %%  bias %% gradient    FLIP\n", curves->scene,
            curves->width, curves->height, "setting", "of");
    for (const struct curve_point *p = curves->points; p < curves->points + curves->count; p++) {
        char setting[64];
        snprintf(setting, sizeof setting, "%s=%d", p->setting, p->value);
        fprintf(out, "  %-24s %-22s %8.2f %+7.2f %8.4f %7.4f\n", setting, p->series,
                100 * p->errors.relative_rmse, 100 * p->errors.relative_bias, p->errors.gradient,
                p->errors.ldr_flip);
    }
}

static void add_point(struct plot *plot, const struct curve_point *point) {
    char series[BENCH_NAME_SIZE];
    snprintf(series, sizeof series, "%s, RMSE", point->series);
    plot_add(plot, series,
             &(struct plot_point){.x = point->value, .y = 100 * point->errors.relative_rmse});
    snprintf(series, sizeof series, "%s, gradient", point->series);
    plot_add(plot, series,
             &(struct plot_point){.x = point->value, .y = 100 * point->errors.gradient});
}

static bool draw(const struct curves *curves, const struct curve *curve, const char *folder) {
    char *title =
        mem_printf("%s, %dx%d: %s", curves->scene, curves->width, curves->height, curve->title);
    char *path = mem_printf("%s/%s-%s", folder, curves->scene, curve->setting);
    struct plot plot = {.title = title,
                        .x_label = curve->x_label,
                        .y_label = "error of indirect light over its mean, %",
                        .log_y = true};
    for (int i = 0; i < curves->count; i++)
        if (strcmp(curves->points[i].setting, curve->setting) == 0)
            add_point(&plot, &curves->points[i]);
    bool ok = plot_draw(&plot, path);
    plot_free(&plot);
    free(path);
    free(title);
    return ok;
}

bool curves_draw(const struct curves *curves, const char *folder) {
    for (const struct curve *curve = curves_table; curve < curves_table + CURVES; curve++)
        if (!draw(curves, curve, folder))
            return false;
    return true;
}

bool curves_write_csv(const char *path, const struct curves *curves, int count) {
    struct output_text text;
    output_text_init(&text);
    FILE *out = text.stream;
    fprintf(out, "scene,width,height,setting,value,series,relative_rmse,relative_bias,gradient,"
                 "ldr_flip,commit\n");
    for (const struct curves *c = curves; c < curves + count; c++)
        for (const struct curve_point *p = c->points; p < c->points + c->count; p++)
            fprintf(out, "%s,%d,%d,%s,%d,\"%s\",%.5g,%.5g,%.5g,%.5g,%s\n", c->scene, c->width,
                    c->height, p->setting, p->value, p->series, p->errors.relative_rmse,
                    p->errors.relative_bias, p->errors.gradient, p->errors.ldr_flip,
                    MANYLIGHT_COMMIT);
    return output_text_end(&text, path);
}
