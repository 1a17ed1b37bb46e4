/* Rays on the CPU that meet surfaces as pictures show them: through backs of single-sided materials, and through no
 * hole of an alpha mask. Cost: the tree, half a microsecond a triangle on a core, and some microseconds a ray.
 */
#ifndef SCENE_SURFACE_RAYS_H
#define SCENE_SURFACE_RAYS_H

#include "scene/camera.h"
#include "scene/mesh/bvh_ray.h"
#include "scene/mesh/geometry.h"

struct surface_rays {
    const struct scene *scene; /* must outlive the rays, as must the geometry */
    const struct geometry *geometry;
    struct bvh tree; /* of the geometry in its pose at init */
    float clearance;
};

/* A place on a surface, on the side that is looked at. */
struct surface_hit {
    vec3s position, normal; /* above the surface by the clearance */
    const struct bvh_triangle *triangle;
    const struct material *material;
};

/* The geometry has one triangle at least. */
void surface_rays_init(struct surface_rays *rays, const struct scene *scene,
                       const struct geometry *geometry);
/* Accepts zeroed ones. */
void surface_rays_free(struct surface_rays *rays);

/* The nearest surface that shows the ray its front, or a material with two sides. False: none. */
bool surface_rays_find(const struct surface_rays *rays, vec3s origin, vec3s direction,
                       struct surface_hit *place);

/* A unit direction with density cos / pi about the normal, from two numbers in [0, 1). */
vec3s surface_ray_direction(vec3s normal, const float point[2]);

/* What a camera sees at a point of the picture, x and y in [0, 1] from the top left corner. */
bool surface_rays_find_seen(const struct surface_rays *rays, const struct camera *camera,
                            const float point[2], float aspect, struct surface_hit *place);

/* Whether anything lies between two places above surfaces. */
bool surface_rays_blocked(const struct surface_rays *rays, vec3s from, vec3s to);

/* Whether nothing lies that way, however far. */
bool surface_rays_leave(const struct surface_rays *rays, vec3s from, vec3s direction);

#endif
