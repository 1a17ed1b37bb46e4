#include "metrics/worst_share.h"

#include "base/memory.h"
#include "metrics/errors.h"
#include "metrics/quantile.h"

#include <stdlib.h>
#include <string.h>

static double sum_of(const float *values, size_t count) {
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += (double)values[i];
    return sum;
}

/* All but the worst are below. */
static const double most = 0.99;

static float threshold_of(const float *errors, size_t count) {
    float *sorted = mem_copy(errors, count, sizeof *sorted);
    float threshold = quantile(sorted, count, most);
    free(sorted);
    return threshold;
}

void worst_share(const struct comparison *comparison, float *map) {
    int width = comparison->reference->width, height = comparison->reference->height;
    size_t count = (size_t)width * (size_t)height;
    size_t worst = count - (size_t)(most * (double)count);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++)
            map[(size_t)y * (size_t)width + (size_t)x] = squared_error(comparison, x, y);
    double total = sum_of(map, count);
    float threshold = threshold_of(map, count);
    size_t above = 0, equal = 0;
    for (size_t i = 0; i < count; i++) {
        above += map[i] > threshold;
        equal += map[i] == threshold;
    }
    double part_of_equal = (double)(worst - above) / (double)equal;
    for (size_t i = 0; i < count && total > 0; i++) {
        double part = map[i] > threshold ? 1 : map[i] == threshold ? part_of_equal : 0;
        map[i] = (float)(part * (double)map[i] / total * (double)count);
    }
}
