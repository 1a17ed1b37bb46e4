/* What a camera sees at the points of a picture. */
#ifndef REFERENCE_VIEW_H
#define REFERENCE_VIEW_H

#include "reference/ray_scene.h"
#include "scene/camera.h"

struct view {
    const struct ray_scene *rays;
    const struct camera *camera;
    int width, height; /* pixels */
};

/* The surface at a point in pixels from the top left corner; false where there is none. */
bool view_hit(const struct view *view, float x, float y, struct hit *hit);

/* Along the view axis, metres. */
float view_depth(const struct view *view, const struct hit *hit);

#endif
