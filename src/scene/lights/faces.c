#include "scene/lights/faces.h"

#include "base/memory.h"
#include "scene/lights/flat_shape.h"

#include <cglm/cglm.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct plane {
    vec3 normal; /* unit */
    float at;    /* along the normal, from the origin */
};

/* False if the triangle has no area. */
static bool find_plane(const struct primitive *primitive, const uint32_t triangle[3],
                       struct plane *plane) {
    float *corners[3];
    vec3 edges[2];
    for (int k = 0; k < 3; k++)
        corners[k] = primitive->position[triangle[k]];
    glm_vec3_sub(corners[1], corners[0], edges[0]);
    glm_vec3_sub(corners[2], corners[0], edges[1]);
    glm_vec3_cross(edges[0], edges[1], plane->normal);
    float area = sqrtf(glm_vec3_norm2(plane->normal));
    if (!(area > 0) || !isfinite(area))
        return false;
    glm_vec3_scale(plane->normal, 1 / area, plane->normal);
    plane->at = glm_vec3_dot(plane->normal, corners[0]);
    return true;
}

static float extent_of(const struct primitive *primitive) {
    float extent = 0;
    for (int i = 0; i < primitive->index_count; i++)
        extent = fmaxf(extent, glm_vec3_distance(primitive->position[primitive->indices[i]],
                                                 primitive->position[primitive->indices[0]]));
    return extent;
}

/* Finds the face of each triangle, by plane. Returns their number, FACES_MAX + 1 if there are more.
 * A triangle without area is of the first face. */
static int find_faces(const struct primitive *primitive, int *face_of) {
    struct plane planes[FACES_MAX];
    float nearness = 1e-4F * extent_of(primitive);
    int count = 0;
    for (int i = 0; i + 2 < primitive->index_count; i += 3) {
        struct plane plane;
        if (!find_plane(primitive, &primitive->indices[i], &plane))
            continue;
        int face = 0;
        while (face < count && (glm_vec3_dot(plane.normal, planes[face].normal) < 1 - 1e-5F ||
                                fabsf(plane.at - planes[face].at) > nearness))
            face++;
        if (face == FACES_MAX)
            return FACES_MAX + 1;
        if (face == count)
            planes[count++] = plane;
        face_of[i / 3] = face;
    }
    return count;
}

/* Copies the triangles in the order of their faces. */
static void sort(const struct primitive *primitive, const int *face_of, int count, uint32_t *to,
                 int *ends) {
    int at = 0;
    for (int face = 0; face < count; face++) {
        for (int i = 0; i + 2 < primitive->index_count; i += 3)
            if (face_of[i / 3] == face) {
                memcpy(&to[at], &primitive->indices[i], 3 * sizeof *to);
                at += 3;
            }
        ends[face] = at;
    }
}

static bool are_flat(const struct primitive *primitive, uint32_t *sorted, int count,
                     const int *ends) {
    for (int face = 0; face < count; face++) {
        struct primitive part = *primitive;
        struct flat_shape shape;
        int first = face ? ends[face - 1] : 0;
        part.indices = sorted + first;
        part.index_count = ends[face] - first;
        if (!flat_shape_of(&shape, &part))
            return false;
    }
    return true;
}

int faces_sort(struct primitive *primitive, int ends[FACES_MAX]) {
    size_t indices = (size_t)primitive->index_count;
    int *face_of = mem_alloc(indices / 3 + 1, sizeof *face_of);
    uint32_t *sorted = mem_alloc(indices + 1, sizeof *sorted);
    int count = find_faces(primitive, face_of);
    if (count > 1 && count <= FACES_MAX) {
        sort(primitive, face_of, count, sorted, ends);
        count = are_flat(primitive, sorted, count, ends) ? count : 1;
    } else {
        count = 1;
    }
    if (count > 1)
        memcpy(primitive->indices, sorted, indices * sizeof *sorted);
    else
        ends[0] = primitive->index_count;
    mem_free(face_of, sorted);
    return count;
}
