#include "reference/scene/ray_scene.h"

#include "base/error.h"
#include "base/memory.h"
#include "reference/sampler.h"
#include "reference/scene/embree.h"

#include <cglm/cglm.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A ray passes so many panes at most. */
enum { PANES_MOST = 32 };

/* Part of a triangle's side, and of a distance, that rounding may make. */
static const float EDGE = 1e-6F;

/* What a filter sees besides the hit: the Embree context comes first. */
struct ray_context {
    embree_context embree;
    const struct ray_scene *rays;
    vec3s direction;             /* of a ray that is no packet; Embree turns it for instances */
    vec3s *passes;               /* of shadow rays, by their ids: what panes let pass */
    bool over_chance;            /* over the chance that other rays go on past each */
    uint32_t passed[PANES_MOST]; /* panes, of other rays */
    int passed_count;
    float edge_at[4]; /* by ids: where a ray last passed a pane's edge, which two triangles share */
};

/* Embree numbers the triangles of each piece from 0. */
static struct triangle_point point_of(const struct ray_scene *rays, const struct RTCHit *hit) {
    bool placed = hit->instID[0] != RTC_INVALID_GEOMETRY_ID;
    const struct ray_piece *piece = &rays->pieces[placed ? hit->instID[0] : hit->geomID];
    return piece->mirrored ? (struct triangle_point){piece->first + hit->primID, hit->v, hit->u}
                           : (struct triangle_point){piece->first + hit->primID, hit->u, hit->v};
}

/* The i-th ray of a packet, as the hit below. */
static vec3s direction_of_packet(const struct RTCRayN *packet, unsigned count, unsigned i,
                                 unsigned *id) {
    const float *numbers = (const float *)packet;
    *id = ((const unsigned *)packet)[10 * count + i];
    return (vec3s){{numbers[4 * count + i], numbers[5 * count + i], numbers[6 * count + i]}};
}

static bool has_passed(const struct ray_context *context, uint32_t triangle) {
    bool passed = false;
    for (int i = 0; i < context->passed_count; i++)
        passed |= context->passed[i] == triangle;
    return passed;
}

static bool is_on_edge(const struct triangle_point *point) {
    return fminf(fminf(point->u, point->v), 1 - point->u - point->v) < EDGE;
}

/* Whether the ray goes on past a pane. Shadow rays note what it lets pass, on a shared edge once */
static bool passes_pane(struct ray_context *context, const struct triangle_point *point,
                        vec3s direction, float at, unsigned id) {
    if (!hit_is_pane(context->rays->table, point->triangle))
        return false;
    bool on_edge = is_on_edge(point);
    bool again = on_edge && fabsf(at - context->edge_at[id]) < EDGE * at;
    if (again || !context->passes)
        return again || has_passed(context, point->triangle);
    context->edge_at[id] = on_edge ? at : context->edge_at[id];
    direction = vec3s_unit(direction);
    struct passing passing = hit_passing(context->rays->table, point, direction);
    float most = glms_vec3_max(passing.passes);
    context->passes[id] = glms_vec3_mul(context->passes[id], passing.passes);
    if (context->over_chance && most > 0)
        context->passes[id] = glms_vec3_scale(context->passes[id], 1 / most);
    return most > 0;
}

/* The i-th hit of a packet: the members of RTCHit, each an array of as many as there are rays.
 * Embree's own accessors are C++. */
static struct RTCHit hit_of_packet(const struct RTCHitN *packet, unsigned count, unsigned i) {
    const float *numbers = (const float *)packet;
    const unsigned *ids = (const unsigned *)packet;
    return (struct RTCHit){.u = numbers[3 * count + i],
                           .v = numbers[4 * count + i],
                           .primID = ids[5 * count + i],
                           .geomID = ids[6 * count + i],
                           .instID = {ids[7 * count + i]}};
}

