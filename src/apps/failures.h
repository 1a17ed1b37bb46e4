/* Measures the failure suite: every row with every technique against rays. */
#ifndef APPS_FAILURES_H
#define APPS_FAILURES_H

#include "apps/bench.h"
#include "apps/failure_rows.h"

struct failure_result {
    double relative_rmse, relative_bias; /* of the indirect light; infinite over a black truth */
    double worst;                        /* pixel: |v - r| over the reference's mean */
    int worst_x, worst_y;
    int non_finite; /* values */
    int messages;   /* of OpenGL */
};

/* One row, with the options' size, settings, noise and cache; results, one a technique. A picture
 * of it goes to the folder `output` unless that is NULL. Error: of the scene, renderer or file. */
bool failure_measure(const struct failure_row *row, const struct bench_values *values,
                     const struct context *context, struct failure_result *results);

/* Whether the result is what the row promises, `slack` times over: finite, silent, within bounds.
 */
bool failure_holds(const struct failure_row *row, int technique,
                   const struct failure_result *result, double slack);

/* The rows named, or all: a table, the CSV, the pictures. Error: as above, or a row that does not
 * hold. */
bool bench_failures(const struct bench_values *values, const char **names, int name_count,
                    const struct context *context);

#endif
