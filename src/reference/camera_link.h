/* Connects a point of the scene to the camera's pixel that shows it, for the light tracer. */
#ifndef REFERENCE_CAMERA_LINK_H
#define REFERENCE_CAMERA_LINK_H

#include "reference/primary.h"

struct camera_link {
    struct primary_rays primary;
    float across; /* height of a pixel at depth 1, metres; of an orthographic camera at any depth */
    float aspect; /* width over height of a pixel */
    float least;  /* least depth of a point in the picture, metres */
    float near, far; /* depth range of visible surfaces, metres; a medium is visible at any depth */
};

struct camera_link camera_link_of(const struct primary_rays *primary, float radius);

/* A point as seen by the camera. */
struct camera_view {
    size_t pixel;
    bool in_range;  /* a surface there is in the camera's range */
    vec3s eye;      /* origin of the camera's ray */
    vec3s to_eye;   /* unit */
    float distance; /* distance to `eye`, metres */
    /* Radiance of the pixel, the mean over its area, per W/sr that leaves towards the camera:
     * 1/m2. */
    float weight;
};

/* Projects a point. False: it is outside the picture. */
bool camera_link_view(const struct camera_link *link, vec3s point, struct camera_view *view);

/* Returns the transmittance from the point to the camera. Blockers nearer than the clearance do not
 * count. */
vec3s camera_link_sees(const struct camera_link *link, const struct camera_view *view, vec3s point);

/* Clips an interval of a ray, metres along it, to the picture. False: it is empty. */
bool camera_link_cut(const struct camera_link *link, vec3s origin, vec3s direction, float piece[2]);

#endif
