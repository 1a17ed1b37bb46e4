#include "reference/scene/ray_scene.h"

#include "base/error.h"
#include "reference/scene/embree.h"

#include <math.h>

/* What a filter sees besides the hit: the Embree context comes first. */
struct ray_context {
    embree_context embree;
    const struct ray_scene *rays;
};

/* Embree numbers the triangles of each of its geometries from 0; the masked ones follow. */
enum { GEOMETRY_OPAQUE, GEOMETRY_MASKED };

static struct triangle_point point_of(const struct ray_scene *rays, const struct RTCHit *hit) {
    uint32_t first =
        hit->geomID == GEOMETRY_MASKED ? rays->table->geometry->opaque_index_count / 3 : 0;
    return (struct triangle_point){first + hit->primID, hit->u, hit->v};
}

/* The i-th hit of a packet: the members of RTCHit, each an array of as many as there are rays.
 * Embree's own accessors are C++. */
static struct RTCHit hit_of_packet(const struct RTCHitN *packet, unsigned count, unsigned i) {
    const float *numbers = (const float *)packet;
    const unsigned *ids = (const unsigned *)packet;
    return (struct RTCHit){.u = numbers[3 * count + i],
                           .v = numbers[4 * count + i],
                           .primID = ids[5 * count + i],
                           .geomID = ids[6 * count + i]};
}

static void let_pass_holes(const struct RTCFilterFunctionNArguments *arguments) {
    const struct ray_scene *rays = ((const struct ray_context *)arguments->context)->rays;
    for (unsigned i = 0; i < arguments->N; i++) {
        if (arguments->valid[i] == 0)
            continue;
        struct RTCHit hit = hit_of_packet(arguments->hit, arguments->N, i);
        struct triangle_point point = point_of(rays, &hit);
        if (hit_is_hole(rays->table, &point))
            arguments->valid[i] = 0;
    }
}

/* The camera's rays are single ones. */
static void let_pass_hidden(const struct RTCFilterFunctionNArguments *arguments) {
    const struct ray_scene *rays = ((const struct ray_context *)arguments->context)->rays;
    const struct RTCRay *ray = (const struct RTCRay *)arguments->ray;
    struct triangle_point point = point_of(rays, (const struct RTCHit *)arguments->hit);
    vec3s direction = {{ray->dir_x, ray->dir_y, ray->dir_z}};
    if (hit_is_hidden(rays->table, point.triangle, direction))
        arguments->valid[0] = 0;
}

