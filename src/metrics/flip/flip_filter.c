#include "metrics/flip/flip_filter.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

/* Contrast sensitivity in space: the sum of a sqrt(pi/b) exp(-pi^2 d^2/b) over two terms, d in
 * degrees [Andersson et al. 2020, table 1]. */
static const struct sensitivity {
    double a[2], b[2];
} achromatic = {{1, 0}, {0.0047, 1e-5}}, red_green = {{1, 0}, {0.0053, 1e-5}},
  blue_yellow = {{34.1, 13.5}, {0.04, 0.025}};

/* The width in degrees of the features that the eye finds most easily. */
static const double feature_width = 0.082;

static void allocate(struct separable_filter *filter, int radius) {
    size_t taps = 2 * (size_t)radius + 1;
    filter->row = mem_alloc(taps, sizeof *filter->row);
    filter->column = mem_alloc(taps, sizeof *filter->column);
}

static double gaussian_term(const struct sensitivity *s, int term, double degrees) {
    return exp(-pi * pi * degrees * degrees / s->b[term]);
}

/* The share of each term in the volume of the whole kernel over its square. */
static void term_shares(const struct sensitivity *s, int radius, double ppd, double shares[2]) {
    for (int term = 0; term < 2; term++) {
        double sum = 0;
        for (int k = -radius; k <= radius; k++)
            sum += gaussian_term(s, term, k / ppd);
        shares[term] = s->a[term] * sqrt(pi / s->b[term]) * sum * sum;
    }
    double volume = shares[0] + shares[1];
    shares[0] /= volume;
    shares[1] /= volume;
}

/* One Gaussian of a kernel of volume 1; the column taps carry its share of the volume. */
static void set_sensitivity_lane(struct separable_filter *filter, int lane, int radius, double ppd,
                                 const struct sensitivity *s, int term) {
    double shares[2], sum = 0;
    term_shares(s, radius, ppd, shares);
    for (int k = -radius; k <= radius; k++)
        sum += gaussian_term(s, term, k / ppd);
    for (int k = -radius; k <= radius; k++) {
        double tap = gaussian_term(s, term, k / ppd) / sum;
        filter->row[k + radius][lane] = (float)tap;
        filter->column[k + radius][lane] = (float)(tap * shares[term]);
    }
}

/* The Gaussian and its derivatives, up to a factor. */
static double gaussian(double x, double sigma) {
    return exp(-x * x / (2 * sigma * sigma));
}
static double edge(double x, double sigma) {
    return -x * gaussian(x, sigma);
}
static double point(double x, double sigma) {
    return (x * x / (sigma * sigma) - 1) * gaussian(x, sigma);
}

/* Positive taps sum to 1 and negative taps to -1. */
static void set_feature_taps(float4 *taps, int lane, int radius, double sigma,
                             double (*shape)(double x, double sigma)) {
    int support = (int)ceil(3 * sigma);
    double positive = 0, negative = 0;
    for (int k = -support; k <= support; k++) {
        positive += fmax(shape(k, sigma), 0);
        negative += fmax(-shape(k, sigma), 0);
    }
    for (int k = -support; k <= support; k++) {
        double tap = shape(k, sigma);
        taps[k + radius][lane] = (float)(tap > 0 ? tap / positive : tap < 0 ? tap / negative : 0);
    }
}

void flip_filters_init(struct flip_filters *filters, float pixels_per_degree) {
    double ppd = pixels_per_degree;
    /* Three standard deviations of the widest Gaussian; the features are narrower. */
    int radius = (int)ceil(3 * sqrt(blue_yellow.b[0] / (2 * pi * pi)) * ppd);
    filters->radius = radius;

    allocate(&filters->colour, radius);
    set_sensitivity_lane(&filters->colour, 0, radius, ppd, &achromatic, 0);
    set_sensitivity_lane(&filters->colour, 1, radius, ppd, &red_green, 0);
    set_sensitivity_lane(&filters->colour, 2, radius, ppd, &blue_yellow, 0);
    set_sensitivity_lane(&filters->colour, 3, radius, ppd, &blue_yellow, 1);

    allocate(&filters->feature, radius);
    static double (*const across_x[4])(double, double) = {edge, gaussian, point, gaussian};
    static double (*const across_y[4])(double, double) = {gaussian, edge, gaussian, point};
    double sigma = 0.5 * feature_width * ppd;
    for (int lane = 0; lane < 4; lane++) {
        set_feature_taps(filters->feature.row, lane, radius, sigma, across_x[lane]);
        set_feature_taps(filters->feature.column, lane, radius, sigma, across_y[lane]);
    }
}

void flip_filters_free(struct flip_filters *filters) {
    mem_free(filters->colour.row, filters->colour.column, filters->feature.row,
             filters->feature.column);
    *filters = (struct flip_filters){0};
}

void filter_row(const float4 *taps, int radius, const float4 *in, float4 *out, int count) {
    for (int i = 0; i < count; i++) {
        float4 sum = {0};
        for (int k = 0; k <= 2 * radius; k++)
            sum += taps[k] * in[i + k];
        out[i] = sum;
    }
}

void filter_columns(const float4 *taps, int radius, const float4 *in, float4 *out, int count) {
    memset(out, 0, (size_t)count * sizeof *out);
    for (int k = 0; k <= 2 * radius; k++)
        for (int i = 0; i < count; i++)
            out[i] += taps[k] * in[(size_t)k * (size_t)count + (size_t)i];
}
