#include "scene/geometry.h"

#include "base/error.h"
#include "base/memory.h"

#include <cglm/cglm.h>
#include <string.h>
#include <float.h>
#include <stdlib.h>

/* So many vertices take 3 GiB; a scene of instances grows beyond it only by mistake or malice. */
static const uint64_t max_vertices = 1 << 26, max_indices = 3u << 26;

/* Farther out, squared lengths leave the range of floats. */
static const float max_coordinate = 1e15F;

static const struct primitive *part_primitive(const struct scene *scene,
                                              const struct geometry_part *part) {
    return &scene->meshes[scene->nodes[part->node].mesh].primitives[part->primitive];
}

/* Lists the parts and sums up the sizes. */
static bool list_parts(struct geometry *geometry, const struct scene *scene) {
    uint64_t vertices = 0, indices = 0;
    int capacity = 0;
    for (int node = 0; node < scene->node_count; node++) {
        int mesh = scene->nodes[node].mesh;
        for (int p = 0; mesh >= 0 && p < scene->meshes[mesh].primitive_count; p++) {
            const struct primitive *primitive = &scene->meshes[mesh].primitives[p];
            if (geometry->part_count == capacity) {
                capacity = capacity ? capacity * 2 : 16;
                geometry->parts =
                    mem_resize(geometry->parts, (size_t)capacity, sizeof *geometry->parts);
            }
            geometry->parts[geometry->part_count++] =
                (struct geometry_part){.node = node,
                                       .primitive = p,
                                       .first_vertex = (uint32_t)vertices,
                                       .vertex_count = (uint32_t)primitive->vertex_count};
            vertices += (uint64_t)primitive->vertex_count;
            indices += (uint64_t)primitive->index_count;
            if (vertices > max_vertices || indices > max_indices)
                return error_set("more than %u million vertices or triangles", 1u << 6);
        }
    }
    if (indices == 0)
        return error_set("there is no triangle");
    geometry->vertex_count = (uint32_t)vertices;
    geometry->index_count = (uint32_t)indices;
    return true;
}

/* Makes a batch of each material in use, in the order of drawing. */
static void make_batches(struct geometry *geometry, const struct scene *scene,
                         struct geometry_batch **batch_of) {
    uint32_t *count = mem_alloc((size_t)scene->material_count, sizeof *count);
    for (int i = 0; i < geometry->part_count; i++) {
        const struct primitive *primitive = part_primitive(scene, &geometry->parts[i]);
        count[primitive->material] += (uint32_t)primitive->index_count;
    }
    geometry->batches = mem_alloc((size_t)scene->material_count, sizeof *geometry->batches);
    uint32_t first = 0;
    for (int masked = 0; masked < 2; masked++) {
        for (int m = 0; m < scene->material_count; m++) {
            if (scene->materials[m].alpha_mask != masked || count[m] == 0)
                continue;
            batch_of[m] = &geometry->batches[geometry->batch_count++];
            *batch_of[m] = (struct geometry_batch){.material = m, .first_index = first};
            first += count[m];
        }
        if (!masked)
            geometry->opaque_index_count = first;
    }
    free(count);
}

/* The cofactors of the world matrix's upper left 3x3, column by column. They are the inverse
 * transpose times the determinant, but exist for flat scales too. */
static void cofactors(const float world[16], double out[3][3]) {
    for (int column = 0; column < 3; column++) {
        const float *a = &world[(column + 1) % 3 * 4], *b = &world[(column + 2) % 3 * 4];
        for (int row = 0; row < 3; row++) {
            int d = (row + 1) % 3, e = (row + 2) % 3;
            out[column][row] = (double)a[d] * b[e] - (double)a[e] * b[d];
        }
    }
}

/* The determinant's sign is negative: left becomes right. */
static bool mirrors(const float world[16], double cofactor[3][3]) {
    return world[0] * cofactor[0][0] + world[1] * cofactor[0][1] + world[2] * cofactor[0][2] < 0;
}

/* Appends the triangles to the batches of their materials. A mirroring node turns triangles inside
 * out: their winding is swapped, so that the front stays the front. */
static void lay_indices(struct geometry *geometry, const struct scene *scene, float (*worlds)[16]) {
    struct geometry_batch **batch_of = mem_alloc((size_t)scene->material_count, sizeof *batch_of);
    make_batches(geometry, scene, batch_of);
    for (int i = 0; i < geometry->part_count; i++) {
        const struct geometry_part *part = &geometry->parts[i];
        const struct primitive *primitive = part_primitive(scene, part);
        struct geometry_batch *batch = batch_of[primitive->material];
        uint32_t *to = geometry->indices + batch->first_index + batch->index_count;
        double cofactor[3][3];
        cofactors(worlds[part->node], cofactor);
        int swap = mirrors(worlds[part->node], cofactor);
        for (int k = 0; k < primitive->index_count; k += 3) {
            to[k] = primitive->indices[k] + part->first_vertex;
            to[k + 1 + swap] = primitive->indices[k + 1] + part->first_vertex;
            to[k + 2 - swap] = primitive->indices[k + 2] + part->first_vertex;
        }
        batch->index_count += (uint32_t)primitive->index_count;
    }
    free(batch_of);
}

