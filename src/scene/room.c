#include "scene/room.h"

#include <cglm/cglm.h>

#include <float.h>
#include <math.h>

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
    glm_vec3_normalize(direction);
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

bool room_around(struct room *room, const struct geometry *geometry, const float point[3]) {
    float walls[RAY_COUNT];
    int facing = 0, longest = 0;
    for (int ray = 0; ray < RAY_COUNT; ray++) {
        vec3 direction;
        direction_of(ray, direction);
        walls[ray] = wall_along(geometry, point, direction);
        facing += walls[ray] > 0 && walls[ray] < FLT_MAX;
        /* Through a window one sees no farther than the scene goes. */
        walls[ray] = fminf(fabsf(walls[ray]), geometry->radius);
    }
    for (int ray = 1; ray < LEVEL / 2; ray++)
        if (walls[ray] + walls[ray + LEVEL / 2] > walls[longest] + walls[longest + LEVEL / 2])
            longest = ray;
    *room = (struct room){walls[UP], walls[longest], walls[longest + LEVEL / 2], {0}};
    direction_of(longest, room->forward);
    return facing >= LEAST_WALLS;
}
