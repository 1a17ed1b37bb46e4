/* Metrics by name: each is a mean of pixel errors, finished by a root, a ratio or a logarithm. */
#ifndef METRICS_METRIC_H
#define METRICS_METRIC_H

#include "metrics/comparison.h"

#include <stdbool.h>

/* Kind of values: linear light, or values of a display. */
enum { METRIC_HDR = 1, METRIC_LDR = 2 };

enum metric_range {
    RANGE_POSITIVE, /* from 0 up */
    RANGE_SIGNED,
    RANGE_UNIT, /* 0 to 1 */
};

struct metric {
    const char *name, *help;
    int usual_for; /* kinds for which it is a default: METRIC_HDR, METRIC_LDR or both */
    enum metric_range range;
    bool higher_is_better;
    /* Error of one pixel, or, if pixels depend on many others, of all pixels. */
    float (*pixel_error)(const struct comparison *comparison, int x, int y);
    void (*error_map)(const struct comparison *comparison, float *map);
    /* Computes the metric from the mean error; relative metrics divide by reference_mean. */
    double (*finish)(double error, double reference_mean);
};

enum { METRIC_COUNT = 15 };

extern const struct metric metrics[METRIC_COUNT];

/* Returns the metric of that name. Error, and NULL: lists the names. */
const struct metric *metric_find(const char *name);

/* Returns the metric of the whole picture. map (height x width, or NULL) receives the metric of
 * each pixel alone. With a black reference a relative metric is 0 or infinite. */
double metric_measure(const struct metric *metric, const struct comparison *comparison, float *map);

#endif
