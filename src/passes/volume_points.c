#include "passes/volume_points.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "gl/vertex_array.h"
#include "shared/volume.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* More would take longer to draw than what they add. */
static const double most_points = 1 << 20;

struct volume_point {
    float position[3];
    int16_t normal[4]; /* w: its back reflects, too */
    uint8_t albedo[4]; /* its square root, as in the G-buffer */
};

double volume_points_area(const struct geometry *geometry, const struct box *box) {
    double area = 0;
    for (uint32_t at = 0; at < geometry->blocking_index_count; at += 3) {
        const uint32_t *index = &geometry->indices[at];
        area += corners_area(geometry, index) * boxed_share(box, geometry, index);
    }
    return area;
}

int volume_points_count(double area, float voxel, float per_voxel) {
    double count = ceil((double)per_voxel * area / (double)(voxel * voxel));
    return (int)fmin(fmax(count, 1), most_points);
}

bool volume_points_check(const struct geometry *geometry, double area, int per_triangle) {
    static const double most_published = 1 << 24;
    const uint32_t triangles = geometry_triangle_count(geometry);
    double published = (double)per_triangle * triangles;
    if (published > most_published)
        return error_set("volume.voxel-points %d: %.0f points on %u triangles; at most %.0f with "
                         "volume.published=on",
                         per_triangle, published, triangles, most_published);
    return surface_points_differ_by_pose(geometry) || area > 0 ||
           error_set("volume: the scene's %u triangles have no area, so no points lie on them",
                     triangles);
}

/* What a point keeps wherever it moves. */
static void colour(struct volume_points *points, const struct geometry *geometry) {
    struct surface_colors colors = {.scene = points->desc.scene,
                                    .geometry = geometry,
                                    .materials = points->desc.materials,
                                    .smooth_black = points->desc.smooth_black};
    texture_decode_table(colors.srgb_to_linear);
    for (int i = 0; i < points->points.count; i++) {
        const struct surface_point *point = &points->points.items[i];
        struct volume_point *to = &points->room[i];
        if (point->share <= 0)
            continue;
        const struct material *material = surface_point_material(point, colors.scene, geometry);
        const struct corners corners = surface_point_corners(point, geometry);
        vec4s color = corners_albedo(&corners, &colors, material, NULL);
        for (int c = 0; c < 3; c++)
            to->albedo[c] = (uint8_t)lroundf(255 * sqrtf(color.raw[c]));
        to->normal[3] = material->double_sided ? INT16_MAX : 0;
    }
}

static bool is_cut(const struct box *box, const struct geometry_part *part) {
    return part->index_count > 0 && !box_holds(box, part->bounds_min, part->bounds_max);
}

static void deal(struct volume_points *points, const struct geometry *geometry) {
    const struct box *box = &points->desc.box;
    surface_points_free(&points->points);
    surface_points_init(&points->points,
                        &(struct surface_points_desc){.scene = points->desc.scene,
                                                      .geometry = geometry,
                                                      .count = points->desc.count,
                                                      .by_area = true,
                                                      .box = box,
                                                      .per_triangle = points->desc.per_triangle});
    free(points->room);
    points->room = mem_alloc((size_t)points->points.count, sizeof *points->room);
    colour(points, geometry);
    free(points->cut);
    points->cut = mem_alloc((size_t)geometry->part_count, sizeof *points->cut);
    for (int p = 0; p < geometry->part_count; p++)
        points->cut[p] = is_cut(box, &geometry->parts[p]);
}

static void init_vertices(struct volume_points *points) {
    struct vertex_attribute attribute = {&points->buffer, 3, GL_FLOAT, sizeof(struct volume_point),
                                         0};
    gl.CreateVertexArrays(1, &points->vertices);
    vertex_array_attribute(points->vertices, ATTRIBUTE_POINT_POSITION, &attribute);
    attribute.count = 4;
    attribute.type = GL_SHORT;
    attribute.offset = offsetof(struct volume_point, normal);
    vertex_array_attribute(points->vertices, ATTRIBUTE_POINT_NORMAL, &attribute);
    attribute.type = GL_UNSIGNED_BYTE;
    attribute.offset = offsetof(struct volume_point, albedo);
    vertex_array_attribute(points->vertices, ATTRIBUTE_POINT_ALBEDO, &attribute);
}

bool volume_points_init(struct volume_points *points, const struct volume_points_desc *desc) {
    *points = (struct volume_points){.desc = *desc, .dealt = desc->geometry->pose_count};
    deal(points, desc->geometry);
    size_t count = (size_t)points->points.count;
    if (!buffer_init(&points->buffer, "volume points", count * sizeof *points->room, NULL)) {
        volume_points_free(points);
        return false;
    }
    init_vertices(points);
    return true;
}

void volume_points_free(struct volume_points *points) {
    vertex_array_free(&points->vertices);
    buffer_free(&points->buffer);
    surface_points_free(&points->points);
    mem_free(points->room, points->cut);
    *points = (struct volume_points){0};
}

struct placing {
    struct volume_points *points;
    const struct geometry *geometry;
};

enum { PLACED_TOGETHER = 4096 };

static void place_some(void *context, size_t run) {
    const struct placing *placing = context;
    int first = (int)run * PLACED_TOGETHER, count = placing->points->points.count;
    for (int i = first; i < count && i < first + PLACED_TOGETHER; i++) {
        struct volume_point *to = &placing->points->room[i];
        struct surface_place place =
            surface_points_place(&placing->points->points, placing->geometry, i);
        bool exists = place.area > 0 && glms_vec3_norm2(place.normal) > 0;
        for (int c = 0; c < 3; c++) {
            /* A point that does not exist lies outside of all volumes. */
            to->position[c] = exists ? place.position.raw[c] : INFINITY;
            to->normal[c] = (int16_t)lroundf(INT16_MAX * fmaxf(fminf(place.normal.raw[c], 1), -1));
        }
    }
}

bool volume_points_fit(const struct volume_points *points, const struct geometry *geometry) {
    if (points->dealt == geometry->pose_count)
        return true;
    if (geometry->painted > points->dealt)
        return false;
    for (int p = 0; p < geometry->part_count; p++) {
        const struct geometry_part *part = &geometry->parts[p];
        if (part->moved > points->dealt && (points->cut[p] || is_cut(&points->desc.box, part)))
            return false;
    }
    return !surface_points_differ_by_pose(geometry);
}

void volume_points_place(struct volume_points *points, const struct geometry *geometry) {
    if (points->pose == geometry->pose_count)
        return;
    points->pose = geometry->pose_count;
    size_t count = (size_t)points->points.count;
    parallel_for((count + PLACED_TOGETHER - 1) / PLACED_TOGETHER, 0, place_some,
                 &(struct placing){points, geometry});
    buffer_write(&points->buffer, 0, count * sizeof *points->room, points->room);
}
