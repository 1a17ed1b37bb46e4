#include "reference/ray_scene.h"

#include "base/error.h"

#include <embree3/rtcore.h>
#include <math.h>

/* What a filter sees besides the hit: the Embree context comes first. */
struct ray_context {
    struct RTCIntersectContext embree;
    const struct ray_scene *rays;
};

/* Embree numbers the triangles of each of its geometries from 0; the masked ones follow. */
enum { GEOMETRY_OPAQUE, GEOMETRY_MASKED };

static struct triangle_point point_of(const struct ray_scene *rays, const struct RTCHit *hit) {
    uint32_t first =
        hit->geomID == GEOMETRY_MASKED ? rays->table->geometry->opaque_index_count / 3 : 0;
    return (struct triangle_point){first + hit->primID, hit->u, hit->v};
}

/* Only single rays are traced, so that a filter sees one ray and one hit. */
static void let_pass_holes(const struct RTCFilterFunctionNArguments *arguments) {
    const struct ray_scene *rays = ((const struct ray_context *)arguments->context)->rays;
    struct triangle_point point = point_of(rays, (const struct RTCHit *)arguments->hit);
    if (hit_is_hole(rays->table, &point))
        arguments->valid[0] = 0;
}

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

static float largest_coordinate(const struct geometry *geometry) {
    float largest = geometry->radius;
    for (int c = 0; c < 3; c++) {
        largest = fmaxf(largest, fabsf(geometry->bounds_min[c]));
        largest = fmaxf(largest, fabsf(geometry->bounds_max[c]));
    }
    return largest;
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
        .clearance = 1e-5f * largest_coordinate(geometry),
        .device = rtcNewDevice(NULL),
    };
    if (!rays->device)
        return error_set("cannot start Embree: %s", error_text(rtcGetDeviceError(NULL)));
    rays->scene = rtcNewScene(rays->device);
    /* Watertight edges: a ray through a crack would see the far side's light. */
    rtcSetSceneFlags(rays->scene, RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
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

static struct ray_context make_context(const struct ray_scene *rays, RTCFilterFunctionN filter) {
    struct ray_context context = {.rays = rays};
    rtcInitIntersectContext(&context.embree);
    context.embree.filter = filter;
    return context;
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

static bool trace(const struct ray_scene *rays, vec3s origin, vec3s direction,
                  RTCFilterFunctionN filter, struct hit *hit) {
    struct ray_context context = make_context(rays, filter);
    struct RTCRayHit query = {.ray = make_ray(origin, direction, INFINITY),
                              .hit.geomID = RTC_INVALID_GEOMETRY_ID};
    rtcIntersect1(rays->scene, &context.embree, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return false;
    struct triangle_point point = point_of(rays, &query.hit);
    hit_at(rays->table, &point, direction, hit);
    return true;
}

bool ray_scene_hit(const struct ray_scene *rays, vec3s origin, vec3s direction, struct hit *hit) {
    return trace(rays, origin, direction, NULL, hit);
}

bool ray_scene_camera_hit(const struct ray_scene *rays, vec3s origin, vec3s direction,
                          struct hit *hit) {
    return trace(rays, origin, direction, let_pass_hidden, hit);
}

bool ray_scene_visible(const struct ray_scene *rays, vec3s from, vec3s to) {
    vec3s direction = glms_vec3_sub(to, from);
    float distance = glms_vec3_norm(direction);
    if (distance <= rays->clearance)
        return true;
    struct ray_context context = make_context(rays, NULL);
    struct RTCRay ray = make_ray(from, direction, 1 - rays->clearance / distance);
    rtcOccluded1(rays->scene, &context.embree, &ray);
    return ray.tfar >= 0;
}

vec3s ray_scene_departure(const struct ray_scene *rays, const struct hit *hit) {
    return glms_vec3_add(hit->position, glms_vec3_scale(hit->geometric_normal, rays->clearance));
}
