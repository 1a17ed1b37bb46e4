/* The failure suite: known ways in which many-light methods break, each a small scene or a setting.
 * bench/STABILITY.md says why each one breaks and what does better.
 */
#ifndef APPS_FAILURE_ROWS_H
#define APPS_FAILURE_ROWS_H

/* In this order everywhere, as the benchmark's variants: NAME:KEY=VALUE,... */
enum { FAILURE_TECHNIQUES = 5, FAILURE_FRAME = 4 };
extern const char *const failure_techniques[FAILURE_TECHNIQUES];

struct failure_row {
    const char *name, *what;
    const char *scene;          /* file */
    const char *camera, *light; /* as scene/placing.h has it; NULL = the first */
    const char *settings;       /* "key=value,..." over each technique's own; NULL = none */
    int width, height;          /* 0 = as asked for */
    /* Of the relative RMSE of the indirect light, in per cent: what is known and held, at 160x120.
     * 0 = none: nothing is promised. */
    double bounds[FAILURE_TECHNIQUES];
};

extern const struct failure_row failure_rows[];
extern const int failure_row_count;

/* Error: names all rows. */
const struct failure_row *failure_row_find(const char *name);

#endif
