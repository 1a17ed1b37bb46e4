#include "metrics/area_errors.h"

#include "base/memory.h"
#include "metrics/errors.h"
#include "metrics/quantile.h"

/* --- boxes ------------------------------------------------------------------------------------ */

struct box {
    int x, y, end_x, end_y;
};

static double mean_difference(const struct comparison *comparison, const struct box *box, int c) {
    double sum = 0;
    for (int y = box->y; y < box->end_y; y++)
        for (int x = box->x; x < box->end_x; x++)
            sum += (double)image_at(comparison->test, x, y)[c] -
                   (double)image_at(comparison->reference, x, y)[c];
    return sum / ((box->end_x - box->x) * (box->end_y - box->y));
}

static void fill_box(const struct comparison *comparison, const struct box *box, float *map) {
    double squares = 0;
    for (int c = 0; c < 3; c++) {
        double difference = mean_difference(comparison, box, c);
        squares += difference * difference;
    }
    for (int y = box->y; y < box->end_y; y++)
        for (int x = box->x; x < box->end_x; x++)
            map[(size_t)y * (size_t)comparison->reference->width + (size_t)x] = (float)squares / 3;
}

static int least(int a, int b) {
    return a < b ? a : b;
}

static void box_error(const struct comparison *comparison, int size, float *map) {
    int width = comparison->reference->width, height = comparison->reference->height;
    for (int y = 0; y < height; y += size)
        for (int x = 0; x < width; x += size)
            fill_box(comparison,
                     &(struct box){x, y, least(x + size, width), least(y + size, height)}, map);
}

void box_error_4(const struct comparison *comparison, float *map) {
    box_error(comparison, 4, map);
}

void box_error_16(const struct comparison *comparison, float *map) {
    box_error(comparison, 16, map);
}

/* --- the worst pixels ------------------------------------------------------------------------- */

static double sum_of(const float *values, size_t count) {
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += (double)values[i];
    return sum;
}

/* Pixels below this quantile of squared errors get 0. */
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
