#include "scene/surface_rays.h"

#include "base/memory.h"
#include "scene/mesh/corners.h"

#include <math.h>

enum { SURFACES = 8 }; /* culled backs that a ray passes */

void surface_rays_init(struct surface_rays *rays, const struct scene *scene,
                       const struct geometry *geometry, const struct bvh *tree) {
    *rays = (struct surface_rays){scene, geometry, tree, .clearance = geometry_clearance(geometry)};
    if (tree)
        return;
    uint32_t count = geometry->blocking_index_count / 3;
    struct bvh_triangle *triangles = mem_alloc(count, sizeof *triangles);
    for (uint32_t i = 0; i < count; i++) {
        triangles[i] = (struct bvh_triangle){.number = i};
        triangles[i].corner =
            corners_edges(geometry, &geometry->indices[3 * i], triangles[i].edges);
    }
    bvh_init(&rays->own, triangles, count);
}

void surface_rays_free(struct surface_rays *rays) {
    bvh_free(&rays->own);
    *rays = (struct surface_rays){0};
}

static const struct bvh *tree_of(const struct surface_rays *rays) {
    return rays->tree ? rays->tree : &rays->own;
}

static const struct material *material_of(const struct surface_rays *rays, uint32_t triangle) {
    const struct geometry_batch *batch = rays->geometry->batches;
    while (3 * triangle >= batch->first_index + batch->index_count)
        batch++;
    return &rays->scene->materials[batch->material];
}

bool surface_rays_find(const struct surface_rays *rays, vec3s origin, vec3s direction,
                       struct surface_hit *place) {
    for (int i = 0; i < SURFACES; i++) {
        struct bvh_hit hit = bvh_ray_trace(tree_of(rays), origin, direction);
        if (!hit.triangle)
            return false;
        const struct material *material = material_of(rays, hit.triangle->number);
        vec3s at = glms_vec3_muladds(direction, hit.distance, origin);
        vec3s normal = vec3s_unit_cross(hit.triangle->edges[0], hit.triangle->edges[1]);
        if (hit.front || material->double_sided) {
            place->normal = hit.front ? normal : glms_vec3_negate(normal);
            place->position = glms_vec3_muladds(place->normal, rays->clearance, at);
            place->triangle = hit.triangle;
            place->material = material;
            return true;
        }
        origin = glms_vec3_muladds(direction, rays->clearance, at);
    }
    return false;
}

vec3s surface_ray_direction(vec3s normal, const float point[2]) {
    vec3s tangent = vec3s_unit(glms_vec3_ortho(normal));
    vec3s bitangent = glms_vec3_cross(normal, tangent);
    float radius = sqrtf(point[0]), angle = 2 * GLM_PIf * point[1];
    vec3s direction = glms_vec3_scale(normal, sqrtf(1 - point[0]));
    direction = glms_vec3_muladds(tangent, radius * cosf(angle), direction);
    return glms_vec3_muladds(bitangent, radius * sinf(angle), direction);
}

bool surface_rays_find_seen(const struct surface_rays *rays, const struct camera *camera,
                            const float point[2], float aspect, struct surface_hit *place) {
    vec3s origin, direction;
    vec3s axis = {{camera->forward[0], camera->forward[1], camera->forward[2]}};
    camera_ray(camera, point[0], point[1], aspect, origin.raw, direction.raw);
    float along = camera->near / glms_vec3_dot(direction, axis);
    return surface_rays_find(rays, glms_vec3_muladds(direction, along, origin), direction, place);
}

bool surface_rays_blocked(const struct surface_rays *rays, vec3s from, vec3s to) {
    vec3s path = glms_vec3_sub(to, from);
    float distance = glms_vec3_norm(path);
    if (!(distance > 0))
        return false;
    struct bvh_hit hit = bvh_ray_trace(tree_of(rays), from, glms_vec3_scale(path, 1 / distance));
    return hit.distance < distance - rays->clearance;
}

bool surface_rays_leave(const struct surface_rays *rays, vec3s from, vec3s direction) {
    return !bvh_ray_trace(tree_of(rays), from, direction).triangle;
}
