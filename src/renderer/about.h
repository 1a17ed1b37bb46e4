/* Attributes of an EXR file that describe its making. software, comments, chromaticities,
 * worldToCamera and worldToNDC follow OpenEXR's standard attributes; others begin with
 * "manylight:". None depends on date or machine, so equal pictures are equal files. */
#ifndef RENDERER_ABOUT_H
#define RENDERER_ABOUT_H

#include "base/image.h"
#include "base/settings.h"
#include "scene/camera.h"

struct about {
    const char *scene;  /* path of the scene */
    const char *camera; /* as in scene/placing.h; NULL: the first */
    const char *technique;
    const struct camera *placed;
    const struct settings *settings; /* only values that differ from the defaults are written */
    double time;                     /* time of the animation, seconds */
};

void about_add(struct image *image, const struct about *about);

#endif
