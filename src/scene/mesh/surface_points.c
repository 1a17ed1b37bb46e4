#include "scene/mesh/surface_points.h"

#include "base/halton.h"
#include "base/memory.h"
#include "base/parallel.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- areas ------------------------------------------------------------------------------------ */

/* No triangle has more than this part of all points. */
static const double largest_share = .1;

static const uint32_t *triangle_indices(const struct geometry *geometry,
                                        const struct geometry_part *part, uint32_t triangle) {
    return &geometry->indices[part->first_index + 3 * triangle];
}

const struct material *surface_point_material(const struct surface_point *point,
                                              const struct scene *scene,
                                              const struct geometry *geometry) {
    const struct geometry_part *part = &geometry->parts[point->part];
    const struct mesh *mesh = &scene->meshes[scene->nodes[part->node].mesh];
    return &scene->materials[mesh->primitives[part->primitive].material];
}

/* Running sums over all triangles of what they count for, and where parts begin in them. */
struct running_sums {
    double *ends;
    uint32_t *first; /* of each part; and the count of all */
};

static double total(const struct running_sums *sums, int part_count) {
    uint32_t count = sums->first[part_count];
    return count ? sums->ends[count - 1] : 0;
}

static const struct box endless = {{-INFINITY, -INFINITY, -INFINITY},
                                   {INFINITY, INFINITY, INFINITY}};

static const struct box *box_of(const struct surface_points_desc *desc) {
    return desc->box ? desc->box : &endless;
}

/* All triangles' own, of what is in the box. */
static double *measure_areas(const struct surface_points_desc *desc) {
    const struct geometry *geometry = desc->geometry;
    double *areas = mem_alloc(geometry->index_count / 3, sizeof *areas);
    uint32_t at = 0;
    for (int p = 0; p < geometry->part_count; p++)
        for (uint32_t t = 0; t < geometry->parts[p].index_count / 3; t++) {
            const uint32_t *index = triangle_indices(geometry, &geometry->parts[p], t);
            bool is_pane = geometry_part_is_pane(geometry, &geometry->parts[p]);
            areas[at++] = is_pane ? 0
                                  : corners_area(geometry, index) *
                                        boxed_share(box_of(desc), geometry, index);
        }
    return areas;
}

/* No triangle counts for more than the cap. */
static void sum_up(struct running_sums *sums, const struct geometry *geometry, const double *areas,
                   double cap) {
    double sum = 0;
    uint32_t at = 0;
    for (int p = 0; p < geometry->part_count; p++) {
        sums->first[p] = at;
        for (uint32_t t = 0; t < geometry->parts[p].index_count / 3; t++, at++)
            sums->ends[at] = sum += fmin(areas[at], cap);
    }
    sums->first[geometry->part_count] = at;
}

/* Each round lowers the cap to the largest share of what the one before left. They are enough for a
 * plain of two triangles 10^10 times as large as the rest, and end where there are too few
 * triangles for any to have less than that share. */
static void init_sums(struct running_sums *sums, const struct surface_points_desc *desc) {
    enum { ROUNDS = 16 };
    const struct geometry *geometry = desc->geometry;
    double *areas = measure_areas(desc);
    *sums = (struct running_sums){
        .ends = mem_alloc(geometry->index_count / 3, sizeof *sums->ends),
        .first = mem_alloc((size_t)geometry->part_count + 1, sizeof *sums->first),
    };
    sum_up(sums, geometry, areas, INFINITY);
    for (int round = 0; round < ROUNDS && !desc->by_area; round++)
        sum_up(sums, geometry, areas, largest_share * total(sums, geometry->part_count));
    free(areas);
}

static void free_sums(struct running_sums *sums) {
    mem_free(sums->ends, sums->first);
}