static void let_pass_holes_and_panes(const struct RTCFilterFunctionNArguments *arguments) {
    struct ray_context *context = (struct ray_context *)arguments->context;
    for (unsigned i = 0; i < arguments->N; i++) {
        unsigned id;
        if (arguments->valid[i] == 0)
            continue;
        struct RTCHit hit = hit_of_packet(arguments->hit, arguments->N, i);
        struct triangle_point point = point_of(context->rays, &hit);
        vec3s direction = direction_of_packet(arguments->ray, arguments->N, i, &id);
        float at = ((const float *)arguments->ray)[8 * arguments->N + i];
        if (hit_is_hole(context->rays->table, &point) ||
            passes_pane(context, &point, direction, at, id))
            arguments->valid[i] = 0;
    }
}

/* The camera's rays are single ones. */
static void let_pass_hidden(const struct RTCFilterFunctionNArguments *arguments) {
    const struct ray_context *context = (const struct ray_context *)arguments->context;
    struct triangle_point point = point_of(context->rays, (const struct RTCHit *)arguments->hit);
    if (hit_is_hidden(context->rays->table, point.triangle, context->direction))
        arguments->valid[0] = 0;
}

/* --- building --------------------------------------------------------------------------------- */

static void attach(struct ray_scene *rays, RTCScene scene, RTCGeometry geometry) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, scene == rays->scene ? (unsigned)rays->piece_count : 0);
    rtcReleaseGeometry(geometry);
}

static void add_piece(struct ray_scene *rays, RTCGeometry geometry, uint32_t first, bool mirrored) {
    attach(rays, rays->scene, geometry);
    rays->pieces[rays->piece_count++] = (struct ray_piece){first, mirrored};
}

static RTCGeometry new_triangles(const struct ray_scene *rays, const uint32_t *indices,
                                 uint32_t first_index, uint32_t index_count, bool is_opaque) {
    RTCFilterFunctionN filter = is_opaque ? NULL : let_pass_holes_and_panes;
    RTCGeometry triangles = rtcNewGeometry(rays->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(triangles, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, indices,
                               (size_t)first_index * sizeof *indices, 3 * sizeof *indices,
                               index_count / 3);
    rtcSetGeometryIntersectFilterFunction(triangles, filter);
    rtcSetGeometryOccludedFilterFunction(triangles, filter);
    return triangles;
}

/* Triangles in world space. */
static void add_range(struct ray_scene *rays, uint32_t first, uint32_t end) {
    const struct geometry *geometry = rays->table->geometry;
    uint32_t opaque = geometry->opaque_index_count;
    if (first < opaque && opaque < end) {
        add_range(rays, first, opaque);
        first = opaque;
    }
    if (first >= end)
        return;
    RTCGeometry triangles =
        new_triangles(rays, geometry->indices, first, end - first, first < opaque);
    rtcSetSharedGeometryBuffer(triangles, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               geometry->position, 0, sizeof *geometry->position,
                               geometry->vertex_count);
    add_piece(rays, triangles, first / 3, false);
}

static RTCScene new_scene(const struct ray_scene *rays) {
    RTCScene scene = rtcNewScene(rays->device);
    /* Watertight edges: a ray through a crack would see the far side's light. Of rays aimed at the
     * edges of a closed sphere 1.5 % escape without this flag, which costs some 10 % of
     * the time. */
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST | EMBREE_QUERY_FILTERS);
    return scene;
}

/* In the mesh's own space. */
static RTCScene scene_of_primitive(struct ray_scene *rays, const struct primitive *primitive,
                                   bool is_opaque) {
    size_t size = sizeof *primitive->position, count = (size_t)primitive->vertex_count;
    RTCScene scene = new_scene(rays);
    RTCGeometry triangles =
        new_triangles(rays, primitive->indices, 0, (uint32_t)primitive->index_count, is_opaque);
    void *positions = rtcSetNewGeometryBuffer(triangles, RTC_BUFFER_TYPE_VERTEX, 0,
                                              RTC_FORMAT_FLOAT3, size, count);
    if (positions)
        memcpy(positions, primitive->position, size * count);
    attach(rays, scene, triangles);
    rtcCommitScene(scene);
    return scene;
}

