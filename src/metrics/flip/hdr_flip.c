#include "metrics/flip/hdr_flip.h"

#include "base/memory.h"
#include "base/parallel.h"
#include "metrics/colour.h"
#include "metrics/flip/flip.h"
#include "metrics/quantile.h"

#include <math.h>

/* Narkowicz's fit of the ACES curve, (k0 x^2 + k1 x) / (k3 x^2 + k4 x + k5), with its exposure of
 * 0.6 multiplied in. */
static const float k0 = 0.36f * 2.51f, k1 = 0.6f * 0.03f;
static const float k3 = 0.36f * 2.43f, k4 = 0.6f * 0.59f, k5 = 0.14f;

static float tone_map(float x) {
    x = fminf(fmaxf(x, 0), 1e4f); /* long white by then, and its square is finite */
    return clamp_unit((k0 * x * x + k1 * x) / (k3 * x * x + k4 * x + k5));
}

/* The value that the curve brings to 0.85: bright, and not yet burnt out. */
static float bright_value(void) {
    const float y = 0.85f;
    const float a = k0 - y * k3, b = k1 - y * k4, c = -y * k5;
    return (-b + sqrtf(b * b - 4 * a * c)) / (2 * a);
}

struct exposure_range hdr_flip_exposures(const struct image *reference) {
    size_t count = (size_t)reference->width * (size_t)reference->height;
    float *luminances = mem_alloc(count, sizeof *luminances);
    for (size_t i = 0; i < count; i++)
        luminances[i] = rgb_luminance(reference->pixels + 3 * i);
    float median = quantile(luminances, count, 0.5), largest = luminances[count - 1];
    for (size_t i = 0; i < count && median <= 0; i++)
        median = luminances[i];
    free(luminances);
    /* A black picture looks the same at any exposure. */
    if (median <= 0)
        median = largest = 1;
    struct exposure_range range = {.first = log2f(bright_value() / largest),
                                   .last = log2f(bright_value() / median)};
    range.count = (int)fmaxf(2, ceilf(range.last - range.first));
    return range;
}

struct exposed_picture {
    const struct image *scene;
    struct image *shown;
    float scale;
};

static void expose_row(void *context, size_t y) {
    const struct exposed_picture *picture = context;
    const float *in = image_at(picture->scene, 0, (int)y);
    float *out = image_at(picture->shown, 0, (int)y);
    for (int i = 0; i < 3 * picture->scene->width; i++)
        out[i] = tone_map(in[i] * picture->scale);
}

static void expose(const struct image *scene, float exposure, int threads, struct image *shown) {
    struct exposed_picture picture = {.scene = scene, .shown = shown, .scale = exp2f(exposure)};
    parallel_for((size_t)scene->height, threads, expose_row, &picture);
}

void flip_hdr(const struct comparison *comparison, float *map) {
    const struct image *reference = comparison->reference;
    size_t pixel_count = (size_t)reference->width * (size_t)reference->height;
    struct image test_shown, reference_shown;
    image_init(&test_shown, reference->width, reference->height, "R G B");
    image_init(&reference_shown, reference->width, reference->height, "R G B");
    struct comparison shown = *comparison;
    shown.test = &test_shown;
    shown.reference = &reference_shown;
    float *exposed_map = mem_alloc(pixel_count, sizeof *exposed_map);
    for (size_t i = 0; i < pixel_count; i++)
        map[i] = 0;

    struct exposure_range range = comparison->exposures;
    if (range.count == 0)
        range = hdr_flip_exposures(reference);
    float step = (range.last - range.first) / fmaxf(1, (float)(range.count - 1));
    for (int i = 0; i < range.count; i++) {
        float exposure = range.first + step * (float)i;
        expose(comparison->test, exposure, comparison->threads, &test_shown);
        expose(reference, exposure, comparison->threads, &reference_shown);
        flip_ldr(&shown, exposed_map);
        for (size_t p = 0; p < pixel_count; p++)
            map[p] = fmaxf(map[p], exposed_map[p]);
    }
    free(exposed_map);
    images_free(&test_shown, &reference_shown);
}
