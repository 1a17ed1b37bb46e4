#include "measure/estimate.h"

#include "base/log.h"
#include "measure/picture.h"
#include "measure/truth.h"
#include "metrics/layer.h"
#include "metrics/metric.h"
#include "scene/material.h"

#include <math.h>

/* The pixels' squares are as large as that many of them fill the picture. */
static int side_of_squares(int width, int height) {
    int shorter = width < height ? width : height;
    int side = (int)(sqrt((double)width * height) / ESTIMATE_SIDE);
    return side < 1 ? 1 : side < shorter ? side : shorter;
}

bool estimate_init(struct estimate *estimate, const struct measure_desc *desc, double noise) {
    const struct material_settings *surface = settings_of(&desc->settings, &material_part);
    *estimate = (struct estimate){.every = side_of_squares(desc->width, desc->height)};
    if (!picture_trace_paths(desc->stage,
                             &(struct path_tracer_desc){.width = desc->width,
                                                        .height = desc->height,
                                                        .every = estimate->every,
                                                        .bounces = measure_bounces(desc),
                                                        .noise = noise,
                                                        .materials = surface->materials},
                             &estimate->truth, NULL))
        return false;
    estimate->noise = truth_noise(&estimate->truth);
    log_detail("%d pixels traced, noise %.2f %%", estimate->truth.width * estimate->truth.height,
               100 * estimate->noise);
    return true;
}

void estimate_free(struct estimate *estimate) {
    image_free(&estimate->truth);
    *estimate = (struct estimate){0};
}

/* Of the whole picture's indirect layer, the pixels that were traced. */
static bool take_pixels(const struct estimate *estimate, const struct image *picture,
                        struct image *pixels) {
    struct image layer;
    if (!layer_extract(&layer, picture, "indirect"))
        return false;
    image_init(pixels, estimate->truth.width, estimate->truth.height, "R G B");
    for (int y = 0; y < pixels->height; y++)
        for (int x = 0; x < pixels->width; x++) {
            struct pixel at = path_tracer_pixel(estimate->every, x, y);
            for (int c = 0; c < 3; c++)
                image_at(pixels, x, y)[c] = image_at(&layer, at.x, at.y)[c];
        }
    image_free(&layer);
    return true;
}

bool estimate_picture_error(const struct estimate *estimate, const struct image *picture,
                            double *error) {
    struct image pixels = {0}, truth = {0};
    bool ok = take_pixels(estimate, picture, &pixels) &&
              layer_extract(&truth, &estimate->truth, "indirect");
    if (ok) {
        struct comparison comparison = {.test = &pixels, .reference = &truth};
        double with_noise = metric_measure(metric_find("relative-rmse"), &comparison, NULL);
        *error = sqrt(fmax(with_noise * with_noise - estimate->noise * estimate->noise, 0));
    }
    image_free(&pixels);
    image_free(&truth);
    return ok;
}

bool estimate_error(const struct estimate *estimate, struct renderer *renderer, double *error) {
    struct image picture = {0};
    bool ok = renderer_read_layers(renderer, &picture) &&
              estimate_picture_error(estimate, &picture, error);
    image_free(&picture);
    return ok;
}
