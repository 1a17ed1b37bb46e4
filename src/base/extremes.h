/* Minimum and maximum of two floats, in one instruction each; fminf and fmaxf are calls into the C
 * library. The result is b if either is NaN or both are zero: pass a running value second. */
#ifndef BASE_EXTREMES_H
#define BASE_EXTREMES_H

static inline float float_min(float a, float b) {
    return a < b ? a : b;
}

static inline float float_max(float a, float b) {
    return a > b ? a : b;
}

#endif