/* Normals go by the inverse transpose, whose direction the cofactors have, but for its sign. */
static void place_normal(double cofactor[3][3], double sign, const float normal[3], float out[3]) {
    double n[3], length = 0;
    for (int c = 0; c < 3; c++) {
        n[c] = 0;
        for (int column = 0; column < 3; column++)
            n[c] += sign * cofactor[column][c] * normal[column];
        length += n[c] * n[c];
    }
    length = sqrt(length);
    for (int c = 0; c < 3; c++)
        out[c] = length > 0 ? (float)(n[c] / length) : normal[c];
}

/* False, with an error, when a vertex ends up too far away. */
static bool place_vertices(struct geometry *geometry, const struct primitive *primitive,
                           const struct geometry_part *part, const float world[16]) {
    double cofactor[3][3];
    cofactors(world, cofactor);
    double sign = mirrors(world, cofactor) ? -1 : 1;
    for (uint32_t i = 0; i < part->vertex_count; i++) {
        const float *p = primitive->position[i];
        float *position = geometry->position[part->first_vertex + i];
        for (int c = 0; c < 3; c++) {
            position[c] =
                world[c] * p[0] + world[4 + c] * p[1] + world[8 + c] * p[2] + world[12 + c];
            if (!(fabsf(position[c]) <= max_coordinate))
                return error_set("vertex %u lies %g m from the world's origin", i,
                                 (double)position[c]);
        }
        place_normal(cofactor, sign, primitive->normal[i],
                     geometry->normal[part->first_vertex + i]);
    }
    return true;
}

/* What does not move: texture coordinates and colours, white where there is none. */
static void copy_attributes(struct geometry *geometry, const struct primitive *primitive,
                            const struct geometry_part *part) {
    for (uint32_t i = 0; i < part->vertex_count; i++) {
        static const float white[4] = {1, 1, 1, 1};
        uint32_t to = part->first_vertex + i;
        if (primitive->uv)
            memcpy(geometry->uv[to], primitive->uv[i], sizeof *geometry->uv);
        memcpy(geometry->color[to], primitive->color ? primitive->color[i] : white, sizeof white);
    }
}

static void measure(struct geometry *geometry) {
    float *low = geometry->bounds_min, *high = geometry->bounds_max;
    for (int c = 0; c < 3; c++)
        low[c] = FLT_MAX, high[c] = -FLT_MAX;
    for (uint32_t k = 0; k < geometry->index_count; k++)
        for (int c = 0; c < 3; c++) {
            float x = geometry->position[geometry->indices[k]][c];
            low[c] = fminf(low[c], x);
            high[c] = fmaxf(high[c], x);
        }
    glm_vec3_center(low, high, geometry->center);
    float farthest = 0;
    for (uint32_t k = 0; k < geometry->index_count; k++)
        farthest = fmaxf(farthest, glm_vec3_distance2(geometry->center,
                                                      geometry->position[geometry->indices[k]]));
    geometry->radius = fmaxf(sqrtf(farthest), 1e-6F);
}

static void allocate_arrays(struct geometry *geometry) {
    size_t vertices = geometry->vertex_count;
    geometry->position = mem_alloc(vertices + 1, sizeof *geometry->position);
    geometry->normal = mem_alloc(vertices, sizeof *geometry->normal);
    geometry->uv = mem_alloc(vertices, sizeof *geometry->uv);
    geometry->color = mem_alloc(vertices, sizeof *geometry->color);
    geometry->indices = mem_alloc(geometry->index_count, sizeof *geometry->indices);
}

static bool fill(struct geometry *geometry, const struct scene *scene, float (*worlds)[16]) {
    for (int i = 0; i < geometry->part_count; i++) {
        const struct geometry_part *part = &geometry->parts[i];
        const struct primitive *primitive = part_primitive(scene, part);
        if (!place_vertices(geometry, primitive, part, worlds[part->node])) {
            int mesh = scene->nodes[part->node].mesh;
            return error_prefix("mesh %d '%s'", mesh, scene->meshes[mesh].name);
        }
        copy_attributes(geometry, primitive, part);
    }
    lay_indices(geometry, scene, worlds);
    measure(geometry);
    return true;
}

bool geometry_init(struct geometry *geometry, const struct scene *scene, double time) {
    *geometry = (struct geometry){0};
    float(*worlds)[16] = mem_alloc((size_t)scene->node_count, sizeof *worlds);
    scene_node_worlds(scene, time, worlds);
    bool good = list_parts(geometry, scene);
    if (good) {
        allocate_arrays(geometry);
        good = fill(geometry, scene, worlds);
    }
    free(worlds);
    if (good)
        return true;
    geometry_free(geometry);
    return error_prefix("%s", scene->path);
}

void geometry_free(struct geometry *geometry) {
    free(geometry->position);
    free(geometry->normal);
    free(geometry->uv);
    free(geometry->color);
    free(geometry->indices);
    free(geometry->batches);
    free(geometry->parts);
    *geometry = (struct geometry){0};
}
