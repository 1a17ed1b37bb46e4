#include "measure/estimate.h"

#include "base/log.h"
#include "measure/picture.h"
#include "metrics/layer.h"
#include "scene/material.h"

#include <math.h>

/* Samples of a pixel, in each half: of the first round, and how many it may have. Each round doubles them. */
enum { FIRST_SAMPLES = 8, MOST_SAMPLES = 128, PATHS_PER_SAMPLE = 4 };

/* By how many standard errors a picture must be better or worse than asked for; and which share of its square a
 * standard error may be of what is good enough: an error is then told to a twentieth. */
static const double sure = 2, exact = .1;

/* The pixels' squares are as large as that many of them fill the picture. */
static int side_of_squares(int width, int height) {
    int shorter = width < height ? width : height;
    int side = (int)(sqrt((double)width * height) / ESTIMATE_SIDE);
    return side < 1 ? 1 : side < shorter ? side : shorter;
}

/* --- tracing --- */

/* Seeds that no reference has: these have 0. */
static bool trace(const struct estimate *estimate, int samples, uint32_t seed,
                  struct image *layer) {
    const struct measure_desc *desc = &estimate->desc;
    const struct material_settings *surface = settings_of(&desc->settings, &material_part);
    struct image picture;
    if (!picture_trace_paths(desc->stage,
                             &(struct path_tracer_desc){.width = desc->width,
                                                        .height = desc->height,
                                                        .every = estimate->every,
                                                        .bounces = measure_bounces(desc),
                                                        .samples = samples,
                                                        .paths = PATHS_PER_SAMPLE,
                                                        .seed = seed,
                                                        .materials = surface->materials},
                             &picture, NULL))
        return false;
    bool ok = layer_extract(layer, &picture, "indirect");
    image_free(&picture);
    return ok;
}

static size_t value_count(const struct image *image) {
    return (size_t)image->width * (size_t)image->height * 3;
}

/* To a mean of as many samples. */
static void add_half(struct image *mean, struct image *half) {
    if (!mean->pixels) {
        *mean = *half;
        return;
    }
    for (size_t i = 0; i < value_count(mean); i++)
        mean->pixels[i] = (mean->pixels[i] + half->pixels[i]) / 2;
    image_free(half);
}

/* Rounds are told apart by their seeds: other numbers of samples before them. */
static bool add_round(struct estimate *estimate) {
    int samples = estimate->samples ? estimate->samples : FIRST_SAMPLES;
    bool ok = true;
    for (int i = 0; ok && i < 2; i++) {
        struct image half;
        ok = trace(estimate, samples, (uint32_t)(2 * estimate->samples + i + 1), &half);
        if (ok)
            add_half(&estimate->halves[i], &half);
    }
    estimate->samples += samples;
    return ok;
}

bool estimate_init(struct estimate *estimate, const struct measure_desc *desc) {
    *estimate =
        (struct estimate){.desc = *desc, .every = side_of_squares(desc->width, desc->height)};
    return add_round(estimate);
}

void estimate_free(struct estimate *estimate) {
    for (int i = 0; i < 2; i++)
        image_free(&estimate->halves[i]);
    *estimate = (struct estimate){0};
}

/* --- telling --- */

/* Of the whole picture's indirect layer, the pixels that were traced. */
static bool take_pixels(const struct estimate *estimate, const struct image *picture,
                        struct image *pixels) {
    const struct image *traced = &estimate->halves[0];
    struct image layer;
    if (!layer_extract(&layer, picture, "indirect"))
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

/* Sums over pixels and channels. */
struct sums {
    double product;  /* of both differences */
    double variance; /* of that, by the noise alone */
    double truth;
};

/* The three channels' noise is one path's. That of a product of two differences e is 2 (e s)^2 + s^4; of s^2, the noise
 * of either half, half the square of what they differ is an estimate, and of s^4 a twelfth of its square. */
static void add_pixel(struct sums *sums, const float *pixel, const float *a, const float *b) {
    double product = 0, mixed = 0, squares = 0;
    for (int c = 0; c < 3; c++) {
        double from_a = (double)(pixel[c] - a[c]), from_b = (double)(pixel[c] - b[c]);
        double between = (double)(a[c] - b[c]);
        product += from_a * from_b;
        mixed += (from_a + from_b) / 2 * between;
        squares += between * between;
        sums->truth += (double)(a[c] + b[c]) / 2;
    }
    sums->product += product;
    sums->variance += mixed * mixed + squares * squares / 12;
}

/* Of the square of the relative RMSE; so is its standard error. */
struct told {
    double square, standard_error;
};

static struct told tell(const struct estimate *estimate, const struct image *pixels) {
    struct sums sums = {0};
    size_t values = value_count(pixels);
    for (size_t i = 0; i < values; i += 3)
        add_pixel(&sums, &pixels->pixels[i], &estimate->halves[0].pixels[i],
                  &estimate->halves[1].pixels[i]);
    if (sums.truth <= 0)
        return (struct told){sums.product > 0 ? INFINITY : 0, 0};
    double scale = (double)values / (sums.truth * sums.truth);
    return (struct told){sums.product * scale, sqrt(sums.variance) * scale};
}

/* What is not good enough need not be told exactly. */
static bool is_sure(const struct told *told, double asked) {
    double over = told->square - asked * asked;
    return isinf(told->square) || (fabs(over) > sure * told->standard_error &&
                                   (over > 0 || told->standard_error <= exact * told->square));
}

bool estimate_picture_error(struct estimate *estimate, const struct image *picture, double asked,
                            double *error) {
    struct image pixels;
    if (!take_pixels(estimate, picture, &pixels))
        return false;
    struct told told = tell(estimate, &pixels);
    bool ok = true;
    while (ok && !is_sure(&told, asked) && estimate->samples < MOST_SAMPLES) {
        ok = add_round(estimate);
        if (ok)
            told = tell(estimate, &pixels);
    }
    image_free(&pixels);
    *error = sqrt(fmax(told.square, 0));
    log_detail("%d x 2 samples tell %.2f %%, square's standard error %.2f %%", estimate->samples,
               100 * *error, told.square > 0 ? 100 * told.standard_error / told.square : 0);
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
