#include "quality/estimate.h"

#include "base/log.h"
#include "metrics/layer.h"
#include "quality/picture.h"

#include <math.h>

/* Samples of a pixel, in each half: of the first round, and how many it may have. Each round
 * doubles them. A path each: slivers at silhouettes are seen by few samples. */
enum { FIRST_SAMPLES = 32, MOST_SAMPLES = 256, PATHS_PER_SAMPLE = 1 };

/* By how many standard errors a picture must be better or worse than asked for; and which share of
 * its square a standard error may be: of what is good enough, an error is estimated to a twentieth,
 * of all else to a seventh. */
static const double sure = 2, exact = .1, rough = .3;

/* The pixels' squares are as large as that many of them fill the picture. */
static int side_of_squares(int width, int height) {
    int shorter = width < height ? width : height;
    int side = (int)(sqrt((double)width * height) / ESTIMATE_SIDE);
    return side < 1 ? 1 : side < shorter ? side : shorter;
}

/* --- tracing --- */

/* The picture has means over the samples that saw a surface; as a whole, over all samples. */
static void take_sums(const struct image *picture, const char *name, int samples,
                      struct image *sums) {
    int layer[3], alpha = image_find_channel(picture, "A");
    image_find_layer(picture, name, layer);
    if (!sums->pixels)
        image_init(sums, picture->width, picture->height, "R G B A");
    for (int y = 0; y < sums->height; y++)
        for (int x = 0; x < sums->width; x++) {
            const float *from = image_at(picture, x, y);
            float *to = image_at(sums, x, y);
            float seen = (*name ? from[alpha] : 1) * (float)samples;
            for (int c = 0; c < 3; c++)
                to[c] += from[layer[c]] * seen;
            to[3] += seen;
        }
}

/* Adds so many samples. Seeds that no reference has: these have 0. */
static bool trace(const struct estimate *estimate, int samples, uint32_t seed, struct image *sums) {
    struct path_tracer_desc paths = picture_paths(&estimate->desc);
    struct image picture;
    paths.every = estimate->every;
    paths.samples = samples;
    paths.paths = PATHS_PER_SAMPLE;
    paths.seed = seed;
    if (!picture_trace_paths(estimate->desc.stage, &paths, &picture, NULL))
        return false;
    take_sums(&picture, estimate->layer, samples, sums);
    image_free(&picture);
    return true;
}

/* Rounds are told apart by their seeds: other numbers of samples before them. */
static bool add_round(struct estimate *estimate) {
    int samples = estimate->samples ? estimate->samples : FIRST_SAMPLES;
    bool ok = true;
    for (int i = 0; ok && i < 2; i++)
        ok = trace(estimate, samples, (uint32_t)(2 * estimate->samples + i + 1),
                   &estimate->halves[i]);
    estimate->samples += samples;
    return ok;
}

bool estimate_init(struct estimate *estimate, const struct measure_desc *desc, const char *layer) {
    *estimate = (struct estimate){
        .desc = *desc, .layer = layer, .every = side_of_squares(desc->width, desc->height)};
    return add_round(estimate);
}

void estimate_free(struct estimate *estimate) {
    for (int i = 0; i < 2; i++)
        image_free(&estimate->halves[i]);
    *estimate = (struct estimate){0};
}

/* --- telling --- */

/* Of the layer, the pixels that were traced. */
static bool take_pixels(const struct estimate *estimate, const struct image *picture,
                        struct image *pixels) {
    const struct image *traced = &estimate->halves[0];
    struct image layer;
    if (!layer_extract(&layer, picture, estimate->layer))
        return false;
    image_init(pixels, traced->width, traced->height, "R G B");
    for (int y = 0; y < pixels->height; y++)
        for (int x = 0; x < pixels->width; x++) {
            struct pixel at = path_tracer_pixel(estimate->every, x, y);
            for (int c = 0; c < 3; c++)
                image_at(pixels, x, y)[c] = image_at(&layer, at.x, at.y)[c];
        }
    image_free(&layer);
    return true;
}

/* Sums over pixels and channels, of each as much as is covered. */
struct sums {
    double product;  /* of both differences */
    double variance; /* of that, by the noise alone */
    double reference;
};

/* Of light, where it is as much of the pixel as the half has seen to be covered: nothing is divided
 * by that, so that slivers which few samples see, or none, have no bias. */
static double difference(float pixel, const float *half, int channel, int samples) {
    return ((double)pixel * (double)half[3] - (double)half[channel]) / samples;
}

/* The three channels' noise is one path's. That of a product of two differences e is 2 (e s)^2 +
 * s^4; of s^2, the noise of either half, half the square of what they differ is an estimate, and of
 * s^4 a twelfth of its square. */
static void add_pixel(struct sums *sums, const float *pixel, const float *a, const float *b,
                      int samples) {
    double product = 0, mixed = 0, squares = 0;
    for (int c = 0; c < 3; c++) {
        double from_a = difference(pixel[c], a, c, samples);
        double from_b = difference(pixel[c], b, c, samples), between = from_a - from_b;
        product += from_a * from_b;
        mixed += (from_a + from_b) / 2 * between;
        squares += between * between;
        sums->reference += (double)(a[c] + b[c]) / (2 * samples);
    }
    sums->product += product;
    sums->variance += mixed * mixed + squares * squares / 12;
}

/* Of the square of the relative RMSE; so is its standard error. */
struct estimated {
    double square, standard_error;
};

static struct estimated tell(const struct estimate *estimate, const struct image *pixels) {
    const struct image *halves = estimate->halves;
    struct sums sums = {0};
    for (int y = 0; y < pixels->height; y++)
        for (int x = 0; x < pixels->width; x++)
            add_pixel(&sums, image_at(pixels, x, y), image_at(&halves[0], x, y),
                      image_at(&halves[1], x, y), estimate->samples);
    if (sums.reference <= 0)
        return (struct estimated){sums.product > 0 ? INFINITY : 0, 0};
    double values = 3.0 * pixels->width * pixels->height;
    double scale = values / (sums.reference * sums.reference);
    return (struct estimated){sums.product * scale, sqrt(sums.variance) * scale};
}

static bool is_sure(const struct estimated *estimated, double asked) {
    double over = estimated->square - asked * asked;
    return isinf(estimated->square) ||
           (fabs(over) > sure * estimated->standard_error &&
            estimated->standard_error <= (over > 0 ? rough : exact) * estimated->square);
}

bool estimate_picture_error(struct estimate *estimate, const struct image *picture, double asked,
                            double *error) {
    struct image pixels;
    if (!take_pixels(estimate, picture, &pixels))
        return false;
    struct estimated estimated = tell(estimate, &pixels);
    bool ok = true;
    while (ok && !is_sure(&estimated, asked) && estimate->samples < MOST_SAMPLES) {
        ok = add_round(estimate);
        if (ok)
            estimated = tell(estimate, &pixels);
    }
    image_free(&pixels);
    *error = sqrt(fmax(estimated.square, 0));
    log_detail("%d x 2 samples tell %.2f %%, square's standard error %.2f %%", estimate->samples,
               100 * *error,
               estimated.square > 0 ? 100 * estimated.standard_error / estimated.square : 0);
    return ok;
}

bool estimate_error(struct estimate *estimate, struct renderer *renderer, double asked,
                    double *error) {
    struct image picture = {0};
    bool ok = renderer_read_layers(renderer, &picture) &&
              estimate_picture_error(estimate, &picture, asked, error);
    image_free(&picture);
    return ok;
}
