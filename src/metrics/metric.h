/* The metrics by name: each a mean of pixel errors, finished by a root, a ratio or a logarithm. */
#ifndef METRICS_METRIC_H
#define METRICS_METRIC_H

#include "metrics/comparison.h"

#include <stdbool.h>

/* What a picture's values are: light, or the values of a screen. */
enum { METRIC_HDR = 1, METRIC_LDR = 2 };

enum metric_range {
    RANGE_POSITIVE, /* from 0 up */
    RANGE_SIGNED,
    RANGE_UNIT, /* 0 to 1 */
};

struct metric {
    const char *name, *help;
    int usual_for; /* METRIC_HDR, METRIC_LDR or both: what is measured unless asked otherwise */
    enum metric_range range;
    bool higher_is_better;
    /* The error of one pixel; or, where pixels depend on many others, all of them at once. */
    float (*pixel_error)(const struct comparison *comparison, int x, int y);
    void (*error_map)(const struct comparison *comparison, float *map);
    /* From a mean of errors to the metric; relative ones divide by the reference's mean. */
    double (*finish)(double error, double reference_mean);
};

enum { METRIC_COUNT = 15 };

extern const struct metric metrics[METRIC_COUNT];

/* An error that lists the names when there is none of this name. */
const struct metric *metric_find(const char *name);

/* The metric of the whole picture. map (height x width, or NULL) gets what the metric is at each
 * pixel alone. A relative metric of a black reference is 0 or infinite. */
double metric_measure(const struct metric *metric, const struct comparison *comparison, float *map);

#endif
