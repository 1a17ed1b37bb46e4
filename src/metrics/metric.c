#include "metrics/metric.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "metrics/area_errors.h"
#include "metrics/errors.h"
#include "metrics/flip/flip.h"
#include "metrics/flip/hdr_flip.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static double ratio(double value, double to) {
    return value == 0 ? 0 : value / to;
}

static double plain(double error, double reference_mean) {
    (void)reference_mean;
    return error;
}
static double root(double error, double reference_mean) {
    (void)reference_mean;
    return sqrt(error);
}
static double relative(double error, double reference_mean) {
    return ratio(error, reference_mean);
}
static double relative_root(double error, double reference_mean) {
    return ratio(sqrt(error), reference_mean);
}
static double decibels(double error, double reference_mean) {
    (void)reference_mean;
    return -10 * log10(error);
}

const struct metric metrics[METRIC_COUNT] = {
    {.name = "rmse",
     .help = "root of the mean of (v - r)^2",
     .usual_for = METRIC_HDR | METRIC_LDR,
     .pixel_error = squared_error,
     .finish = root},
    {.name = "relative-rmse",
     .help = "rmse over the mean of r",
     .usual_for = METRIC_HDR | METRIC_LDR,
     .pixel_error = squared_error,
     .finish = relative_root},
    {.name = "mrse",
     .help = "mean of (v - r)^2 / (r + 0.01)^2",
     .usual_for = METRIC_HDR,
     .pixel_error = squared_relative_error,
     .finish = plain},
    {.name = "mae",
     .help = "mean of |v - r|",
     .usual_for = METRIC_HDR | METRIC_LDR,
     .pixel_error = absolute_error,
     .finish = plain},
    {.name = "relative-mae",
     .help = "mae over the mean of r",
     .usual_for = METRIC_HDR | METRIC_LDR,
     .pixel_error = absolute_error,
     .finish = relative},
    {.name = "smape",
     .help = "mean of |v - r| / (|v| + |r| + 0.01)",
     .usual_for = METRIC_HDR,
     .range = RANGE_UNIT,
     .pixel_error = symmetric_relative_error,
     .finish = plain},
    {.name = "bias",
     .help = "mean of v - r",
     .usual_for = METRIC_HDR | METRIC_LDR,
     .range = RANGE_SIGNED,
     .pixel_error = signed_error,
     .finish = plain},
    {.name = "relative-bias",
     .help = "bias over the mean of r",
     .usual_for = METRIC_HDR,
     .range = RANGE_SIGNED,
     .pixel_error = signed_error,
     .finish = relative},
    {.name = "gradient",
     .help = "root of the mean of |grad (v - r)|^2, over the mean of r; measures banding",
     .usual_for = METRIC_HDR | METRIC_LDR,
     .pixel_error = squared_gradient_error,
     .finish = relative_root},
    {.name = "worst-share",
     .help = "fraction of the squared error in the worst 1 % of the pixels",
     .usual_for = METRIC_HDR,
     .error_map = worst_share,
     .finish = plain},
    {.name = "box4-rmse",
     .help = "relative-rmse after averaging over boxes of 4 x 4 pixels",
     .usual_for = METRIC_HDR,
     .error_map = box_error_4,
     .finish = relative_root},
    {.name = "box16-rmse",
     .help = "relative-rmse after averaging over boxes of 16 x 16 pixels",
     .usual_for = METRIC_HDR,
     .error_map = box_error_16,
     .finish = relative_root},
    {.name = "psnr",
     .help = "peak signal-to-noise ratio of the sRGB-encoded values, dB; higher is better",
     .usual_for = METRIC_HDR | METRIC_LDR,
     .higher_is_better = true,
     .pixel_error = squared_display_error,
     .finish = decibels},
    {.name = "ldr-flip",
     .help = "FLIP of the values clamped to [0, 1]",
     .usual_for = METRIC_LDR,
     .range = RANGE_UNIT,
     .error_map = flip_ldr,
     .finish = plain},
    {.name = "hdr-flip",
     .help = "FLIP over all exposures of interest, for linear light",
     .usual_for = METRIC_HDR,
     .range = RANGE_UNIT,
     .error_map = flip_hdr,
     .finish = plain},
};

const struct metric *metric_find(const char *name) {
    char names[256] = "";
    size_t used = 0;
    for (const struct metric *m = metrics; m < metrics + METRIC_COUNT; m++) {
        if (strcmp(m->name, name) == 0)
            return m;
        used += (size_t)snprintf(names + used, sizeof names - used, " %s", m->name);
    }
    error_set("no metric is called '%s' (there is:%s)", name, names);
    return NULL;
}

struct pixel_errors {
    const struct metric *metric;
    const struct comparison *comparison;
    float *map;
};

static void measure_row(void *context, size_t y) {
    const struct pixel_errors *errors = context;
    int width = errors->comparison->reference->width;
    float *row = errors->map + y * (size_t)width;
    for (int x = 0; x < width; x++)
        row[x] = errors->metric->pixel_error(errors->comparison, x, (int)y);
}

/* One thread, one order: the sum is the same on every machine. */
static double mean(const float *values, size_t count) {
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += (double)values[i];
    return sum / (double)count;
}

double metric_measure(const struct metric *metric, const struct comparison *comparison,
                      float *map) {
    const struct image *reference = comparison->reference;
    size_t count = (size_t)reference->width * (size_t)reference->height;
    float *errors = mem_alloc(count, sizeof *errors);
    if (metric->error_map) {
        metric->error_map(comparison, errors);
    } else {
        struct pixel_errors context = {metric, comparison, errors};
        parallel_for((size_t)reference->height, comparison->threads, measure_row, &context);
    }
    double reference_mean = mean(reference->pixels, 3 * count);
    double value = metric->finish(mean(errors, count), reference_mean);
    for (size_t i = 0; map && i < count; i++)
        map[i] = (float)metric->finish((double)errors[i], reference_mean);
    free(errors);
    return value;
}
