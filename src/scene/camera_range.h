/* What a camera leaves out because it lies too near or too far: glTF's znear and zfar.
 *
 * Renderer and path tracer cut camera rays alike; light is not cut. Where nothing that the picture shows
 * lies outside, there is nothing to cut.
 */
#ifndef SCENE_CAMERA_RANGE_H
#define SCENE_CAMERA_RANGE_H

#include "scene/camera.h"
#include "scene/mesh/geometry.h"

/* Along the camera's axis, metres. */
struct camera_range {
    bool cuts; /* something that would be seen lies outside */
    float near, far;
};

/* Holds for a picture of that aspect, width / height. Looks at the triangles of parts that lie partly outside;
 * what hides what does not count. */
struct camera_range camera_range_of(const struct camera *camera, const struct geometry *geometry,
                                    float aspect);

/* Lets cameras of the scene, the first 32, see all whose range holds nothing of it at time 0, and notes it: exporters write
 * constants, whatever the scene's size. Of others it notes how much of their view lies beyond zfar. */
void scene_check_ranges(struct scene *scene, const struct geometry *geometry);

#endif
