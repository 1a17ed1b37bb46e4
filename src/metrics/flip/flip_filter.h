/* FLIP's filters [Andersson et al. 2020 §4.1.1, §4.2]: contrast sensitivity for the colour
 * pipeline, edge and point detectors for the feature pipeline.
 *
 * Each filter is a row filter times a column filter; contrast sensitivity of blue-yellow is a sum
 * of two products. Four filters run at once, one in each lane of a float4:
 *
 *     lane       0                1                2                  3
 *     colour     Y: achromatic    Cx: red-green    Cz: blue-yellow, sum of two Gaussians
 *     feature    edge across x    edge across y    point across x     point across y
 *                dG(x) G(y)       G(x) dG(y)       ddG(x) G(y)        G(x) ddG(y)
 */
#ifndef METRICS_FLIP_FLIP_FILTER_H
#define METRICS_FLIP_FLIP_FILTER_H

typedef float float4 __attribute__((vector_size(16)));

struct separable_filter {
    float4 *row, *column; /* 2 * radius + 1 taps each */
};

struct flip_filters {
    int radius; /* radius of all filters; taps beyond a filter's support are 0 */
    struct separable_filter colour, feature;
};

void flip_filters_init(struct flip_filters *filters, float pixels_per_degree);
void flip_filters_free(struct flip_filters *filters);

/* Computes out[i] = sum over k of taps[k] in[i + k], for i in [0, count). */
void filter_row(const float4 *taps, int radius, const float4 *in, float4 *out, int count);

/* Computes out[i] = sum over k of taps[k] in[k * count + i], down the columns of 2 * radius + 1
 * rows. */
void filter_columns(const float4 *taps, int radius, const float4 *in, float4 *out, int count);

#endif
