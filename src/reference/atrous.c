#include "reference/atrous.h"

#include "base/memory.h"
#include "base/parallel.h"

#include <math.h>
#include <string.h>

/* Standard deviations of two pixels' difference at which its weight is 1/e. */
static const float light_tolerance = 2;

/* How alike two surfaces must be. */
struct tolerance {
    float plane;          /* pixels' sizes off the tangent plane for a weight of 1/e */
    int normal_doublings; /* the weight is the normals' cosine to 2 to this */
};

static const struct tolerance strict = {0.5f, 6}, loose = {8, 2};

/* Of the weights of the nearest 5 x 5 pixels, the share on the same surface that is enough. */
static const float company_enough = 0.3f;

struct work {
    const struct atrous_desc *desc;
    const struct atrous_pixel *from;
    struct atrous_pixel *to;
    int step;
    bool compares_light, known;
};

static float mean_of(vec3s light) {
    return (light.x + light.y + light.z) / 3;
}

static bool is_inside(const struct atrous_desc *desc, int x, int y) {
    return x >= 0 && y >= 0 && x < desc->width && y < desc->height;
}

static bool is_seen(const struct atrous_guide *guide) {
    return guide->pixel_size > 0;
}

static float normal_weight(const struct atrous_guide *p, const struct atrous_guide *q,
                           int doublings) {
    float cosine = fmaxf(0, glms_vec3_dot(p->normal, q->normal));
    for (int i = 0; i < doublings; i++)
        cosine *= cosine;
    return cosine;
}

/* How likely both show one smooth surface. */
static float surface_weight(const struct atrous_guide *p, const struct atrous_guide *q) {
    const struct tolerance *tolerance = p->is_lonely ? &loose : &strict;
    if (!is_seen(q))
        return 0;
    float weight = normal_weight(p, q, tolerance->normal_doublings);
    if (weight < 1e-3f)
        return 0;
    float distance = glms_vec3_dot(p->normal, glms_vec3_sub(q->position, p->position));
    return weight * expf(-fabsf(distance) / (tolerance->plane * p->pixel_size));
}

static float light_weight(const struct atrous_pixel *p, const struct atrous_pixel *q) {
    float difference = fabsf(mean_of(p->light) - mean_of(q->light));
    if (difference == 0)
        return 1;
    float noise = sqrtf(p->variance + q->variance);
    return noise > 0 ? expf(-difference / (light_tolerance * noise)) : 0;
}

/* The B3 spline at -2 to 2 in each direction; the sum is 1. */
static float spline_weight(int i, int j) {
    static const float spline[] = {3 / 8.f, 1 / 4.f, 1 / 16.f};
    return spline[abs(i)] * spline[abs(j)];
}

static struct atrous_pixel filtered(const struct work *work, int x, int y) {
    const struct atrous_desc *desc = work->desc;
    size_t p = (size_t)y * (size_t)desc->width + (size_t)x;
    struct atrous_pixel sum = {0};
    float weight_sum = 0;
    for (int j = -2; j <= 2; j++)
        for (int i = -2; i <= 2; i++) {
            int qx = x + i * work->step, qy = y + j * work->step;
            if (!is_inside(desc, qx, qy))
                continue;
            size_t q = (size_t)qy * (size_t)desc->width + (size_t)qx;
            float weight = spline_weight(i, j) * surface_weight(&desc->guides[p], &desc->guides[q]);
            if (work->compares_light && weight > 0)
                weight *= light_weight(&work->from[p], &work->from[q]);
            weight_sum += weight;
            sum.light = glms_vec3_muladds(work->from[q].light, weight, sum.light);
            sum.variance += weight * weight * work->from[q].variance;
        }
    return (struct atrous_pixel){glms_vec3_scale(sum.light, 1 / weight_sum),
                                 sum.variance / (weight_sum * weight_sum)};
}

