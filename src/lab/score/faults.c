#include "lab/score/faults.h"

#include "base/memory.h"
#include "metrics/colour.h"
#include "metrics/quantile.h"

#include <math.h>
#include <stdlib.h>

const char *const picture_fault_names[FAULT_COUNT] = {"exposure", "encoded",    "mirrored",
                                                      "shifted",  "other-view", "fireflies"};

/* Luminances of both pictures. */
struct pair {
    int width, height;
    float *picture, *reference;
    double mean; /* of the reference */
};

/* What may have been done to a picture; all zero but the factor: nothing. */
struct change {
    double factor;
    bool encoded, mirrored[2];
    double shift[2];
};

static const struct change unchanged = {.factor = 1};

/* An error below this is nobody's fault; a change is named where the error without it is so much of
 * that with it. */
static const double least_error = .01, explains = .6;

static float *luminances(const struct image *image, double *mean) {
    size_t count = (size_t)image->width * (size_t)image->height;
    float *values = mem_alloc(count, sizeof *values);
    *mean = 0;
    for (size_t i = 0; i < count; i++) {
        values[i] = rgb_luminance(image->pixels + 3 * i);
        *mean += (double)values[i] / (double)count;
    }
    return values;
}

static int clamped(int i, int count) {
    return i < 0 ? 0 : i >= count ? count - 1 : i;
}

static double stored(const struct pair *pair, const struct change *change, int x, int y) {
    x = clamped(change->mirrored[0] ? pair->width - 1 - x : x, pair->width);
    y = clamped(change->mirrored[1] ? pair->height - 1 - y : y, pair->height);
    float value = pair->picture[(size_t)y * (size_t)pair->width + (size_t)x];
    return (double)(change->encoded ? srgb_decode(clamp_unit(value)) : value);
}

/* The picture at the pixel with the change undone. */
static double undone(const struct pair *pair, const struct change *change, int x, int y) {
    double at_x = x + change->shift[0], at_y = y + change->shift[1];
    int left = (int)floor(at_x), top = (int)floor(at_y);
    double right = at_x - left, down = at_y - top, sum = 0;
    for (int corner = 0; corner < 4; corner++) {
        int i = corner % 2, j = corner / 2;
        double share = (i ? right : 1 - right) * (j ? down : 1 - down);
        if (share > 0)
            sum += share * stored(pair, change, left + i, top + j);
    }
    return sum / change->factor;
}

/* Mean of |v - r| / (|v| + |r| + 2 % of the mean): no bright pixel decides alone. */
static double error_without(const struct pair *pair, const struct change *change) {
    double sum = 0;
    for (int y = 0; y < pair->height; y++)
        for (int x = 0; x < pair->width; x++) {
            double v = undone(pair, change, x, y);
            double r = (double)pair->reference[(size_t)y * (size_t)pair->width + (size_t)x];
            double size = fabs(v) + fabs(r) + .02 * pair->mean;
            sum += size > 0 ? fabs(v - r) / size : 0;
        }
    return sum / ((double)pair->width * pair->height);
}

/* The median over pixels that are not dark. */
static double exposure_of(const struct pair *pair) {
    size_t count = (size_t)pair->width * (size_t)pair->height, taken = 0;
    float *ratios = mem_alloc(count, sizeof *ratios);
    for (size_t i = 0; i < count; i++)
        if ((double)pair->reference[i] > .05 * pair->mean && pair->picture[i] > 0)
            ratios[taken++] = pair->picture[i] / pair->reference[i];
    double median = taken ? (double)quantile(ratios, taken, .5) : 1;
    free(ratios);
    return median;
}

/* --- one change ------------------------------------------------------------------------------- */

struct search {
    const struct pair *pair;
    double error, best_error; /* as it is; without the best change */
    enum picture_fault best;  /* FAULT_COUNT: none */
    struct change change;
};

static void try(struct search *search, enum picture_fault fault, const struct change *change) {
    double error = error_without(search->pair, change);
    if (!(error < search->best_error))
        return;
    search->best_error = error;
    search->best = fault;
    search->change = *change;
}

