#include "metrics/flip/flip.h"

#include "base/memory.h"
#include "base/parallel.h"
#include "metrics/colour.h"
#include "metrics/flip/flip_filter.h"

#include <math.h>

/* The picture is cut in strips of so many rows; neighbours filter the rows between them twice. */
enum { STRIP_ROWS = 32 };

/* A pixel as seen: its colour through the contrast sensitivity, and what stands out in it. */
struct appearance {
    float lab[3]; /* as rgb_to_hunt gives it */
    float edge, point;
};

struct flip {
    const struct comparison *comparison;
    struct flip_filters filters;
    float largest_distance;
    float *map;
};

/* Rows that both filter passes of one strip work in. */
struct strip {
    int first_row, row_count;
    int width, radius;
    float4 *padded;           /* one row, borders replicated: width + 2 radius */
    float4 *colour, *feature; /* row_count + 2 radius rows, filtered along x */
    float4 *filtered;         /* one row, filtered along both */
};

static void strip_init(struct strip *strip, const struct flip *flip, size_t index) {
    const struct image *reference = flip->comparison->reference;
    int first = (int)index * STRIP_ROWS, left = reference->height - first;
    *strip = (struct strip){.first_row = first,
                            .row_count = left < STRIP_ROWS ? left : STRIP_ROWS,
                            .width = reference->width,
                            .radius = flip->filters.radius};
    size_t width = (size_t)strip->width, margin = 2 * (size_t)strip->radius;
    size_t rows = (size_t)strip->row_count + margin;
    strip->padded = mem_alloc(width + margin, sizeof(float4));
    strip->colour = mem_alloc(rows * width, sizeof(float4));
    strip->feature = mem_alloc(rows * width, sizeof(float4));
    strip->filtered = mem_alloc(width, sizeof(float4));
}

static void strip_free(struct strip *strip) {
    mem_free(strip->padded, strip->colour, strip->feature, strip->filtered);
}

static int clamp_index(int i, int count) {
    return i < 0 ? 0 : i < count ? i : count - 1;
}

/* A row as (Y, Cx, Cz, Cz), the lanes of the colour filter. */
static void load_row(struct strip *strip, const struct image *image, int y) {
    y = clamp_index(y, image->height);
    for (int i = 0; i < strip->width + 2 * strip->radius; i++) {
        const float *pixel = image_at(image, clamp_index(i - strip->radius, image->width), y);
        float shown[3], ycxcz[3];
        for (int c = 0; c < 3; c++)
            shown[c] = clamp_unit(pixel[c]);
        rgb_to_ycxcz(shown, ycxcz);
        strip->padded[i] = (float4){ycxcz[0], ycxcz[1], ycxcz[2], ycxcz[2]};
    }
}

/* The loaded row as (Y, Y, Y, Y) over [0, 1], the lanes of the feature filter. */
static void keep_luminance(struct strip *strip) {
    for (int i = 0; i < strip->width + 2 * strip->radius; i++) {
        float y = (strip->padded[i][0] + 16) / 116;
        strip->padded[i] = (float4){y, y, y, y};
    }
}

static void filter_along_x(struct strip *strip, const struct flip_filters *filters,
                           const struct image *image) {
    int radius = strip->radius, width = strip->width;
    for (int row = 0; row < strip->row_count + 2 * radius; row++) {
        size_t at = (size_t)row * (size_t)width;
        load_row(strip, image, strip->first_row + row - radius);
        filter_row(filters->colour.row, radius, strip->padded, strip->colour + at, width);
        keep_luminance(strip);
        filter_row(filters->feature.row, radius, strip->padded, strip->feature + at, width);
    }
}

/* CIELAB with the Hunt effect: colours look stronger where it is bright. */
static void rgb_to_hunt(const float rgb[3], float lab[3]) {
    rgb_to_lab(rgb, lab);
    lab[1] *= 0.01f * lab[0];
    lab[2] *= 0.01f * lab[0];
}

