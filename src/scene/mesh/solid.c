#include "scene/mesh/solid.h"

#include "base/halton.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "scene/mesh/bvh_ray.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    RAYS = 8,        /* from each back */
    PROBES = 6,      /* from each front that they meet */
    PROBE_BACKS = 4, /* so many of them meet backs within a solid */
    EYE_RAYS = 1024,
    EYE_SURE = 50, /* one in so many of what the eye sees may be a back within */
    RUN = 256,     /* triangles that a thread takes at once */
};
static_assert(PROBES <= RAYS, "probes take the points of rays");

/* Dimensions of the points below. */
enum { PLACE_X, PLACE_Y, WAY_X, WAY_Y, DIMENSIONS };

struct search {
    struct bvh tree;
    const struct solid_mesh *mesh;
    float points[RAYS][DIMENSIONS];
    bool *within;
};

/* --- ways ------------------------------------------------------------------------------------- */

static float fraction(float x) {
    return x - floorf(x);
}

/* In [0, 1), another for each key. */
static float scatter(uint32_t key) {
    key += 0x9e3779b9U;
    key = (key ^ key >> 16) * 0x7feb352dU;
    key = (key ^ key >> 15) * 0x846ca68bU;
    return (float)((key ^ key >> 16) >> 8) * 0x1p-24F;
}

/* Around a unit normal, by the cosine to it. */
static vec3s way(vec3s normal, float x, float y) {
    vec3s side = glms_vec3_ortho(normal), tangent = vec3s_unit(side);
    vec3s bitangent = glms_vec3_cross(normal, tangent);
    float radius = sqrtf(x), angle = 2 * GLM_PIf * y;
    vec3s along = glms_vec3_scale(tangent, radius * cosf(angle));
    along = glms_vec3_muladds(bitangent, radius * sinf(angle), along);
    return glms_vec3_muladds(normal, sqrtf(1 - x), along);
}

static vec3s normal_of(const struct bvh_triangle *triangle) {
    return vec3s_unit(glms_vec3_cross(triangle->edges[0], triangle->edges[1]));
}

/* --- the search ------------------------------------------------------------------------------- */

/* A place just above a front: whether most rays from there meet backs. */
static bool probes_meet_backs(const struct search *search, vec3s place, vec3s normal,
                              uint32_t key) {
    int backs = 0, others = 0;
    for (int i = 0; i < PROBES && backs < PROBE_BACKS && others <= PROBES - PROBE_BACKS; i++) {
        const float *point = search->points[i];
        vec3s direction = way(normal, fraction(point[WAY_X] + scatter(key)),
                              fraction(point[WAY_Y] + scatter(key + 1)));
        struct bvh_hit hit = bvh_ray_trace(&search->tree, place, direction);
        bool back = hit.triangle && !hit.front;
        backs += back;
        others += !back;
    }
    return backs >= PROBE_BACKS;
}

static bool ends_within(const struct search *search, vec3s origin, vec3s direction, uint32_t key) {
    struct bvh_hit hit = bvh_ray_trace(&search->tree, origin, direction);
    if (!hit.triangle || !hit.front)
        return hit.triangle;
    vec3s normal = normal_of(hit.triangle);
    vec3s place = glms_vec3_muladds(direction, hit.distance, origin);
    place = glms_vec3_muladds(normal, search->mesh->clearance, place);
    return probes_meet_backs(search, place, normal, key);
}

static bool back_is_within(const struct search *search, const struct bvh_triangle *triangle) {
    vec3s back = glms_vec3_negate(normal_of(triangle));
    vec3s above = glms_vec3_muladds(back, search->mesh->clearance, triangle->corner);
    bool within = glms_vec3_norm2(back) > 0;
    for (uint32_t i = 0; i < RAYS && within; i++) {
        uint32_t key = (triangle->number * RAYS + i) * 2;
        float shifted[DIMENSIONS];
        for (uint32_t d = 0; d < DIMENSIONS; d++)
            shifted[d] = fraction(search->points[i][d] + scatter(triangle->number * 4 + d));
        float root = sqrtf(shifted[PLACE_X]);
        vec3s origin = glms_vec3_muladds(triangle->edges[0], 1 - root, above);
        origin = glms_vec3_muladds(triangle->edges[1], root * shifted[PLACE_Y], origin);
        within = ends_within(search, origin, way(back, shifted[WAY_X], shifted[WAY_Y]), key);
    }
    return within;
}

static void search_run(void *context, size_t run) {
    const struct search *search = context;
    for (uint32_t i = (uint32_t)run * RUN; i < (run + 1) * RUN && i < search->tree.count; i++) {
        const struct bvh_triangle *triangle = &search->tree.triangles[i];
        search->within[triangle->number] = back_is_within(search, triangle);
    }
}

/* What the eye sees is not within. */
static void ask_eye(const struct search *search, const float eye[3]) {
    vec3s origin = {{eye[0], eye[1], eye[2]}};
    int all = 0, backs = 0;
    for (uint32_t i = 0; i < EYE_RAYS; i++) {
        float z = 1 - 2 * ((float)i + .5F) / EYE_RAYS, radius = sqrtf(1 - z * z);
        float angle = 2 * GLM_PIf * (float)radical_inverse(2, i);
        vec3s direction = {{radius * cosf(angle), radius * sinf(angle), z}};
        struct bvh_hit hit = bvh_ray_trace(&search->tree, origin, direction);
        all += hit.triangle != NULL;
        if (!hit.triangle || hit.front || !search->within[hit.triangle->number])
            continue;
        search->within[hit.triangle->number] = false;
        backs++;
    }
    if (backs * EYE_SURE > all)
        memset(search->within, 0, search->tree.count);
}

static struct bvh_triangle *copy_triangles(const struct solid_mesh *mesh) {
    struct bvh_triangle *triangles = mem_alloc(mesh->triangle_count, sizeof *triangles);
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        vec3s corners[3];
        for (int c = 0; c < 3; c++)
            memcpy(&corners[c], mesh->position[mesh->indices[3 * i + (uint32_t)c]],
                   sizeof corners[c]);
        triangles[i] = (struct bvh_triangle){
            .corner = corners[0],
            .edges = {glms_vec3_sub(corners[1], corners[0]), glms_vec3_sub(corners[2], corners[0])},
            .number = i};
    }
    return triangles;
}

void solid_find(bool *within, const struct solid_mesh *mesh, const float eye[3]) {
    static const uint32_t bases[DIMENSIONS] = {2, 3, 5, 7};
    struct search search = {.mesh = mesh, .within = within};
    memset(within, 0, mesh->triangle_count);
    if (mesh->triangle_count == 0)
        return;
    for (uint32_t i = 0; i < RAYS; i++)
        for (int d = 0; d < DIMENSIONS; d++)
            search.points[i][d] = (float)radical_inverse(bases[d], i);
    bvh_init(&search.tree, copy_triangles(mesh), mesh->triangle_count);
    parallel_for((mesh->triangle_count + RUN - 1) / RUN, 0, search_run, &search);
    ask_eye(&search, eye);
    bvh_free(&search.tree);
}
