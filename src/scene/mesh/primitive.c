#include "scene/mesh/primitive.h"

#include "base/error.h"
#include "base/memory.h"

#include <cglm/cglm.h>
#include <float.h>
#include <string.h>
#include <stdlib.h>

bool primitive_check(const struct primitive *primitive) {
    for (int i = 0; i < primitive->vertex_count; i++)
        for (int c = 0; c < 3; c++)
            if (!isfinite(primitive->position[i][c]))
                return error_set("the position of vertex %d is not finite", i);
    for (int i = 0; i < primitive->index_count; i++)
        if (primitive->indices[i] >= (uint32_t)primitive->vertex_count)
            return error_set("index %u is outside its %d vertices", primitive->indices[i],
                             primitive->vertex_count);
    return true;
}

bool primitive_unroll(struct primitive *primitive, enum primitive_mode mode) {
    int count = primitive->index_count;
    if (count < 3 || (mode == PRIMITIVE_TRIANGLES && count % 3 != 0))
        return error_set("%d indices make no whole triangles", count);
    if (mode == PRIMITIVE_TRIANGLES)
        return true;
    uint32_t *from = primitive->indices, *to = mem_alloc((size_t)(count - 2) * 3, sizeof *to);
    for (int i = 0; i < count - 2; i++) {
        /* glTF 2.0, 3.7.2.1: every other triangle of a strip swaps its last two vertices, and a
         * fan's common vertex comes last. */
        int odd = mode == PRIMITIVE_STRIP ? i % 2 : 0;
        to[i * 3] = mode == PRIMITIVE_STRIP ? from[i] : from[i + 1];
        to[i * 3 + 1] = mode == PRIMITIVE_STRIP ? from[i + 1 + odd] : from[i + 2];
        to[i * 3 + 2] = mode == PRIMITIVE_STRIP ? from[i + 2 - odd] : from[0];
    }
    free(from);
    primitive->indices = to;
    primitive->index_count = (count - 2) * 3;
    return true;
}

/* The cross product of two edges: twice the area long. In double precision and scaled to the
 * longest edge, so that tiny and huge triangles keep their direction. */
static void face_vector(float (*position)[3], const uint32_t *corner, double out[3]) {
    double edge[2][3], longest = 0;
    for (int e = 0; e < 2; e++)
        for (int c = 0; c < 3; c++) {
            edge[e][c] = (double)position[corner[e + 1]][c] - (double)position[corner[0]][c];
            longest = fmax(longest, fabs(edge[e][c]));
        }
    for (int c = 0; c < 3; c++) {
        int d = (c + 1) % 3, f = (c + 2) % 3;
        out[c] = longest > 0 ? (edge[0][d] / longest) * (edge[1][f] / longest) -
                                   (edge[0][f] / longest) * (edge[1][d] / longest)
                             : 0;
    }
}

/* The vector at unit length; up where it has none. */
static void unit_or_up(const double v[3], float out[3]) {
    double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    bool good = isfinite(length) && length > 0;
    for (int c = 0; c < 3; c++)
        out[c] = good ? (float)(v[c] / length) : c == 1;
}

/* The array with one element per index instead of one per vertex; frees the old one. */
static void *unindexed(void *array, size_t size, const struct primitive *primitive) {
    if (!array)
        return NULL;
    char *to = mem_alloc((size_t)primitive->index_count, size);
    for (int i = 0; i < primitive->index_count; i++)
        memcpy(to + (size_t)i * size, (char *)array + primitive->indices[i] * size, size);
    free(array);
    return to;
}

void primitive_flatten(struct primitive *primitive, int target_count) {
    primitive->position = unindexed(primitive->position, sizeof *primitive->position, primitive);
    for (int m = 0; m < MAPPINGS_MAX; m++)
        primitive->uv[m] = unindexed(primitive->uv[m], sizeof *primitive->uv[m], primitive);
    primitive->color = unindexed(primitive->color, sizeof *primitive->color, primitive);
    primitive->joints = unindexed(primitive->joints, sizeof *primitive->joints, primitive);
    primitive->weights = unindexed(primitive->weights, sizeof *primitive->weights, primitive);
    for (int i = 0; primitive->targets && i < target_count; i++) {
        struct morph_target *target = &primitive->targets[i];
        target->position = unindexed(target->position, sizeof *target->position, primitive);
        free(target->normal);
        target->normal = NULL;
    }
    free(primitive->normal);
    primitive->flat = true;
    primitive->vertex_count = primitive->index_count;
    primitive->normal = mem_alloc((size_t)primitive->vertex_count, sizeof *primitive->normal);
    for (int i = 0; i < primitive->index_count; i++)
        primitive->indices[i] = (uint32_t)i;
    primitive_flat_normals(primitive->position, primitive->normal,
                           (uint32_t)primitive->vertex_count);
}

void primitive_flat_normals(float (*position)[3], float (*normal)[3], uint32_t vertex_count) {
    for (uint32_t i = 0; i + 2 < vertex_count; i += 3) {
        double face[3];
        face_vector(position, (uint32_t[]){i, i + 1, i + 2}, face);
        for (int corner = 0; corner < 3; corner++)
            unit_or_up(face, normal[i + corner]);
    }
}

bool primitive_repair_weights(struct primitive *primitive) {
    for (int i = 0; i < primitive->vertex_count; i++) {
        float *weights = primitive->weights[i], sum = 0;
        for (int j = 0; j < 4; j++) {
            if (!(weights[j] >= 0) || !isfinite(sum += weights[j]))
                return error_set("a weight of vertex %d is negative or not finite", i);
        }
        for (int j = 0; j < 4; j++)
            weights[j] = sum > 0 ? weights[j] / sum : j == 0;
    }
    return true;
}

void primitive_repair_normals(struct primitive *primitive) {
    double(*sum)[3] = NULL;
    for (int i = 0; i < primitive->vertex_count; i++) {
        float *normal = primitive->normal[i];
        double length = sqrt((double)normal[0] * normal[0] + (double)normal[1] * normal[1] +
                             (double)normal[2] * normal[2]);
        if (isfinite(length) && length > 1e-6) {
            for (int c = 0; c < 3; c++)
                normal[c] = (float)(normal[c] / length);
            continue;
        }
        if (!sum) {
            sum = mem_alloc((size_t)primitive->vertex_count, sizeof *sum);
            for (int k = 0; k < primitive->index_count; k++) {
                double face[3];
                face_vector(primitive->position, &primitive->indices[k - k % 3], face);
                for (int c = 0; c < 3; c++)
                    sum[primitive->indices[k]][c] += face[c];
            }
        }
        unit_or_up(sum[i], normal);
    }
    free(sum);
}

float primitive_diagonal(const struct primitive *primitive) {
    vec3 low, high;
    glm_vec3_broadcast(FLT_MAX, low);
    glm_vec3_broadcast(-FLT_MAX, high);
    for (int k = 0; k < primitive->index_count; k++) {
        float *position = primitive->position[primitive->indices[k]];
        glm_vec3_minv(low, position, low);
        glm_vec3_maxv(high, position, high);
    }
    return glm_vec3_distance(low, high);
}

void primitive_free(struct primitive *primitive, int target_count) {
    for (int i = 0; primitive->targets && i < target_count; i++) {
        mem_free(primitive->targets[i].position, primitive->targets[i].normal);
    }
    mem_free(primitive->targets, primitive->joints, primitive->weights, primitive->position,
             primitive->normal);
    for (int m = 0; m < MAPPINGS_MAX; m++)
        free(primitive->uv[m]);
    mem_free(primitive->color, primitive->indices);
    *primitive = (struct primitive){0};
}
