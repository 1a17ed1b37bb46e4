/* The range of distances that a camera shows: glTF's znear and zfar.
 *
 * Renderer and path tracer clip camera rays alike; light is not clipped. A range that cuts nothing
 * visible is ignored. */
#ifndef SCENE_CAMERA_RANGE_H
#define SCENE_CAMERA_RANGE_H

#include "scene/camera.h"
#include "scene/mesh/geometry.h"

/* Along the camera's axis, metres. */
struct camera_range {
    bool cuts; /* something visible is outside the range */
    float near, far;
};

/* Computes the range for a picture of the aspect, width / height. It looks at the triangles of
 * parts that are partly outside, without occlusion. */
struct camera_range camera_range_of(const struct camera *camera, const struct geometry *geometry,
                                    float aspect);

/* Removes the range of a camera that contains nothing of the scene at time 0, and logs it, because
 * exporters write constants at any scale. For others it logs visible triangles beyond zfar. It
 * checks the first 32 cameras. */
void scene_check_ranges(struct scene *scene, const struct geometry *geometry);

#endif