static void add_instance(struct ray_scene *rays, const struct geometry_part *part,
                         RTCScene *scene) {
    const struct geometry *geometry = rays->table->geometry;
    if (!*scene)
        *scene = scene_of_primitive(rays, geometry_primitive(rays->table->scene, part),
                                    part->first_index < geometry->opaque_index_count);
    RTCGeometry instance = rtcNewGeometry(rays->device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(instance, *scene);
    rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR,
                            geometry->pose.worlds[part->node]);
    add_piece(rays, instance, part->first_index / 3, part->mirrored);
}

/* Whether the node's matrix can be inverted. */
static bool is_invertible(const float world[16]) {
    mat4 matrix;
    memcpy(matrix, world, sizeof matrix);
    float sizes = glm_vec3_norm(matrix[0]) * glm_vec3_norm(matrix[1]) * glm_vec3_norm(matrix[2]);
    return fabsf(glm_mat4_det(matrix)) > 1e-4F * sizes;
}

static bool is_instance(const struct geometry *geometry, const struct geometry_part *part) {
    return part->has_twin && geometry->pose.shown[part->node] &&
           !geometry_part_is_pane(geometry, part) &&
           is_invertible(geometry->pose.worlds[part->node]);
}

static int compare_parts(const void *a, const void *b) {
    uint32_t x = (*(const struct geometry_part *const *)a)->first_index;
    uint32_t y = (*(const struct geometry_part *const *)b)->first_index;
    return (x > y) - (x < y);
}

/* Instances, and the ranges of triangles between them. */
static void add_pieces(struct ray_scene *rays) {
    const struct geometry *geometry = rays->table->geometry;
    size_t parts = (size_t)geometry->part_count, count = 0;
    const struct geometry_part **instances = mem_alloc(parts, sizeof *instances);
    RTCScene *scenes = mem_alloc(parts, sizeof *scenes);
    uint32_t first = 0;
    for (size_t i = 0; i < parts; i++)
        if (is_instance(geometry, &geometry->parts[i]))
            instances[count++] = &geometry->parts[i];
    qsort(instances, count, sizeof(struct geometry_part *), compare_parts);
    rays->pieces = mem_alloc(2 * count + 2, sizeof *rays->pieces);
    for (size_t i = 0; i < count; i++) {
        add_range(rays, first, instances[i]->first_index);
        add_instance(rays, instances[i], &scenes[instances[i]->twin]);
        first = instances[i]->first_index + instances[i]->index_count;
    }
    add_range(rays, first, geometry->index_count);
    for (size_t i = 0; i < parts; i++)
        if (scenes[i])
            rtcReleaseScene(scenes[i]);
    free(instances);
    free(scenes);
}

static const char *error_text(enum RTCError code) {
    static const char *const texts[] = {
        [RTC_ERROR_NONE] = "no reason given",
        [RTC_ERROR_UNKNOWN] = "unknown error",
        [RTC_ERROR_INVALID_ARGUMENT] = "invalid argument",
        [RTC_ERROR_INVALID_OPERATION] = "invalid operation",
        [RTC_ERROR_OUT_OF_MEMORY] = "out of memory",
        [RTC_ERROR_UNSUPPORTED_CPU] = "this processor is not supported",
        [RTC_ERROR_CANCELLED] = "cancelled",
    };
    return (size_t)code < sizeof texts / sizeof *texts ? texts[code] : texts[RTC_ERROR_UNKNOWN];
}

bool ray_scene_init(struct ray_scene *rays, const struct hit_table *table) {
    const struct geometry *geometry = table->geometry;
    *rays = (struct ray_scene){
        .table = table,
        .clearance = geometry_clearance(geometry),
        .device = rtcNewDevice(NULL),
    };
    if (!rays->device)
        return error_set("cannot start Embree: %s", error_text(rtcGetDeviceError(NULL)));
    for (int b = 0; b < geometry->batch_count; b++)
        rays->has_panes |= hit_is_pane(table, geometry->batches[b].first_index / 3);
    rays->scene = new_scene(rays);
    add_pieces(rays);
    rtcCommitScene(rays->scene);
    enum RTCError code = rtcGetDeviceError(rays->device);
    if (code == RTC_ERROR_NONE)
        return true;
    ray_scene_free(rays);
    return error_set("Embree cannot build the scene: %s", error_text(code));
}

