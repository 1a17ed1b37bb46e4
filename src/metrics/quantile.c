#include "metrics/quantile.h"

#include <stdlib.h>

static int compare_floats(const void *a, const void *b) {
    float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

float quantile(float *values, size_t count, double q) {
    qsort(values, count, sizeof *values, compare_floats);
    size_t rank = (size_t)(q * (double)count);
    return values[rank < count ? rank : count - 1];
}
