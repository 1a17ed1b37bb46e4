#include "scene/room.h"

#include <float.h>
#include <math.h>

#include "base/unit.h"

enum {
    LEVEL = 16,             /* directions around, the first ones */
    STEEP = 8,              /* half way up; and as many down */
    UP = LEVEL + 2 * STEEP, /* straight up, and then down */
    RAY_COUNT = UP + 2,
    LEAST_WALLS = RAY_COUNT * 9 / 10, /* a room may have windows */
};

static void direction_of(int ray, vec3 direction) {
    bool level = ray < LEVEL;
    int around = level ? LEVEL : STEEP;
    float angle = 2 * (float)GLM_PI * (float)ray / (float)around;
    float height = level ? 0 : ray < LEVEL + STEEP ? 1 : -1;
    if (ray >= UP)
        glm_vec3_copy((vec3){0, ray == UP ? 1 : -1, 0}, direction);
    else
        glm_vec3_copy((vec3){sinf(angle), height, -cosf(angle)}, direction);
    vec3_unit(direction);
}

/* The nearest surface along a ray, metres; negative where it turns its back. FLT_MAX: none. */
static float wall_along(const struct geometry *geometry, const float point[3], vec3 direction) {
    float nearest = FLT_MAX, wall = FLT_MAX;
    for (uint32_t i = 0; i + 2 < geometry->index_count; i += 3) {
        const uint32_t *corner = geometry->indices + i;
        float *a = geometry->position[corner[0]], *b = geometry->position[corner[1]],
              *c = geometry->position[corner[2]], distance;
        if (!glm_ray_triangle((float *)point, direction, a, b, c, &distance) || distance >= nearest)
            continue;
        vec3 ab, ac, normal;
        glm_vec3_sub(b, a, ab);
        glm_vec3_sub(c, a, ac);
        glm_vec3_cross(ab, ac, normal);
        nearest = distance;
        wall = glm_vec3_dot(normal, direction) < 0 ? distance : -distance;
    }
    return wall;
}

/* How far the scene's bounds are along a ray from within, metres. */
static float bounds_along(const struct geometry *geometry, const float point[3], vec3 direction) {
    float distance = FLT_MAX;
    for (int c = 0; c < 3; c++) {
        float end = direction[c] > 0 ? geometry->bounds_max[c] : geometry->bounds_min[c];
        if (fabsf(direction[c]) > 1e-6F)
            distance = fminf(distance, (end - point[c]) / direction[c]);
    }
    return fmaxf(distance, 0);
}

/* Whether most of what is seen of the scene from all around faces outwards: of a room without
 * thickness only the backs of its walls are. */
static bool has_outside(const struct geometry *geometry) {
    int fronts = 0, backs = 0;
    for (int ray = 0; ray < RAY_COUNT; ray++) {
        vec3 direction, from;
        direction_of(ray, direction);
        glm_vec3_copy((float *)geometry->center, from);
        glm_vec3_muladds(direction, -2 * geometry->radius, from);
        float wall = wall_along(geometry, from, direction);
        fronts += wall > 0 && wall < FLT_MAX;
        backs += wall < 0;
    }
    return fronts > backs;
}

static void measure(struct room *room, const float point[3], const float walls[RAY_COUNT]) {
    int longest = 0;
    for (int ray = 1; ray < LEVEL / 2; ray++)
        if (walls[ray] + walls[ray + LEVEL / 2] > walls[longest] + walls[longest + LEVEL / 2])
            longest = ray;
    *room = (struct room){{point[0], point[1], point[2]}, walls[UP], walls[UP + 1], walls[longest],
                          walls[longest + LEVEL / 2],     {0}};
    direction_of(longest, room->forward);
}

/* By the share of the volume within the bounds that lies open to the point. Walls that are seen
 * from outside may be those of a hollow body, of whose bounds an eighth is free, as in the court of
 * Sponza: these are told apart by whether one could stand there. */
static bool is_roomy(const struct room *room, float free, const struct geometry *geometry) {
    float headroom = room->up + room->down;
    bool fits_people = headroom > 2 && headroom < 30;
    return free > .3F || (free > .02F && (fits_people || !has_outside(geometry)));
}

bool room_around(struct room *room, const struct geometry *geometry, const float point[3]) {
    float walls[RAY_COUNT], free = 0, all = 0;
    int facing = 0;
    for (int ray = 0; ray < RAY_COUNT; ray++) {
        vec3 direction;
        direction_of(ray, direction);
        float wall = wall_along(geometry, point, direction);
        float bounds = bounds_along(geometry, point, direction);
        facing += wall > 0 && wall < FLT_MAX;
        walls[ray] = fminf(fabsf(wall), bounds); /* through a window one sees to the bounds */
        free += walls[ray] * walls[ray] * walls[ray];
        all += bounds * bounds * bounds;
    }
    measure(room, point, walls);
    return facing >= LEAST_WALLS && is_roomy(room, free / all, geometry);
}

bool room_find(struct room *room, const struct geometry *geometry) {
    /* Of the way from the centre to the bounds. */
    static const float places[][3] = {
        {.4F, .2F, 0}, {-.4F, .2F, 0}, {0, .2F, .4F}, {0, .2F, -.4F}, {0, .5F, 0}};
    if (room_around(room, geometry, geometry->center))
        return true;
    if (has_outside(geometry))
        return false;
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        float point[3];
        for (int c = 0; c < 3; c++)
            point[c] = geometry->center[c] +
                       places[i][c] * (geometry->bounds_max[c] - geometry->center[c]);
        if (room_around(room, geometry, point))
            return true;
    }
    return false;
}
