#include "techniques/imperfect-shadow-maps/caster_points.h"

#include "base/memory.h"
#include "shared/splat.h"

#include <math.h>
#include <string.h>

static int count_all(const struct caster_points *points) {
    return points->desc.count * points->desc.sets;
}

static void deal(struct caster_points *points, const struct geometry *geometry) {
    points->dealt = geometry->pose_count;
    surface_points_init(&points->points, &(struct surface_points_desc){.scene = points->desc.scene,
                                                                       .geometry = geometry,
                                                                       .count = count_all(points)});
}

bool caster_points_init(struct caster_points *points, const struct caster_points_desc *desc) {
    *points = (struct caster_points){.desc = *desc};
    size_t count = (size_t)count_all(points);
    points->dealt_by_pose = surface_points_differ_by_pose(desc->geometry);
    points->room = mem_alloc(count, sizeof *points->room);
    deal(points, desc->geometry);
    if (!buffer_init_texels(&points->buffer, GL_RGBA32F, "caster points",
                            count * sizeof *points->room, NULL)) {
        caster_points_free(points);
        return false;
    }
    return true;
}

void caster_points_free(struct caster_points *points) {
    buffer_free(&points->buffer);
    surface_points_free(&points->points);
    free(points->room);
    *points = (struct caster_points){0};
}

void caster_points_place(struct caster_points *points, const struct geometry *geometry) {
    if (points->pose == geometry->pose_count)
        return;
    if ((points->dealt_by_pose && points->pose != 0) || geometry->changed > points->dealt) {
        surface_points_free(&points->points);
        deal(points, geometry);
    }
    points->pose = geometry->pose_count;
    size_t count = (size_t)count_all(points);
    double whole = 0;
    for (size_t i = 0; i < count; i++) {
        struct surface_place place = surface_points_place(&points->points, geometry, (int)i);
        struct caster_point *point = &points->room[i];
        /* Each set has the whole area. */
        float area = place.area * (float)points->desc.sets;
        whole += (double)area;
        *point = (struct caster_point){.radius = sqrtf(area / (float)GLM_PI)};
        memcpy(point->position, place.position.raw, sizeof point->position);
        memcpy(point->normal, place.normal.raw, sizeof point->normal);
    }
    points->radius = (float)sqrt(whole / ((double)count * GLM_PI));
    buffer_write(&points->buffer, 0, count * sizeof *points->room, points->room);
}
