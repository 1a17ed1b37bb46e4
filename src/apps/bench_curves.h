/* Errors along one setting at a time, as in the paper's Fig. 10: M, K, N and the size of maps. */
#ifndef APPS_BENCH_CURVES_H
#define APPS_BENCH_CURVES_H

#include "apps/bench_case.h"
#include "apps/bench_reference.h"

#include <stdio.h>

struct curve_point {
    const char *setting, *series; /* "vals", "CSSM" */
    int value;                    /* of the setting */
    struct bench_errors errors;
};

struct curves {
    char scene[BENCH_NAME_SIZE];
    int width, height;
    struct curve_point *points;
    int count;
};

/* Measures all curves of a scene. base: size and settings that all points share; truth: for the
 * curve over N, all others are against ray-traced visibility from the same VPLs. */
bool curves_measure(struct curves *curves, const struct bench_case *base,
                    const struct bench_reference_desc *truth);
void curves_free(struct curves *curves);

void curves_print(FILE *out, const struct curves *curves);

/* FOLDER/SCENE-SETTING.svg and .png. */
bool curves_draw(const struct curves *curves, const char *folder);

/* A row for each point of each scene. */
bool curves_write_csv(const char *path, const struct curves *curves, int count);

#endif
