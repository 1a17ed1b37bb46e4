/* Primary rays: the surfaces that a camera shows at points of a picture. */
#ifndef REFERENCE_PRIMARY_H
#define REFERENCE_PRIMARY_H

#include "reference/scene/ray_scene.h"
#include "scene/camera_range.h"

struct primary_rays {
    const struct ray_scene *rays;
    const struct camera *camera;
    int width, height; /* pixels */
    struct camera_range range;
    const struct sensor *sensors; /* one for each row, in place of what the camera sees; or NULL */
};

struct primary_rays primary_rays_of(const struct ray_scene *rays, const struct camera *camera,
                                    const struct geometry *geometry, int width, int height);

/* Writes origin and unit direction of the ray through a point, in pixels from the top left
 * corner. */
void primary_ray(const struct primary_rays *primary, float x, float y, vec3s *origin,
                 vec3s *direction);

/* Finds the surface at a point; false: none. seed: as in ray_scene_camera_hit. */
bool primary_hit(const struct primary_rays *primary, float x, float y, uint32_t seed,
                 struct hit *hit);

/* Returns the number of the triangle that each pixel shows at a place, from 1 on, behind all panes;
 * 0: none. place: from the pixel's corner, in pixels. The caller frees the numbers. */
uint32_t *primary_triangles(const struct primary_rays *primary, const float place[2], int threads);

/* Returns the depth along the view axis, metres; of a panorama the distance. */
float primary_depth(const struct primary_rays *primary, vec3s position);

/* Returns the height of a pixel at `depth`, metres. */
float primary_pixel_size(const struct primary_rays *primary, float depth);

#endif
