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
    bool budget, curves, scaling, temporal, failures;
};

/* A list that grows. */
struct bench_cases {
    struct bench_case *items;
    int count;
};

/* A case of the scene with the options' size and settings over a variant's: a name of the list, or
 * NAME:KEY=VALUE,... Error: of the variant or a setting. */
bool bench_prepare(struct bench_case *prepared, const struct bench_values *values,
                   const struct stage *stage, const char *variant);

/* How many variants are compared. */
int bench_variant_count(const struct bench_values *values);

/* Appends a case for each of the variants at each point of the sweep. Error: of a variant or a
 * setting. */
bool bench_list_cases(struct bench_cases *cases, const struct bench_values *values,
                      const struct stage *stage, const struct sweep *sweep);

/* The named variants, for --help. */
void bench_print_variants(FILE *out, const void *values);

/* The protocol for the context, with what the options say. */
struct bench_protocol bench_choose_protocol(const struct bench_values *values, bool software);

/* Measures cases of one stage in groups that alternate. */
bool bench_measure_groups(struct bench_case *cases, int count, const struct stage *stage,
                          const struct bench_protocol *protocol);

/* The slope of log y over log x by least squares; 0 for a single x. */
double bench_log_slope(const double *x, const double *y, int count);

/* Where charts go. */
static inline const char *bench_output(const struct bench_values *values) {
    return values->output ? values->output : ".";
}

/* The modes. software: whether the current context is. */
bool bench_times(const struct bench_values *values, const char **scenes, int scene_count,
                 const struct sweep *sweep, bool software);
bool bench_scaling(const struct bench_values *values, const char **scenes, int scene_count,
                   bool software);
bool bench_budgets(const struct bench_values *values, const char **scenes, int scene_count,
                   bool software);
bool bench_all_curves(const struct bench_values *values, const char **scenes, int scene_count,
                      bool software);

#endif