void ray_scene_free(struct ray_scene *rays) {
    if (rays->scene)
        rtcReleaseScene(rays->scene);
    if (rays->device)
        rtcReleaseDevice(rays->device);
    free(rays->pieces);
    *rays = (struct ray_scene){0};
}

static struct RTCRay make_ray(vec3s origin, vec3s direction, float length) {
    return (struct RTCRay){
        .org_x = origin.x,
        .org_y = origin.y,
        .org_z = origin.z,
        .dir_x = direction.x,
        .dir_y = direction.y,
        .dir_z = direction.z,
        .tfar = length,
        .mask = ~0u,
    };
}

/* Another number for each ray, from 0 to below 1. */
static float chance_of(vec3s origin, vec3s direction, uint32_t seed) {
    uint32_t bits[6];
    memcpy(bits, origin.raw, sizeof origin.raw);
    memcpy(bits + 3, direction.raw, sizeof direction.raw);
    for (int i = 0; i < 6; i++)
        seed = sampler_hash(seed, bits[i]);
    return (float)(seed >> 8) * 0x1p-24F;
}

/* By chance the ray goes on past the pane, as often as that lets light pass. */
static bool goes_on(const struct ray_scene *rays, const struct triangle_point *point,
                    vec3s direction, float *chance, vec3s *share) {
    struct passing passing = hit_passing(rays->table, point, direction);
    float most = glms_vec3_max(passing.passes);
    bool goes = *chance < most;
    *share = goes ? glms_vec3_scale(glms_vec3_mul(*share, passing.passes), 1 / most)
                  : glms_vec3_scale(*share, passing.covers / (1 - most));
    *chance = goes ? *chance / most : *chance;
    return goes;
}

struct way {
    vec3s origin, direction;
    float ends[2];
    uint32_t seed;
};

static bool trace(const struct ray_scene *rays, const struct way *way, RTCFilterFunctionN filter,
                  struct hit *hit) {
    struct ray_context context = {.rays = rays, .direction = way->direction};
    struct RTCRayHit query = {.ray = make_ray(way->origin, way->direction, way->ends[1]),
                              .hit.geomID = RTC_INVALID_GEOMETRY_ID};
    vec3s share = glms_vec3_one();
    float chance = rays->has_panes ? chance_of(way->origin, way->direction, way->seed) : 0;
    query.ray.tnear = way->ends[0];
    bool hits = false;
    for (int more = 1; more && context.passed_count < PANES_MOST;) {
        embree_intersect(rays->scene, &context.embree, filter, &query);
        hits = query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
        struct triangle_point point =
            hits ? point_of(rays, &query.hit) : (struct triangle_point){0};
        more = hits && rays->has_panes && hit_is_pane(rays->table, point.triangle) &&
               goes_on(rays, &point, way->direction, &chance, &share);
        if (more) {
            /* What lies in the pane's plane is not missed. */
            context.passed[context.passed_count++] = point.triangle;
            context.edge_at[0] = is_on_edge(&point) ? query.ray.tfar : 0;
            query.ray.tnear = fmaxf(way->ends[0], query.ray.tfar - rays->clearance / 10);
            query.ray.tfar = way->ends[1];
            query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        } else if (hits) {
            hit_at(rays->table, &point, way->direction, hit);
        }
    }
    bool is_lost = context.passed_count == PANES_MOST;
    hit->share = is_lost ? glms_vec3_zero() : share;
    return hits && !is_lost;
}

bool ray_scene_hit(const struct ray_scene *rays, vec3s origin, vec3s direction, struct hit *hit) {
    return trace(rays, &(struct way){origin, direction, {0, INFINITY}, 0}, NULL, hit);
}

