#include "metrics/errors.h"

#include "metrics/colour.h"

#include <math.h>

static float square(float value) {
    return value * value;
}

float signed_error(const struct comparison *comparison, int x, int y) {
    const float *v = image_at(comparison->test, x, y), *r = image_at(comparison->reference, x, y);
    return (v[0] - r[0] + v[1] - r[1] + v[2] - r[2]) / 3;
}

float absolute_error(const struct comparison *comparison, int x, int y) {
    const float *v = image_at(comparison->test, x, y), *r = image_at(comparison->reference, x, y);
    return (fabsf(v[0] - r[0]) + fabsf(v[1] - r[1]) + fabsf(v[2] - r[2])) / 3;
}

float squared_error(const struct comparison *comparison, int x, int y) {
    const float *v = image_at(comparison->test, x, y), *r = image_at(comparison->reference, x, y);
    return (square(v[0] - r[0]) + square(v[1] - r[1]) + square(v[2] - r[2])) / 3;
}

float squared_relative_error(const struct comparison *comparison, int x, int y) {
    const float *v = image_at(comparison->test, x, y), *r = image_at(comparison->reference, x, y);
    float sum = 0;
    for (int c = 0; c < 3; c++)
        sum += square((v[c] - r[c]) / (r[c] + 0.01f));
    return sum / 3;
}

float symmetric_relative_error(const struct comparison *comparison, int x, int y) {
    const float *v = image_at(comparison->test, x, y), *r = image_at(comparison->reference, x, y);
    float sum = 0;
    for (int c = 0; c < 3; c++)
        sum += fabsf(v[c] - r[c]) / (fabsf(v[c]) + fabsf(r[c]) + 0.01f);
    return sum / 3;
}

float squared_display_error(const struct comparison *comparison, int x, int y) {
    const float *v = image_at(comparison->test, x, y), *r = image_at(comparison->reference, x, y);
    float sum = 0;
    for (int c = 0; c < 3; c++)
        sum += square(srgb_encode(v[c]) - srgb_encode(r[c]));
    return sum / 3;
}

/* The squared step of (v - r) from one pixel to another. */
static float squared_step(const struct comparison *comparison, int x, int y, int to_x, int to_y) {
    const float *v = image_at(comparison->test, x, y), *r = image_at(comparison->reference, x, y);
    const float *to_v = image_at(comparison->test, to_x, to_y);
    const float *to_r = image_at(comparison->reference, to_x, to_y);
    float sum = 0;
    for (int c = 0; c < 3; c++)
        sum += square((to_v[c] - to_r[c]) - (v[c] - r[c]));
    return sum / 3;
}

float squared_gradient_error(const struct comparison *comparison, int x, int y) {
    bool has_right = x + 1 < comparison->reference->width;
    bool has_below = y + 1 < comparison->reference->height;
    return (has_right ? squared_step(comparison, x, y, x + 1, y) : 0) +
           (has_below ? squared_step(comparison, x, y, x, y + 1) : 0);
}
