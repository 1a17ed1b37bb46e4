/* Where the error of a frame comes from: the way from the truth to the frame in single steps, each
 * of which changes one thing. */
#ifndef APPS_BENCH_BUDGET_H
#define APPS_BENCH_BUDGET_H

#include "apps/bench_case.h"
#include "apps/bench_reference.h"

#include <stdio.h>

struct budget_step {
    const char *name;
    const char *assignments; /* of the settings, comma-separated, over the defaults; NULL = none is
                                rendered, paths are traced through pixels' centres */
    bool traced;             /* visibility by ray tracing */
};

enum { BUDGET_STEPS = 10 };

extern const struct budget_step budget_steps[BUDGET_STEPS];

struct budget {
    char scene[BENCH_NAME_SIZE], variant[BENCH_NAME_SIZE];
    int width, height;
    double noise; /* of the reference: standard error of the indirect layer, RMS over its mean */
    struct bench_errors step[BUDGET_STEPS];   /* against the step before; the first, the truth */
    struct bench_errors so_far[BUDGET_STEPS]; /* against the truth */
    struct bench_errors shading;              /* of the frame, against the truth at pixel centres */
};

/* base: size and settings that all steps share; desc: of the truth. Error: of the reference or a
 * step. */
bool budget_make(struct budget *budget, const struct bench_case *base,
                 const struct bench_reference_desc *desc);

void budget_print(FILE *out, const struct budget *budget);

/* A row for each step of each scene. */
bool budget_write_csv(const char *path, const struct budget *budgets, int count);

#endif