static void try_mirrors(struct search *search) {
    for (int axes = 1; axes < 4; axes++)
        try(search, FAULT_MIRRORED,
            &(struct change){.factor = 1, .mirrored = {axes % 2, axes / 2}});
}

static void find_change(const struct pair *pair, struct picture_faults *faults) {
    double error = error_without(pair, &unchanged);
    struct search search = {
        .pair = pair, .error = error, .best_error = explains * error, .best = FAULT_COUNT};
    if (error < least_error)
        return;
    faults->exposure = exposure_of(pair);
    try(&search, FAULT_EXPOSURE, &(struct change){.factor = faults->exposure});
    try(&search, FAULT_ENCODED, &(struct change){.factor = 1, .encoded = true});
    try_mirrors(&search);
    if (search.best == FAULT_COUNT)
        return;
    faults->found[search.best] = true;
    for (int axis = 0; axis < 2; axis++)
        faults->mirrored[axis] = search.change.mirrored[axis];
}

/* --- shifts ----------------------------------------------------------------------------------- */

/* Between 0 and 1: bright edges count no more than others. */
static double compressed(const struct pair *pair, const float *values, int x, int y) {
    x = clamped(x, pair->width);
    y = clamped(y, pair->height);
    double value = fmax((double)values[(size_t)y * (size_t)pair->width + (size_t)x], 0);
    return value > 0 ? value / (value + pair->mean) : 0;
}

/* The shift by which the reference's gradients explain the difference best [Lucas and Kanade 1981].
 * Noise of the reference and sharp edges make it up to a quarter smaller. */
static void estimate_shift(const struct pair *pair, double shift[2]) {
    double xx = 0, xy = 0, yy = 0, dx = 0, dy = 0;
    for (int y = 0; y < pair->height; y++)
        for (int x = 0; x < pair->width; x++) {
            const float *r = pair->reference;
            double across = (compressed(pair, r, x + 1, y) - compressed(pair, r, x - 1, y)) / 2;
            double down = (compressed(pair, r, x, y + 1) - compressed(pair, r, x, y - 1)) / 2;
            double change = compressed(pair, pair->picture, x, y) - compressed(pair, r, x, y);
            xx += across * across;
            xy += across * down;
            yy += down * down;
            dx -= across * change;
            dy -= down * change;
        }
    double determinant = xx * yy - xy * xy;
    bool can_tell = determinant > 1e-6 * xx * yy;
    shift[0] = can_tell ? (yy * dx - xy * dy) / determinant : 0;
    shift[1] = can_tell ? (xx * dy - xy * dx) / determinant : 0;
}

/* Interpolation blurs what it shifts back, so that the error becomes little less. */
static void find_shift(const struct pair *pair, struct picture_faults *faults) {
    const double least = .25, most = 2, improves = .95;
    double *shift = faults->shift;
    estimate_shift(pair, shift);
    double length = hypot(shift[0], shift[1]), error = error_without(pair, &unchanged);
    struct change change = {.factor = 1, .shift = {shift[0], shift[1]}};
    faults->found[FAULT_SHIFTED] = length > least && length < most && error > least_error &&
                                   error_without(pair, &change) < improves * error;
}

/* --- what no change explains ------------------------------------------------------------------ */

enum { BOXES = 12 };

static void box_logarithms(const struct pair *pair, const float *values,
                           double boxes[BOXES * BOXES]) {
    double counts[BOXES * BOXES] = {0};
    for (int i = 0; i < BOXES * BOXES; i++)
        boxes[i] = 0;
    for (int y = 0; y < pair->height; y++)
        for (int x = 0; x < pair->width; x++) {
            int box = y * BOXES / pair->height * BOXES + x * BOXES / pair->width;
            boxes[box] += (double)values[(size_t)y * (size_t)pair->width + (size_t)x];
            counts[box]++;
        }
    for (int i = 0; i < BOXES * BOXES; i++)
        boxes[i] = log(.01 * pair->mean + fmax(counts[i] > 0 ? boxes[i] / counts[i] : 0, 0));
}

