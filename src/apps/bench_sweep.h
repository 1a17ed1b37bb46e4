/* A grid of settings, from text:
 *
 *     vals=2..120                   powers of two from 2, and 120
 *     vals=2,8,30                   these
 *     M=2..120,technique=clustered,unshadowed,terms=1..8       three axes
 *
 * N, M and K stand for vpls, vals and terms; technique and size (400x400) vary like settings.
 */
#ifndef APPS_BENCH_SWEEP_H
#define APPS_BENCH_SWEEP_H

#include "apps/bench_case.h"

enum { SWEEP_AXES_MAX = 8, SWEEP_VALUES_MAX = 32, SWEEP_TEXT_SIZE = 32 };

struct sweep_axis {
    char name[SWEEP_TEXT_SIZE];
    char values[SWEEP_VALUES_MAX][SWEEP_TEXT_SIZE];
    int count;
    bool numeric; /* else each value is a series of its own */
};

struct sweep {
    struct sweep_axis axes[SWEEP_AXES_MAX];
    int axis_count;
};

/* Adds the axes of the text. Error: no such setting, a value out of its range, too many. */
bool sweep_parse(struct sweep *sweep, const char *text);

/* Whether an axis makes series: techniques, say. */
bool sweep_has_series(const struct sweep *sweep);

int sweep_point_count(const struct sweep *sweep);

/* Sets the values of one point of the grid, the last axis running fastest, and appends them to the
 * case's series and label. */
void sweep_apply(const struct sweep *sweep, int point, struct bench_case *prepared);

#endif
