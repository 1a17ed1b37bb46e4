/* FLIP's filters [Andersson et al. 2020 §4.1.1, §4.2]: contrast sensitivity for the colour
 * pipeline, edge and point detectors for the feature pipeline.
 *
 * Every one is a product of a row filter and a column filter, or (contrast sensitivity of blue and
 * yellow) a sum of two such products. So four filters run at once, one in each lane of a float4:
 *
 *     lane       0                      1                      2                  3
 *     colour     Y: achromatic          Cx: red-green          Cz: blue-yellow, two Gaussians, to
 * be added feature    edge across x          edge across y          point across x     point across
 * y dG(x) G(y)             G(x) dG(y)             ddG(x) G(y)        G(x) ddG(y)
 */
#ifndef METRICS_FLIP_FLIP_FILTER_H
#define METRICS_FLIP_FLIP_FILTER_H

typedef float float4 __attribute__((vector_size(16)));

struct separable_filter {
    float4 *row, *column; /* 2 radius + 1 taps each */
};

struct flip_filters {
    int radius; /* of all; taps beyond a filter's own support are zero */
    struct separable_filter colour, feature;
};

void flip_filters_init(struct flip_filters *filters, float pixels_per_degree);
void flip_filters_free(struct flip_filters *filters);

/* out[i] = sum over k of taps[k] in[i + k], for i in [0, count). */
void filter_row(const float4 *taps, int radius, const float4 *in, float4 *out, int count);

/* out[i] = sum over k of taps[k] in[k * count + i]: down the columns of 2 radius + 1 rows. */
void filter_columns(const float4 *taps, int radius, const float4 *in, float4 *out, int count);

#endif