bool ray_scene_camera_hit(const struct ray_scene *rays, vec3s origin, vec3s direction,
                          const float ends[2], uint32_t seed, struct hit *hit) {
    return trace(rays, &(struct way){origin, direction, {ends[0], ends[1]}, seed}, let_pass_hidden,
                 hit);
}

static vec3s open_to(const struct ray_scene *rays, RTCFilterFunctionN filter, struct RTCRay *ray) {
    vec3s passes = glms_vec3_one();
    struct ray_context context = {
        .rays = rays, .direction = {{ray->dir_x, ray->dir_y, ray->dir_z}}, .passes = &passes};
    embree_occluded(rays->scene, &context.embree, filter, ray);
    return ray->tfar >= 0 ? passes : glms_vec3_zero();
}

vec3s ray_scene_camera_is_open(const struct ray_scene *rays, vec3s origin, vec3s direction,
                               const float ends[2]) {
    struct RTCRay ray = make_ray(origin, direction, ends[1]);
    ray.tnear = ends[0];
    return open_to(rays, let_pass_hidden, &ray);
}

vec3s ray_scene_is_open(const struct ray_scene *rays, vec3s origin, vec3s direction,
                        float distance) {
    struct RTCRay ray = make_ray(origin, direction, distance);
    return open_to(rays, NULL, &ray);
}

vec3s ray_scene_passes(const struct ray_scene *rays, vec3s from, vec3s to) {
    vec3s path = glms_vec3_sub(to, from);
    float distance = glms_vec3_norm(path);
    return distance <= rays->clearance
               ? glms_vec3_one()
               : ray_scene_is_open(rays, from, path, 1 - rays->clearance / distance);
}

static void set_ray(struct RTCRay4 *packet, int i, const struct RTCRay *ray) {
    packet->org_x[i] = ray->org_x, packet->org_y[i] = ray->org_y, packet->org_z[i] = ray->org_z;
    packet->dir_x[i] = ray->dir_x, packet->dir_y[i] = ray->dir_y, packet->dir_z[i] = ray->dir_z;
    packet->tfar[i] = ray->tfar;
    packet->mask[i] = ray->mask;
    packet->id[i] = (unsigned)i;
}

vec3s ray_scene_share(const struct ray_scene *rays, vec3s from, vec3s to) {
    struct ray_context context = {.rays = rays, .over_chance = true};
    struct RTCRay ray = make_ray(from, glms_vec3_sub(to, from), 1);
    vec3s share = glms_vec3_one();
    context.passes = &share;
    if (rays->has_panes)
        embree_occluded(rays->scene, &context.embree, NULL, &ray);
    return share;
}

void ray_scene_passes_4(const struct ray_scene *rays, vec3s from, const vec3s to[4],
                        const bool asked[4], vec3s passes[4]) {
    struct ray_context context = {.rays = rays};
    struct RTCRay4 packet = {0};
    int traced[4] __attribute__((aligned(16))); /* -1 = yes, as Embree wants it */
    context.passes = passes;
    for (int i = 0; i < 4; i++) {
        vec3s direction = glms_vec3_sub(to[i], from);
        float distance = glms_vec3_norm(direction);
        traced[i] = asked[i] && distance > rays->clearance ? -1 : 0;
        struct RTCRay ray = make_ray(from, direction, 1 - rays->clearance / distance);
        set_ray(&packet, i, &ray);
        passes[i] = glms_vec3_one();
    }
    embree_occluded_4(traced, rays->scene, &context.embree, NULL, &packet);
    for (int i = 0; i < 4; i++)
        if (!asked[i] || (traced[i] && packet.tfar[i] < 0))
            passes[i] = glms_vec3_zero();
}

vec3s ray_scene_above(const struct ray_scene *rays, vec3s position, vec3s normal) {
    return glms_vec3_add(position, glms_vec3_scale(normal, rays->clearance));
}

vec3s ray_scene_departure(const struct ray_scene *rays, const struct hit *hit) {
    return ray_scene_above(rays, hit->position, hit->geometric_normal);
}
