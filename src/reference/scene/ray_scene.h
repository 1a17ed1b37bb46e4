/* Traces rays against the scene's triangles. Only ray_scene.c and embree.h use Embree.
 *
 * Holes of alpha masks pass every ray; other surfaces block from both sides. Only the camera does
 * not see backs of single-sided triangles. Panes pass light straight: shadow rays multiply by their
 * transmittance, other rays hit a pane at random, and the hit's share corrects for it. */
#ifndef REFERENCE_SCENE_RAY_SCENE_H
#define REFERENCE_SCENE_RAY_SCENE_H

#include "reference/scene/hit.h"

/* Consecutive triangles of the geometry: a range of them, or a part that is an instance of its
 * mesh, with one copy in the mesh's own space for all nodes. */
struct ray_piece {
    uint32_t first;
    bool mirrored; /* the instance's winding differs from the mesh's */
};

struct ray_scene {
    const struct hit_table *table;
    /* Offset of ray origins above surfaces and of ray ends, metres: about 100 times the rounding
     * error of the scene's coordinates. */
    float clearance;
    bool has_panes;
    struct RTCDeviceTy *device;
    struct RTCSceneTy *scene;
    struct ray_piece *pieces; /* by Embree's number */
    int piece_count;
};

/* Builds the acceleration structure on all cores. It refers to the table and to its geometry's
 * arrays. Error: Embree's own. */
bool ray_scene_init(struct ray_scene *rays, const struct hit_table *table);

/* Accepts zeroed and half-built objects. */
void ray_scene_free(struct ray_scene *rays);

/* Finds the nearest surface along a unit direction. False: none, and only hit->share is set.
 * Thread-safe, like all functions below. */
bool ray_scene_hit(const struct ray_scene *rays, vec3s origin, vec3s direction, struct hit *hit);

/* Finds the nearest surface of a camera ray between two distances, metres. Equal rays need
 * different seeds. */
bool ray_scene_camera_hit(const struct ray_scene *rays, vec3s origin, vec3s direction,
                          const float ends[2], uint32_t seed, struct hit *hit);

/* Returns the transmittance along a camera ray between two distances, metres: 0 if blocked. */
vec3s ray_scene_camera_is_open(const struct ray_scene *rays, vec3s origin, vec3s direction,
                               const float ends[2]);

/* Returns the transmittance between two points. */
vec3s ray_scene_passes(const struct ray_scene *rays, vec3s from, vec3s to);

static inline bool ray_scene_visible(const struct ray_scene *rays, vec3s from, vec3s to) {
    return glms_vec3_max(ray_scene_passes(rays, from, to)) > 0;
}

/* Returns the transmittance along a ray up to a distance, in lengths of the direction. */
vec3s ray_scene_is_open(const struct ray_scene *rays, vec3s origin, vec3s direction,
                        float distance);

/* Returns the transmittance of panes between two points, over the probability that ray_scene_hit's
 * ray passes them. */
vec3s ray_scene_share(const struct ray_scene *rays, vec3s from, vec3s to);

/* Computes ray_scene_passes from one point to the points of `to` with asked[i]. */
void ray_scene_passes_4(const struct ray_scene *rays, vec3s from, const vec3s to[4],
                        const bool asked[4], vec3s passes[4]);

/* Return the start and end point of rays above the surface, by a hit or by a geometric normal. */
vec3s ray_scene_departure(const struct ray_scene *rays, const struct hit *hit);
vec3s ray_scene_above(const struct ray_scene *rays, vec3s position, vec3s normal);

#endif