static void attach_triangles(struct ray_scene *rays, unsigned id, uint32_t first_index,
                             uint32_t index_count, RTCFilterFunctionN filter) {
    const struct geometry *geometry = rays->table->geometry;
    RTCGeometry triangles = rtcNewGeometry(rays->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(triangles, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               geometry->position, 0, sizeof *geometry->position,
                               geometry->vertex_count);
    rtcSetSharedGeometryBuffer(triangles, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               geometry->indices, (size_t)first_index * sizeof *geometry->indices,
                               3 * sizeof *geometry->indices, index_count / 3);
    rtcSetGeometryIntersectFilterFunction(triangles, filter);
    rtcSetGeometryOccludedFilterFunction(triangles, filter);
    rtcCommitGeometry(triangles);
    rtcAttachGeometryByID(rays->scene, triangles, id);
    rtcReleaseGeometry(triangles);
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
    rays->scene = rtcNewScene(rays->device);
    /* Watertight edges: a ray through a crack would see the far side's light. Of rays aimed at the
     * edges of a closed sphere 1.5 % escape without this flag, which costs some 10 % of the time. */
    rtcSetSceneFlags(rays->scene, RTC_SCENE_FLAG_ROBUST | EMBREE_QUERY_FILTERS);
    uint32_t opaque = geometry->opaque_index_count, masked = geometry->index_count - opaque;
    if (opaque > 0)
        attach_triangles(rays, GEOMETRY_OPAQUE, 0, opaque, NULL);
    if (masked > 0)
        attach_triangles(rays, GEOMETRY_MASKED, opaque, masked, let_pass_holes);
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

static bool trace(const struct ray_scene *rays, vec3s origin, vec3s direction, const float ends[2],
                  RTCFilterFunctionN filter, struct hit *hit) {
    struct ray_context context = {.rays = rays};
    struct RTCRayHit query = {.ray = make_ray(origin, direction, ends[1]),
                              .hit.geomID = RTC_INVALID_GEOMETRY_ID};
    query.ray.tnear = ends[0];
    embree_intersect(rays->scene, &context.embree, filter, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return false;
    struct triangle_point point = point_of(rays, &query.hit);
    hit_at(rays->table, &point, direction, hit);
    return true;
}

bool ray_scene_hit(const struct ray_scene *rays, vec3s origin, vec3s direction, struct hit *hit) {
    return trace(rays, origin, direction, (float[]){0, INFINITY}, NULL, hit);
}

bool ray_scene_camera_hit(const struct ray_scene *rays, vec3s origin, vec3s direction,
                          const float ends[2], struct hit *hit) {
    return trace(rays, origin, direction, ends, let_pass_hidden, hit);
}

bool ray_scene_camera_is_open(const struct ray_scene *rays, vec3s origin, vec3s direction,
                              const float ends[2]) {
    struct ray_context context = {.rays = rays};
    struct RTCRay ray = make_ray(origin, direction, ends[1]);
    ray.tnear = ends[0];
    embree_occluded(rays->scene, &context.embree, let_pass_hidden, &ray);
    return ray.tfar >= 0;
}

bool ray_scene_is_open(const struct ray_scene *rays, vec3s origin, vec3s direction,
                       float distance) {
    struct ray_context context = {.rays = rays};
    struct RTCRay ray = make_ray(origin, direction, distance);
    embree_occluded(rays->scene, &context.embree, NULL, &ray);
    return ray.tfar >= 0;
}

bool ray_scene_visible(const struct ray_scene *rays, vec3s from, vec3s to) {
    vec3s path = glms_vec3_sub(to, from);
    float distance = glms_vec3_norm(path);
    return distance <= rays->clearance ||
           ray_scene_is_open(rays, from, path, 1 - rays->clearance / distance);
}

static void set_ray(struct RTCRay4 *packet, int i, const struct RTCRay *ray) {
    packet->org_x[i] = ray->org_x, packet->org_y[i] = ray->org_y, packet->org_z[i] = ray->org_z;
    packet->dir_x[i] = ray->dir_x, packet->dir_y[i] = ray->dir_y, packet->dir_z[i] = ray->dir_z;
    packet->tfar[i] = ray->tfar;
    packet->mask[i] = ray->mask;
}

void ray_scene_visible_4(const struct ray_scene *rays, vec3s from, const vec3s to[4],
                         bool visible[4]) {
    struct ray_context context = {.rays = rays};
    struct RTCRay4 packet = {0};
    int traced[4] __attribute__((aligned(16))); /* -1 = yes, as Embree wants it */
    for (int i = 0; i < 4; i++) {
        vec3s direction = glms_vec3_sub(to[i], from);
        float distance = glms_vec3_norm(direction);
        traced[i] = visible[i] && distance > rays->clearance ? -1 : 0;
        struct RTCRay ray = make_ray(from, direction, 1 - rays->clearance / distance);
        set_ray(&packet, i, &ray);
    }
    embree_occluded_4(traced, rays->scene, &context.embree, NULL, &packet);
    for (int i = 0; i < 4; i++)
        visible[i] = visible[i] && (!traced[i] || packet.tfar[i] >= 0);
}

vec3s ray_scene_above(const struct ray_scene *rays, vec3s position, vec3s normal) {
    return glms_vec3_add(position, glms_vec3_scale(normal, rays->clearance));
}

vec3s ray_scene_departure(const struct ray_scene *rays, const struct hit *hit) {
    return ray_scene_above(rays, hit->position, hit->geometric_normal);
}
