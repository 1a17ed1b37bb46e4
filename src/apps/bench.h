/* The parts of `manylight bench`. */
#ifndef APPS_BENCH_H
#define APPS_BENCH_H

#include "apps/arguments.h"
#include "apps/bench_measure.h"
#include "apps/bench_reference.h"
#include "apps/bench_sweep.h"
#include "gl/context.h"

struct bench_values {
    struct common_values common;
    struct context_desc context;
    struct text_list variants, settings, sweeps;
    const char *csv, *json, *cache, *chart, *output;
    int size[2], frames, warm_up, reference;
    float noise;
};

/* A list that grows. */
struct bench_cases {
    struct bench_case *items;
    int count;
};

/* Appends a case for each of the variants at each point of the sweep. Error: of a variant or a
 * setting. */
bool bench_list_cases(struct bench_cases *cases, const struct bench_values *values,
                      const struct stage *stage, const struct sweep *sweep);

/* The named variants, for --help. */
void bench_print_variants(FILE *out);

#endif
