/* Rays against the scene's triangles: the only place that names Embree.
 *
 * Holes of alpha masks let every ray pass; all else blocks from both sides. Only the camera does
 * not see the back of a single-sided triangle.
 */
#ifndef REFERENCE_SCENE_RAY_SCENE_H
#define REFERENCE_SCENE_RAY_SCENE_H

#include "reference/scene/hit.h"

struct ray_scene {
    const struct hit_table *table;
    /* A ray leaves a surface from a point this far above it, metres; and stops this far before
     * where it goes. About a hundred times the rounding of the scene's coordinates. */
    float clearance;
    struct RTCDeviceTy *device;
    struct RTCSceneTy *scene;
};

/* Builds the acceleration structure on all cores. Keeps references to the table and to its
 * geometry's arrays. Error: Embree's own. */
bool ray_scene_init(struct ray_scene *rays, const struct hit_table *table);

/* Accepts zeroed and half-built objects. */
void ray_scene_free(struct ray_scene *rays);

/* The nearest surface along a unit direction; false where there is none. Thread-safe, as are all
 * below. */
bool ray_scene_hit(const struct ray_scene *rays, vec3s origin, vec3s direction, struct hit *hit);

/* The same for a ray of the camera, which sees from one distance to another. */
bool ray_scene_camera_hit(const struct ray_scene *rays, vec3s origin, vec3s direction,
                          const float ends[2], struct hit *hit);

/* Whether such a ray meets nothing between two distances. */
bool ray_scene_camera_is_open(const struct ray_scene *rays, vec3s origin, vec3s direction,
                              const float ends[2]);

/* Whether nothing lies between two points. */
bool ray_scene_visible(const struct ray_scene *rays, vec3s from, vec3s to);

/* Whether a ray meets nothing up to a distance, in lengths of the direction. */
bool ray_scene_is_open(const struct ray_scene *rays, vec3s origin, vec3s direction, float distance);

/* As ray_scene_visible from one point to four, of those that are marked on entry. */
void ray_scene_visible_4(const struct ray_scene *rays, vec3s from, const vec3s to[4],
                         bool visible[4]);

/* The point above the surface where rays begin and end; the same of a geometric normal alone. */
vec3s ray_scene_departure(const struct ray_scene *rays, const struct hit *hit);
vec3s ray_scene_above(const struct ray_scene *rays, vec3s position, vec3s normal);

#endif