static void see_colour(float4 filtered, float lab[3]) {
    float rgb[3];
    ycxcz_to_rgb((const float[]){filtered[0], filtered[1], filtered[2] + filtered[3]}, rgb);
    for (int c = 0; c < 3; c++)
        rgb[c] = clamp_unit(rgb[c]);
    rgb_to_hunt(rgb, lab);
}

/* What the image looks like in one row of the strip, after filter_along_x. */
static void see_row(struct strip *strip, const struct flip_filters *filters, int row,
                    struct appearance *seen) {
    int radius = strip->radius, width = strip->width;
    size_t at = (size_t)row * (size_t)width;
    filter_columns(filters->colour.column, radius, strip->colour + at, strip->filtered, width);
    for (int x = 0; x < width; x++)
        see_colour(strip->filtered[x], seen[x].lab);
    filter_columns(filters->feature.column, radius, strip->feature + at, strip->filtered, width);
    for (int x = 0; x < width; x++) {
        float4 f = strip->filtered[x];
        seen[x].edge = sqrtf(f[0] * f[0] + f[1] * f[1]);
        seen[x].point = sqrtf(f[2] * f[2] + f[3] * f[3]);
    }
}

static struct appearance *see_strip(struct strip *strip, const struct flip_filters *filters,
                                    const struct image *image) {
    size_t width = (size_t)strip->width;
    struct appearance *seen = mem_alloc((size_t)strip->row_count * width, sizeof *seen);
    filter_along_x(strip, filters, image);
    for (int row = 0; row < strip->row_count; row++)
        see_row(strip, filters, row, seen + (size_t)row * width);
    return seen;
}

/* HyAB, which holds for large distances too, to the power 0.7. */
static float colour_distance(const float a[3], const float b[3]) {
    float da = a[1] - b[1], db = a[2] - b[2];
    return powf(fabsf(a[0] - b[0]) + sqrtf(da * da + db * db), 0.7f);
}

/* Spreads the small distances: those up to 0.4 of the largest take [0, 0.95]. */
static float spread_distance(float distance, float largest) {
    const float knee = 0.4f * largest;
    if (distance < knee)
        return 0.95f * distance / knee;
    return 0.95f + 0.05f * (distance - knee) / (largest - knee);
}

static float pixel_error(const struct appearance *v, const struct appearance *r, float largest) {
    float colour = spread_distance(colour_distance(v->lab, r->lab), largest);
    float feature = fmaxf(fabsf(v->edge - r->edge), fabsf(v->point - r->point));
    return powf(colour, 1 - sqrtf(feature / sqrtf(2)));
}

static void measure_strip(void *context, size_t index) {
    const struct flip *flip = context;
    struct strip strip;
    strip_init(&strip, flip, index);
    struct appearance *test = see_strip(&strip, &flip->filters, flip->comparison->test);
    struct appearance *reference = see_strip(&strip, &flip->filters, flip->comparison->reference);
    size_t width = (size_t)strip.width;
    float *map = flip->map + (size_t)strip.first_row * width;
    for (size_t i = 0; i < (size_t)strip.row_count * width; i++)
        map[i] = pixel_error(&test[i], &reference[i], flip->largest_distance);
    mem_free(test, reference);
    strip_free(&strip);
}

/* The greatest distance between colours of sRGB: green to blue. */
static float find_largest_distance(void) {
    float green[3], blue[3];
    rgb_to_hunt((const float[]){0, 1, 0}, green);
    rgb_to_hunt((const float[]){0, 0, 1}, blue);
    return colour_distance(green, blue);
}

void flip_ldr(const struct comparison *comparison, float *map) {
    struct flip flip = {.comparison = comparison, .map = map};
    flip_filters_init(&flip.filters, comparison->pixels_per_degree);
    flip.largest_distance = find_largest_distance();
    size_t strips = ((size_t)comparison->reference->height + STRIP_ROWS - 1) / STRIP_ROWS;
    parallel_for(strips, comparison->threads, measure_strip, &flip);
    flip_filters_free(&flip.filters);
}