static void filter_row(void *context, size_t row) {
    const struct work *work = context;
    const struct atrous_desc *desc = work->desc;
    for (int x = 0; x < desc->width; x++) {
        size_t p = row * (size_t)desc->width + (size_t)x;
        work->to[p] = is_seen(&desc->guides[p]) ? filtered(work, x, (int)row) : work->from[p];
    }
}

void atrous_filter(const struct atrous_desc *desc, struct atrous_pixel *pixels) {
    size_t count = (size_t)desc->width * (size_t)desc->height;
    struct atrous_pixel *other = mem_alloc(count, sizeof *other);
    for (int level = 0; level < desc->levels; level++) {
        struct work work = {.desc = desc,
                            .from = pixels,
                            .to = other,
                            .step = 1 << level,
                            .compares_light = level >= desc->blind_levels};
        parallel_for((size_t)desc->height, desc->threads, filter_row, &work);
        memcpy(pixels, other, count * sizeof *pixels);
    }
    free(other);
}

static float estimated_variance(const struct work *work, int x, int y) {
    const struct atrous_desc *desc = work->desc;
    size_t p = (size_t)y * (size_t)desc->width + (size_t)x;
    float weight_sum = 0, sum = 0, square_sum = 0, variance_sum = 0;
    for (int qy = y - 3; qy <= y + 3; qy++)
        for (int qx = x - 3; qx <= x + 3; qx++) {
            if (!is_inside(desc, qx, qy))
                continue;
            size_t q = (size_t)qy * (size_t)desc->width + (size_t)qx;
            float weight = surface_weight(&desc->guides[p], &desc->guides[q]);
            float light = mean_of(work->from[q].light);
            weight_sum += weight;
            sum += weight * light;
            square_sum += weight * light * light;
            variance_sum += weight * work->from[q].variance;
        }
    if (work->known)
        return variance_sum / weight_sum;
    float mean = sum / weight_sum;
    return fmaxf(0, square_sum / weight_sum - mean * mean);
}

static void estimate_row(void *context, size_t row) {
    const struct work *work = context;
    const struct atrous_desc *desc = work->desc;
    for (int x = 0; x < desc->width; x++) {
        size_t p = row * (size_t)desc->width + (size_t)x;
        work->to[p] = work->from[p];
        if (is_seen(&desc->guides[p]))
            work->to[p].variance = estimated_variance(work, x, (int)row);
    }
}

void atrous_estimate_variance(const struct atrous_desc *desc, bool known,
                              struct atrous_pixel *pixels) {
    size_t count = (size_t)desc->width * (size_t)desc->height;
    struct atrous_pixel *other = mem_alloc(count, sizeof *other);
    struct work work = {.desc = desc, .from = pixels, .to = other, .known = known};
    parallel_for((size_t)desc->height, desc->threads, estimate_row, &work);
    memcpy(pixels, other, count * sizeof *pixels);
    free(other);
}

/* The share of the nearest pixels that shows the same surface; all of it where they are outside. */
static float company_of(const struct atrous_desc *desc, int x, int y) {
    const struct atrous_guide *guide = &desc->guides[(size_t)y * (size_t)desc->width + (size_t)x];
    float sum = 0;
    for (int j = -2; j <= 2; j++)
        for (int i = -2; i <= 2; i++) {
            float weight = spline_weight(i, j);
            if (is_inside(desc, x + i, y + j)) {
                size_t q = (size_t)(y + j) * (size_t)desc->width + (size_t)(x + i);
                weight *= surface_weight(guide, &desc->guides[q]);
            }
            sum += weight;
        }
    return sum;
}

void atrous_find_lonely(int width, int height, struct atrous_guide *guides) {
    struct atrous_desc desc = {.width = width, .height = height, .guides = guides};
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++)
            guides[(size_t)y * (size_t)width + (size_t)x].is_lonely =
                company_of(&desc, x, y) < company_enough;
}
