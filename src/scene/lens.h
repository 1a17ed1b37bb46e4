/* Lenses besides the pinhole: panoramas, fisheyes, and distorted or skewed pinholes.
 *
 * Wide lenses see in unit axes from the eye. An equirectangular picture has longitude along x,
 * latitude along y and forward in the middle. A cube is six squares side by side: pinholes of 90
 * degrees that look right, left, up, down, forward and back. The top of up is back, that of down is
 * forward. Of an equidistant fisheye the angle from forward grows as the distance from the
 * picture's middle; of an equisolid one the sine of half the angle does.
 *
 * fov_y is the angle of a fisheye along the picture's height. Beyond pi from forward rays look
 * back.
 *
 * Distortion is OpenCV's rational model, k1 k2 p1 p2 k3 k4 k5 k6, of the coordinates x right and
 * y down at depth 1. Skew is K[0][1] / K[0][0]. */
#ifndef SCENE_LENS_H
#define SCENE_LENS_H

#include "scene/camera.h"

/* Error: a lens with an orthographic camera, a shift, axes that are not unit or an angle beyond
 * 2 pi; a distortion without a ray for some point of the picture of its intrinsics. */
bool lens_check(const struct camera *camera);

/* Writes the default size of a wide lens's picture, pixels. */
void lens_default_size(const struct camera *camera, int size[2]);

/* Error: a cube's picture is not six times as wide as high. */
bool lens_check_size(const struct camera *camera, int width, int height);

/* Write the unit direction of a wide lens at a place of camera_ray; the place of a direction. */
void lens_ray(const struct camera *camera, float x, float y, float aspect, float direction[3]);
void lens_project(const struct camera *camera, const float direction[3], float aspect,
                  float place[2]);

/* Take coordinates at depth 1 to those of the picture; and back. False: no ray is found. */
void lens_distort(const struct camera *camera, const double plane[2], double out[2]);
bool lens_undistort(const struct camera *camera, const double plane[2], double out[2]);

#endif
