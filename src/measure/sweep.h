/* A grid of settings, from text:
 *
 *     vals=2..120                   powers of two from 2, and 120
 *     vals=2,8,30                   these
 *     M=2..120,technique=clustered,unshadowed,terms=1..8       three axes
 *
 * N, M and K stand for vpls, vals and terms; technique and size (400x400) vary like settings.
 */
#ifndef MEASURE_SWEEP_H
#define MEASURE_SWEEP_H

#include "measure/measure.h"

/* Zeroed: a grid of nothing, with no points. */
struct sweep {
    char **points; /* "vals=2,technique=clustered,terms=1"; the last axis runs fastest */
    int count;
    bool has_variants; /* an axis is no number: its values are variants of their own */
};

/* Multiplies the grid by the axes of the text. Error: no such setting, a value out of its range. */
bool sweep_parse(struct sweep *sweep, const char *text);
void sweep_free(struct sweep *sweep);

/* Sets the values of a point, and appends them to the names of the desc's variant and point. Error:
 * the names become too long. */
bool sweep_apply(const char *point, struct measure_desc *desc);

#endif