/* The first of count ends that lies beyond the value. */
static uint32_t find(const double *ends, uint32_t count, double value) {
    uint32_t low = 0, high = count - 1;
    while (low < high) {
        uint32_t middle = (low + high) / 2;
        if (ends[middle] > value)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

/* --- dealing ---------------------------------------------------------------------------------- */

struct corners surface_point_corners(const struct surface_point *point,
                                     const struct geometry *geometry) {
    struct corners corners;
    memcpy(corners.index,
           triangle_indices(geometry, &geometry->parts[point->part], point->triangle),
           sizeof corners.index);
    memcpy(corners.weight, point->weight, sizeof corners.weight);
    return corners;
}

static bool is_hole(const struct surface_point *point, const struct surface_points_desc *desc,
                    const float srgb_to_linear[256]) {
    const struct geometry *geometry = desc->geometry;
    const struct material *material = surface_point_material(point, desc->scene, geometry);
    if (!material->alpha_mask)
        return false;
    struct corners corners = surface_point_corners(point, geometry);
    vec4s color = corners_base_color(&corners, desc->scene, geometry, srgb_to_linear, material);
    return material_is_hole(material, color.a);
}

/* The place of a value in the sums. What is left of it within its triangle's span is one of the two
 * numbers of the place within: triangles of many points have even ones. */
static void locate(struct surface_point *point, const struct running_sums *sums,
                   const struct surface_points_desc *desc, double value, double y) {
    const struct geometry *geometry = desc->geometry;
    uint32_t at = find(sums->ends, sums->first[geometry->part_count], value);
    double begin = at ? sums->ends[at - 1] : 0, span = sums->ends[at] - begin;
    double rest = fmin(fmax((value - begin) / span, 0), 1 - 1e-12);
    int p = 0;
    while (sums->first[p + 1] <= at)
        p++;
    *point = (struct surface_point){.part = p, .triangle = at - sums->first[p]};
    const uint32_t *index = triangle_indices(geometry, &geometry->parts[p], point->triangle);
    /* The inverse of how many there are, but for the number of all. */
    point->share = (float)(boxed_share(box_of(desc), geometry, index) / span);
    boxed_spread(point->weight, box_of(desc), geometry, index, rest, y);
}

/* Numbers of the sequence, tried side by side. */
struct trial {
    const struct surface_points_desc *desc;
    struct running_sums sums;
    float srgb_to_linear[256];
    uint32_t first;
    struct surface_point *points;
    bool *good;
};

static void try_point(void *context, size_t i) {
    const struct trial *trial = context;
    uint32_t number = trial->first + (uint32_t)i;
    double all = total(&trial->sums, trial->desc->geometry->part_count);
    struct surface_point *point = &trial->points[i];
    locate(point, &trial->sums, trial->desc, radical_inverse(2, number) * all,
           radical_inverse(3, number));
    trial->good[i] = !is_hole(point, trial->desc, trial->srgb_to_linear);
}

/* From 0 to 1, of a number and a dimension [Jarzynski and Olano 2020]. */
static double random_of(uint32_t number, uint32_t dimension) {
    uint32_t state = (2 * number + dimension) * 747796405U + 2891336453U;
    uint32_t word = ((state >> ((state >> 28) + 4)) ^ state) * 277803737U;
    return ((word >> 22) ^ word) * 0x1p-32;
}

static void deal_to_each(struct surface_points *points, const struct surface_points_desc *desc) {
    const struct geometry *geometry = desc->geometry;
    uint32_t each = (uint32_t)desc->per_triangle, at = 0;
    float srgb_to_linear[256];
    texture_decode_table(srgb_to_linear);
    for (int p = 0; p < geometry->part_count; p++)
        for (uint32_t k = 0; k < geometry->parts[p].index_count / 3 * each; k++, at++) {
            struct surface_point point = {
                .part = p, .triangle = k / each, .share = 1 / (float)each};
            const uint32_t *index = triangle_indices(geometry, &geometry->parts[p], point.triangle);
            point.share *= (float)boxed_share(box_of(desc), geometry, index);
            if (boxed_spread(point.weight, box_of(desc), geometry, index, random_of(at, 0),
                             random_of(at, 1)) &&
                !is_hole(&point, desc, srgb_to_linear) &&
                !geometry_part_is_pane(geometry, &geometry->parts[p]))
                points->items[at] = point;
        }
}

static uint32_t count_triangles(const struct geometry *geometry) {
    uint32_t count = 0;
    for (int p = 0; p < geometry->part_count; p++)
        count += geometry->parts[p].index_count / 3;
    return count;
}

static void deal_by_area(struct surface_points *points, const struct surface_points_desc *desc) {
    enum { TRIES = 8, ROUND = 4096 }; /* tries for each point: after them the rest is nothing */
    struct trial trial = {.desc = desc,
                          .points = mem_alloc(ROUND, sizeof *trial.points),
                          .good = mem_alloc(ROUND, sizeof *trial.good)};
    int count = desc->count;
    texture_decode_table(trial.srgb_to_linear);
    init_sums(&trial.sums, desc);
    double all = total(&trial.sums, desc->geometry->part_count);
    int found = 0, tried = 0;
    while (found < count && tried < TRIES * count && all > 0) {
        int round = TRIES * count - tried < ROUND ? TRIES * count - tried : ROUND;
        trial.first = 1 + desc->first * TRIES + (uint32_t)tried;
        parallel_for((size_t)round, 1, try_point, &trial);
        for (int i = 0; i < round && found < count; i++, tried++)
            if (trial.good[i])
                points->items[found++] = trial.points[i];
    }
    for (int i = 0; i < found; i++)
        points->items[i].share *= (float)(all / tried);
    free_sums(&trial.sums);
    mem_free(trial.points, trial.good);
}

void surface_points_init(struct surface_points *points, const struct surface_points_desc *desc) {
    int each = desc->per_triangle;
    int count = each > 0 ? each * (int)count_triangles(desc->geometry) : desc->count;
    *points = (struct surface_points){count, mem_alloc((size_t)count, sizeof *points->items)};
    if (each > 0)
        deal_to_each(points, desc);
    else
        deal_by_area(points, desc);
}

void surface_points_free(struct surface_points *points) {
    free(points->items);
    *points = (struct surface_points){0};
}

bool surface_points_differ_by_pose(const struct geometry *geometry) {
    for (int p = 0; p < geometry->part_count; p++)
        if (geometry->parts[p].dynamic)
            return true;
    return false;
}

struct surface_place surface_points_place(const struct surface_points *points,
                                          const struct geometry *geometry, int i) {
    const struct surface_point *point = &points->items[i];
    if (point->share <= 0)
        return (struct surface_place){.area = 0};
    struct corners corners = surface_point_corners(point, geometry);
    return (struct surface_place){
        .position = corners_vector(&corners, geometry->position),
        .normal = vec3s_unit(corners_vector(&corners, geometry->normal)),
        .area = point->share * (float)corners_area(geometry, corners.index),
    };
}
