/* What an EXR file tells of its making, as attributes that other programs read: software, comments, chromaticities,
 * worldToCamera and worldToNDC have the names and meanings of OpenEXR's standard attributes. Others begin with
 * "manylight:". Nothing depends on the day or the machine, so that the same picture is the same file. */
#ifndef APPS_ABOUT_H
#define APPS_ABOUT_H

#include "base/image.h"
#include "base/settings.h"
#include "scene/camera.h"

struct about {
    const char *scene;  /* its path */
    const char *camera; /* as scene/placing.h has it; NULL = the first */
    const char *technique;
    const struct camera *placed;
    const struct settings *settings; /* those that differ from the defaults are told */
    double time;                     /* of the animation, seconds */
};

void about_add(struct image *image, const struct about *about);

#endif
