/* The lesser and the greater of two floats, one instruction each, where fminf and fmaxf are calls into the C library.
 * The result is b where either is NaN, or both are zero: a running value goes second. */
#ifndef BASE_EXTREMES_H
#define BASE_EXTREMES_H

static inline float float_min(float a, float b) {
    return a < b ? a : b;
}

static inline float float_max(float a, float b) {
    return a > b ? a : b;
}

#endif
