/* Rays against the scene's triangles: the only place that names Embree.
 *
 * Holes of alpha masks let every ray pass; all else blocks from both sides. Only the camera does
 * not see the back of a single-sided triangle. Panes let light pass straight on: shadow rays have all of
 * it, other rays meet a pane by chance, and hits tell by their share what that is worth.
 */
#ifndef REFERENCE_SCENE_RAY_SCENE_H
#define REFERENCE_SCENE_RAY_SCENE_H

#include "reference/scene/hit.h"

struct ray_scene {
    const struct hit_table *table;
    /* A ray leaves a surface from a point this far above it, metres; and stops this far before
     * where it goes. About a hundred times the rounding of the scene's coordinates. */
    float clearance;
    bool has_panes;
    struct RTCDeviceTy *device;
    struct RTCSceneTy *scene;
};

/* Builds the acceleration structure on all cores. Keeps references to the table and to its
 * geometry's arrays. Error: Embree's own. */
bool ray_scene_init(struct ray_scene *rays, const struct hit_table *table);

/* Accepts zeroed and half-built objects. */
void ray_scene_free(struct ray_scene *rays);

/* The nearest surface along a unit direction; false where there is none, and only the hit's share is set.
 * Thread-safe, as are all below. */
bool ray_scene_hit(const struct ray_scene *rays, vec3s origin, vec3s direction, struct hit *hit);

/* The same for a ray of the camera, which sees from one distance to another. Rays that are alike need a seed each. */
bool ray_scene_camera_hit(const struct ray_scene *rays, vec3s origin, vec3s direction,
                          const float ends[2], uint32_t seed, struct hit *hit);

/* What passes along such a ray between two distances: from 0, where something blocks, to 1. */
vec3s ray_scene_camera_is_open(const struct ray_scene *rays, vec3s origin, vec3s direction,
                               const float ends[2]);

/* What passes between two points. */
vec3s ray_scene_passes(const struct ray_scene *rays, vec3s from, vec3s to);

static inline bool ray_scene_visible(const struct ray_scene *rays, vec3s from, vec3s to) {
    return glms_vec3_max(ray_scene_passes(rays, from, to)) > 0;
}

/* What passes along a ray up to a distance, in lengths of the direction. */
vec3s ray_scene_is_open(const struct ray_scene *rays, vec3s origin, vec3s direction,
                        float distance);

/* What panes between two points let pass, over the chance that a ray of the first two goes on past them. */
vec3s ray_scene_share(const struct ray_scene *rays, vec3s from, vec3s to);

/* As ray_scene_passes from one point to four, of those that are asked for. */
void ray_scene_passes_4(const struct ray_scene *rays, vec3s from, const vec3s to[4],
                        const bool asked[4], vec3s passes[4]);

/* The point above the surface where rays begin and end; the same of a geometric normal alone. */
vec3s ray_scene_departure(const struct ray_scene *rays, const struct hit *hit);
vec3s ray_scene_above(const struct ray_scene *rays, vec3s position, vec3s normal);

#endif
