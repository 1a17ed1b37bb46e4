#include "lab/measure/panels.h"

#include "base/file/image_file.h"
#include "base/memory.h"
#include "metrics/colour.h"
#include "metrics/heat_map.h"

#include <math.h>
#include <string.h>

/* Of the reference's mean: it is shown as a middle grey. */
static const float shown_mean = .25f;

enum { GAP = 2 }; /* pixels between panels */

/* The reference first. */
static struct image side_by_side(const struct image *reference, const struct image *tests,
                                 int count) {
    struct image all;
    int step = reference->width + GAP;
    image_init(&all, step * count + reference->width, reference->height, "R G B");
    for (int i = 0; i <= count; i++)
        for (int y = 0; y < reference->height; y++) {
            const struct image *from = i ? &tests[i - 1] : reference;
            if (from->pixels)
                memcpy(image_at(&all, i * step, y), image_at(from, 0, y),
                       3 * (size_t)reference->width * sizeof(float));
        }
    return all;
}

/* Of every panel but the reference's own, over the reference's mean. */
static float *differences(const struct image *all, const struct image *reference, double mean) {
    float *values = mem_alloc((size_t)all->width * (size_t)all->height, sizeof *values),
          *to = values;
    int step = reference->width + GAP;
    for (int y = 0; y < all->height; y++)
        for (int x = 0; x < all->width; x++, to++) {
            if (x < step || x % step >= reference->width)
                continue;
            const float *v = image_at(all, x, y), *r = image_at(reference, x % step, y);
            double difference = (double)(v[0] - r[0] + v[1] - r[1] + v[2] - r[2]) / 3;
            *to = (float)(mean > 0 ? difference / mean : difference);
        }
    return values;
}

/* Values that are not finite have no colour of their own: figures name them. */
static unsigned char display(float value, double mean) {
    float shown = mean > 0 ? value * shown_mean / (float)mean : value;
    return (unsigned char)lrintf(255 * srgb_encode(isfinite(shown) ? shown : 0));
}

/* The light above the heat map's picture, enlarged as that is. */
static struct bitmap stack(const struct image *all, const struct bitmap *below, double mean) {
    int zoom = below->width / all->width, above = all->height * zoom;
    size_t row = 4 * (size_t)below->width;
    struct bitmap whole = {.width = below->width, .height = above + below->height};
    whole.rgba = mem_alloc((size_t)whole.height, row);
    for (int y = 0; y < above; y++)
        for (int x = 0; x < below->width; x++) {
            unsigned char *to = whole.rgba + (size_t)y * row + 4 * (size_t)x;
            for (int c = 0; c < 3 && x / zoom < all->width; c++)
                to[c] = display(image_at(all, x / zoom, y / zoom)[c], mean);
            to[3] = 255;
        }
    memcpy(whole.rgba + (size_t)above * row, below->rgba, (size_t)below->height * row);
    return whole;
}

bool panels_write(const char *path, const char *title, const struct image *reference,
                  const struct image *tests, int test_count) {
    struct image all = side_by_side(reference, tests, test_count);
    double mean = image_mean(reference, (int[]){0, 1, 2});
    float *values = differences(&all, reference, mean);
    struct bitmap below;
    heat_map_draw(&(struct heat_map){.title = title,
                                     .width = all.width,
                                     .height = all.height,
                                     .values = values,
                                     .top = 1,
                                     .is_signed = true},
                  &below);
    struct bitmap whole = stack(&all, &below, mean);
    bool ok = bitmap_write(&whole, path);
    bitmaps_free(&whole, &below);
    image_free(&all);
    free(values);
    return ok;
}
