#include "apps/failure_picture.h"

#include "base/image_file.h"
#include "base/memory.h"
#include "metrics/colour.h"
#include "metrics/heat_map.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of the mean of the reference: it is shown as a middle grey. */
static const float shown_mean = 0.25f;

enum { GAP = 2 }; /* pixels between panels */

static double mean_of(const struct image *image) {
    double sum = 0;
    size_t count = (size_t)image->width * (size_t)image->height * 3;
    for (size_t i = 0; i < count; i++)
        sum += (double)image->pixels[i];
    return sum / (double)count;
}

static int panels_width(const struct failure_picture *picture) {
    return (picture->test_count + 1) * (picture->reference->width + GAP) - GAP;
}

/* The panel that a column belongs to (0 = the reference) and its x there; false: a gap. */
static bool panel_at(const struct failure_picture *picture, int column, int *panel, int *x) {
    int step = picture->reference->width + GAP;
    *panel = column / step;
    *x = column % step;
    return *x < picture->reference->width;
}

/* Differences over the reference's mean, all panels side by side; that of the reference is empty.
 */
static float *difference_panels(const struct failure_picture *picture, double mean) {
    const struct image *reference = picture->reference;
    int width = panels_width(picture), panel, x;
    float *values = mem_alloc((size_t)width * (size_t)reference->height, sizeof *values);
    for (int y = 0; y < reference->height; y++)
        for (int column = 0; column < width; column++) {
            if (!panel_at(picture, column, &panel, &x) || panel == 0)
                continue;
            const float *v = image_at(&picture->tests[panel - 1], x, y);
            const float *r = image_at(reference, x, y);
            double difference = (double)(v[0] - r[0] + v[1] - r[1] + v[2] - r[2]) / 3;
            values[(size_t)y * (size_t)width + (size_t)column] =
                (float)(mean > 0 ? difference / mean : difference);
        }
    return values;
}

/* Non-finite values have no colour of their own: metrics name them. */
static unsigned char display(float value, double mean) {
    float shown = mean > 0 ? value * shown_mean / (float)mean : value;
    return (unsigned char)lrintf(255 * srgb_encode(isfinite(shown) ? shown : 0));
}

static void draw_light(const struct failure_picture *picture, struct bitmap *bitmap, int zoom,
                       double mean) {
    for (int y = 0; y < picture->reference->height * zoom; y++)
        for (int column = 0; column < panels_width(picture) * zoom; column++) {
            int panel, x;
            unsigned char *rgba =
                bitmap->rgba + 4 * ((size_t)y * (size_t)bitmap->width + (size_t)column);
            if (!panel_at(picture, column / zoom, &panel, &x))
                continue;
            const struct image *image = panel ? &picture->tests[panel - 1] : picture->reference;
            for (int c = 0; c < 3; c++)
                rgba[c] = display(image_at(image, x, y / zoom)[c], mean);
        }
}

/* The panels of light above the heat map's picture. */
static void stack(const struct failure_picture *picture, const struct bitmap *below,
                  struct bitmap *whole, double mean) {
    int zoom = below->width / panels_width(picture);
    int above = picture->reference->height * zoom;
    *whole = (struct bitmap){.width = below->width, .height = above + below->height};
    size_t row = 4 * (size_t)below->width;
    whole->rgba = mem_alloc((size_t)whole->height, row);
    for (size_t i = 3; i < (size_t)above * row; i += 4)
        whole->rgba[i] = 255;
    draw_light(picture, whole, zoom, mean);
    memcpy(whole->rgba + (size_t)above * row, below->rgba, (size_t)below->height * row);
}

bool failure_picture_write(const struct failure_picture *picture, const char *path) {
    double mean = mean_of(picture->reference);
    struct heat_map map = {
        .title = picture->title,
        .width = panels_width(picture),
        .height = picture->reference->height,
        .top = 1,
        .is_signed = true,
    };
    float *values = difference_panels(picture, mean);
    struct bitmap below, whole;
    map.values = values;
    heat_map_draw(&map, &below);
    stack(picture, &below, &whole, mean);
    bool ok = bitmap_write(&whole, path);
    bitmap_free(&below);
    bitmap_free(&whole);
    free(values);
    return ok;
}
