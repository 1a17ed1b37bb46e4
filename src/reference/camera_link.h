/* The way back from a point of the scene to the camera's pixel that shows it: what a light tracer needs. */
#ifndef REFERENCE_CAMERA_LINK_H
#define REFERENCE_CAMERA_LINK_H

#include "reference/primary.h"

struct camera_link {
    struct primary_rays primary;
    float across;    /* of a pixel at a depth of 1; of an orthographic camera everywhere, m */
    float least;     /* depth of a point that has a place in the picture, m */
    float near, far; /* depths of surfaces that the camera sees, m; a medium is seen everywhere */
};

struct camera_link camera_link_of(const struct primary_rays *primary, float radius);

/* A point as the camera sees it. */
struct camera_view {
    size_t pixel;
    bool in_range;  /* a surface there is not cut away */
    vec3s eye;      /* where its ray starts */
    vec3s to_eye;   /* unit */
    float distance; /* to there, metres */
    /* Radiance of the pixel, the mean over its area, for each W/sr that leaves towards the eye: 1/m2. */
    float weight;
};

/* False: the point lies outside of the picture. */
bool camera_link_view(const struct camera_link *link, vec3s point, struct camera_view *view);

/* What comes to the camera of the light of that point, but for what is nearer to it than the clearance. */
vec3s camera_link_sees(const struct camera_link *link, const struct camera_view *view, vec3s point);

/* Cuts a piece of a ray, metres along it, to what lies within the picture; false: nothing is left. */
bool camera_link_cut(const struct camera_link *link, vec3s origin, vec3s direction, float piece[2]);

#endif
