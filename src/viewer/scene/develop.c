#include "viewer/scene/develop.h"

#include "base/memory.h"
#include "metrics/colour.h"

#include <math.h>
#include <stdlib.h>

/* The brightness that the middle of the picture gets, and the most that its brightest twentieth and
 * fiftieth may: the filmic curve shows 2.5 as 248 of 255, so that the form of what a lamp lights is
 * seen. */
static const double middle_grey = .14, brightest = 4, below_white = 2.5;

static int ascending(const void *a, const void *b) {
    const double *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

/* How bright each pixel is that is not black, in an array for free(); how many they are. */
static double *read_luminances(const struct image *image, size_t *number) {
    int channels[3];
    size_t pixels = (size_t)image->width * (size_t)image->height, count = 0;
    double *values = mem_alloc(pixels, sizeof *values);
    if (image_find_layer(image, "", channels))
        for (size_t i = 0; i < pixels; i++) {
            const float *pixel = image->pixels + i * (size_t)image->channel_count;
            const float rgb[3] = {pixel[channels[0]], pixel[channels[1]], pixel[channels[2]]};
            values[count] = (double)rgb_luminance(rgb);
            count += isfinite(values[count]) && values[count] > 1e-6;
        }
    *number = count;
    return values;
}

double develop_highlight(const struct image *image) {
    size_t count;
    double *values = read_luminances(image, &count), highlight = 0;
    if (count > 0) {
        qsort(values, count, sizeof *values, ascending);
        highlight = values[count - 1 - count / 20];
    }
    free(values);
    return highlight;
}

/* The median of what is not black tells the middle, unless the lights would then be white
 * all over. */
float develop_exposure(const struct image *image) {
    size_t count;
    double *values = read_luminances(image, &count), ev = 0;
    if (count > 0) {
        qsort(values, count, sizeof *values, ascending);
        ev = fmin(log2(middle_grey / values[count / 2]),
                  log2(brightest / values[count - 1 - count / 20]));
        ev = fmin(ev, log2(below_white / values[count - 1 - count / 50]));
    }
    free(values);
    return (float)(round(4 * fmin(fmax(ev, -30), 30)) / 4 + 0.); /* no -0 */
}

/* As src/passes/picture/display.glsl has it. */
static double filmic(double x) {
    double y = x * (2.51 * x + .03) / (x * (2.43 * x + .59) + .14);
    return fmin(fmax(y, 0), 1);
}

void develop_picture(const struct image *image, float exposure, struct bitmap *bitmap) {
    int channels[3];
    size_t pixels = (size_t)image->width * (size_t)image->height;
    *bitmap = (struct bitmap){image->width, image->height, mem_alloc(pixels, 4)};
    if (!image_find_layer(image, "", channels))
        return;
    for (size_t i = 0; i < pixels; i++)
        for (int c = 0; c < 4; c++) {
            const float *pixel = image->pixels + i * (size_t)image->channel_count;
            double value = c < 3 ? (double)pixel[channels[c]] * exp2((double)exposure) : 0;
            bitmap->rgba[4 * i + (size_t)c] =
                c < 3 ? (unsigned char)lrintf(255 * srgb_encode((float)filmic(fmax(value, 0))))
                      : 255;
        }
}
