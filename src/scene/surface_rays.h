/* CPU rays that meet visible surfaces: they pass backs of single-sided materials and holes of alpha
 * masks. Cost: one BVH of all triangles, then a walk a ray. */
#ifndef SCENE_SURFACE_RAYS_H
#define SCENE_SURFACE_RAYS_H

#include "scene/camera.h"
#include "scene/mesh/bvh_ray.h"
#include "scene/mesh/geometry.h"

struct surface_rays {
    const struct scene *scene; /* must outlive the rays, as must the geometry */
    const struct geometry *geometry;
    const struct bvh *tree; /* of the geometry in its pose at init; NULL: `own` */
    struct bvh own;
    float clearance;
};

/* A point on the visible side of a surface. */
struct surface_hit {
    vec3s position, normal; /* above the surface by the clearance */
    const struct bvh_triangle *triangle;
    const struct material *material;
};

/* tree: of all blocking triangles, must outlive the rays; NULL: builds one, of at least one
 * triangle. */
void surface_rays_init(struct surface_rays *rays, const struct scene *scene,
                       const struct geometry *geometry, const struct bvh *tree);
/* Accepts a zeroed object. */
void surface_rays_free(struct surface_rays *rays);

/* Finds the nearest visible front, or either side of a double-sided material. False: none. */
bool surface_rays_find(const struct surface_rays *rays, vec3s origin, vec3s direction,
                       struct surface_hit *place);

/* Returns a unit direction with density cos / pi about the normal, from two numbers in [0, 1). */
vec3s surface_ray_direction(vec3s normal, const float point[2]);

/* Finds the surface at a point of the camera's picture, x and y in [0, 1] from the top left corner.
 * False: none. */
bool surface_rays_find_seen(const struct surface_rays *rays, const struct camera *camera,
                            const float point[2], float aspect, struct surface_hit *place);

/* True if something blocks the segment between two points above surfaces. */
bool surface_rays_blocked(const struct surface_rays *rays, vec3s from, vec3s to);

/* True if nothing blocks the direction, at any distance. */
bool surface_rays_leave(const struct surface_rays *rays, vec3s from, vec3s direction);

#endif
