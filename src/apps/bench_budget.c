#include "apps/bench_budget.h"

#include "apps/bench_errors.h"
#include "apps/bench_picture.h"
#include "base/error.h"
#include "base/log.h"
#include "base/output_file.h"

#include "version.h"

#include <math.h>
#include <string.h>

/* Each pixel takes all that the pixels of an interleaving pattern take together. With EVERY_VPL
 * blocks of one pixel are as good as none: a lookup for each VAL, not for each of its VPLs. */
#define EVERY_VPL "interleave=1,near-samples=1024,blur-radius=0,samples=1"

const struct budget_step budget_steps[BUDGET_STEPS] = {
    /* A pixel's centre stands for all of it. */
    {"pixel centres", NULL, false},
    /* Few lights, and light near to them bounded. */
    {"all VPLs, ray-traced", "technique=instant-radiosity,clamp=disk," EVERY_VPL, true},
    {"hard map per VPL", "technique=instant-radiosity,clamp=disk," EVERY_VPL, false},
    /* What the bound took comes back. */
    {"near field", "technique=instant-radiosity," EVERY_VPL, false},
    {"hard map per VAL", "technique=clustered,visibility=hard,visibility-block=1," EVERY_VPL,
     false},
    {"soft map per VAL", "technique=clustered,visibility-block=1," EVERY_VPL, false},
    {"visibility per block", "technique=clustered," EVERY_VPL, false},
    {"interleaved", "technique=clustered,blur-radius=0,samples=1", false},
    {"blurred", "technique=clustered,samples=1", false},
    {"antialiased: the frame", "technique=clustered", false},
};

/* The last one in which a pixel is its centre. */
enum { LAST_OF_CENTERS = BUDGET_STEPS - 2 };

static double noise_of(const struct image *truth) {
    int indirect[3], error[3];
    if (!image_find_layer(truth, "indirect", indirect) ||
        !image_find_layer(truth, "standard_error", error))
        return 0;
    double sum = 0, square_sum = 0, values = 3.0 * truth->width * truth->height;
    for (int y = 0; y < truth->height; y++)
        for (int x = 0; x < truth->width; x++)
            for (int c = 0; c < 3; c++) {
                const float *pixel = image_at(truth, x, y);
                sum += (double)pixel[indirect[c]];
                square_sum += pow((double)pixel[error[c]], 2);
            }
    return sum > 0 ? sqrt(square_sum / values) / (sum / values) : 0;
}

static bool picture_of(const struct budget_step *step, const struct bench_case *base,
                       const struct bench_reference_desc *truth, struct image *picture) {
    struct bench_case prepared = *base;
    log_note("%s: %s", base->scene, step->name);
    if (!step->assignments) {
        struct bench_reference_desc centers = *truth;
        centers.kind = BENCH_REFERENCE_CENTERS;
        return bench_reference_get(&centers, picture);
    }
    snprintf(prepared.series, sizeof prepared.series, "%s", step->name);
    return bench_assign_all(&prepared, step->assignments) &&
           (step->traced ? bench_picture_trace(&prepared, truth->stage, truth->software, picture)
                         : bench_picture_render(&prepared, truth->stage, truth->software, picture));
}

/* Holds a picture against the truth and against the step before. */
static bool measure_step(struct budget *budget, int step, const struct image *picture,
                         const struct image *before, const struct image *truth) {
    return bench_errors_between(picture, truth, &budget->so_far[step]) &&
           bench_errors_between(picture, before, &budget->step[step]);
}

static bool measure_steps(struct budget *budget, const struct bench_case *base,
                          const struct bench_reference_desc *desc, const struct image *truth,
                          struct image pictures[BUDGET_STEPS]) {
    for (int i = 0; i < BUDGET_STEPS; i++)
        if (!picture_of(&budget_steps[i], base, desc, &pictures[i]) ||
            !measure_step(budget, i, &pictures[i], i ? &pictures[i - 1] : truth, truth))
            return false;
    return bench_errors_between(&pictures[LAST_OF_CENTERS], &pictures[0], &budget->shading);
}

bool budget_make(struct budget *budget, const struct bench_case *base,
                 const struct bench_reference_desc *desc) {
    struct image truth, pictures[BUDGET_STEPS] = {{0}};
    *budget = (struct budget){.width = base->width, .height = base->height};
    memcpy(budget->scene, base->scene, sizeof budget->scene);
    memcpy(budget->variant, base->series, sizeof budget->variant);
    bool ok = bench_reference_get(desc, &truth);
    if (ok) {
        budget->noise = noise_of(&truth);
        ok = measure_steps(budget, base, desc, &truth, pictures);
    }
    for (int i = 0; i < BUDGET_STEPS; i++)
        image_free(&pictures[i]);
    image_free(&truth);
    return ok;
}

static void print_errors(FILE *out, const struct bench_errors *errors) {
    fprintf(out, " %8.2f %+7.2f %8.4f %7.4f", 100 * errors->relative_rmse,
            100 * errors->relative_bias, errors->gradient, errors->ldr_flip);
}

void budget_print(FILE *out, const struct budget *budget) {
    static const char columns[] = " rRMSE %  bias % gradient    FLIP";
    fprintf(out, "%s, %s, %dx%d, against a reference with %.2f %% noise\n", budget->scene,
            budget->variant, budget->width, budget->height, 100 * budget->noise);
    fprintf(out, "  %-24s %33s   %33s\n", "", "this step alone", "against the truth");
    fprintf(out, "  %-24s %s   %s\n", "step", columns, columns);
    for (int i = 0; i < BUDGET_STEPS; i++) {
        fprintf(out, "  %-24s", budget_steps[i].name);
        print_errors(out, &budget->step[i]);
        fprintf(out, "  ");
        print_errors(out, &budget->so_far[i]);
        fprintf(out, "\n");
    }
    fprintf(out, "  %-24s %33s   ", "blurred, but for edges", "");
    print_errors(out, &budget->shading);
    fprintf(out, "\n");
}

static void print_row(FILE *out, const struct budget *budget, int step, const char *against,
                      const struct bench_errors *errors) {
    fprintf(out, "%s,%s,%d,%d,%.4g,\"%s\",%s,%.5g,%.5g,%.5g,%.5g,%s\n", budget->scene,
            budget->variant, budget->width, budget->height, budget->noise, budget_steps[step].name,
            against, errors->relative_rmse, errors->relative_bias, errors->gradient,
            errors->ldr_flip, MANYLIGHT_COMMIT);
}

bool budget_write_csv(const char *path, const struct budget *budgets, int count) {
    struct output_text text;
    output_text_init(&text);
    FILE *out = text.stream;
    fprintf(out,
            "scene,variant,width,height,noise,step,against,relative_rmse,relative_bias,gradient,"
            "ldr_flip,commit\n");
    for (int i = 0; i < count; i++) {
        for (int step = 0; step < BUDGET_STEPS; step++) {
            print_row(out, &budgets[i], step, "step before", &budgets[i].step[step]);
            print_row(out, &budgets[i], step, "truth", &budgets[i].so_far[step]);
        }
        print_row(out, &budgets[i], LAST_OF_CENTERS, "pixel centres", &budgets[i].shading);
    }
    return output_text_end(&text, path);
}