/* 1 where one of both is all alike: nothing can be told. */
static double correlation_of(const struct pair *pair) {
    double a[BOXES * BOXES], b[BOXES * BOXES], mean_a = 0, mean_b = 0, aa = 0, bb = 0, ab = 0;
    if (!(pair->mean > 0))
        return 1;
    box_logarithms(pair, pair->picture, a);
    box_logarithms(pair, pair->reference, b);
    for (int i = 0; i < BOXES * BOXES; i++) {
        mean_a += a[i] / (BOXES * BOXES);
        mean_b += b[i] / (BOXES * BOXES);
    }
    for (int i = 0; i < BOXES * BOXES; i++) {
        aa += (a[i] - mean_a) * (a[i] - mean_a);
        bb += (b[i] - mean_b) * (b[i] - mean_b);
        ab += (a[i] - mean_a) * (b[i] - mean_b);
    }
    return aa > 0 && bb > 0 ? ab / sqrt(aa * bb) : 1;
}

/* Eight times as bright as all of the reference within two pixels, and as its mean. */
static bool is_firefly(const struct pair *pair, int x, int y) {
    const int reach = 2;
    double most = pair->mean;
    for (int j = -reach; j <= reach; j++)
        for (int i = -reach; i <= reach; i++) {
            size_t at = (size_t)clamped(y + j, pair->height) * (size_t)pair->width +
                        (size_t)clamped(x + i, pair->width);
            most = fmax(most, (double)pair->reference[at]);
        }
    return (double)pair->picture[(size_t)y * (size_t)pair->width + (size_t)x] > 8 * most;
}

static void find_fireflies(const struct pair *pair, struct picture_faults *faults) {
    for (int y = 0; y < pair->height; y++)
        for (int x = 0; x < pair->width; x++)
            faults->firefly_count += is_firefly(pair, x, y);
    faults->found[FAULT_FIREFLIES] = faults->firefly_count > 0;
}

void picture_faults_find(const struct image *picture, const struct image *reference,
                         struct picture_faults *faults) {
    const double least_correlation = .5;
    double mean;
    struct pair pair = {.width = picture->width, .height = picture->height};
    pair.picture = luminances(picture, &mean);
    pair.reference = luminances(reference, &pair.mean);
    *faults = (struct picture_faults){.exposure = 1};
    find_change(&pair, faults);
    bool is_changed = faults->found[FAULT_EXPOSURE] || faults->found[FAULT_ENCODED] ||
                      faults->found[FAULT_MIRRORED];
    faults->correlation = correlation_of(&pair);
    faults->found[FAULT_OTHER_VIEW] = !is_changed && faults->correlation < least_correlation;
    if (!is_changed && !faults->found[FAULT_OTHER_VIEW]) {
        find_shift(&pair, faults);
        find_fireflies(&pair, faults);
    }
    mem_free(pair.picture, pair.reference);
}

char *picture_fault_describe(const struct picture_faults *faults, enum picture_fault fault) {
    const bool *mirrored = faults->mirrored;
    switch (fault) {
    case FAULT_EXPOSURE:
        return mem_printf("all of it is %.3g times as bright as the reference", faults->exposure);
    case FAULT_ENCODED:
        return mem_printf("its values are sRGB-encoded, where linear light is due");
    case FAULT_MIRRORED:
        return mem_printf("it is mirrored %s", mirrored[0] && mirrored[1] ? "both ways"
                                               : mirrored[0]              ? "left to right"
                                                                          : "top to bottom");
    case FAULT_SHIFTED:
        return mem_printf("it is shifted by about %.2f pixels to the right and %.2f down",
                          faults->shift[0], faults->shift[1]);
    case FAULT_OTHER_VIEW:
        return mem_printf("another camera, scene or light: lights and darks correlate by %.2f",
                          faults->correlation);
    default:
        return mem_printf("pixels eight times as bright as the reference around them: %d",
                          faults->firefly_count);
    }
}
