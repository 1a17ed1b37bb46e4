/* Renders a many-light picture with exact visibility: each pixel's centre gathers from every
 * virtual point light (VPL) by a ray.
 *
 *     indirect = 1/pi sum_i Phi_i / pi  cos_i cos_x / d^2  V(x, i)        [Dong 2009 §4, §6]
 *
 * It separates a renderer's visibility error from the error of few VPLs, which only the path tracer
 * shows. Cost: pixels x VPLs rays. */
#ifndef REFERENCE_VPL_SUM_H
#define REFERENCE_VPL_SUM_H

#include "base/image.h"
#include "reference/geometry_term.h"
#include "scene/camera.h"
#include "scene/lights/emitter.h"
#include "scene/mesh/geometry.h"
#include "shared/vpl.h"

/* Required: the first five members. Zero selects the default of the others. */
struct vpl_sum_desc {
    const struct scene *scene; /* source of materials and textures */
    const struct geometry *geometry;
    const struct camera *camera;
    const struct vpl *vpls;
    int vpl_count;
    struct emitters emitters; /* for the direct layer; may be empty */
    int width, height;        /* default 800 */
    struct geometry_term term;
    bool unshadowed; /* V = 1 */
    /* Rays end this far above a VPL's surface, metres: a bound on the error of its position.
     * Default: a thousandth of the scene's radius. */
    float vpl_clearance;
    int materials; /* enum materials; specular reflection is ignored */
    int threads;   /* 0: all cores */
    /* Called from any thread, one at a time, with `done` in [0, 1]; false cancels. */
    bool (*progress)(void *user, double done);
    void *user;
};

/* Renders into a new image with CHANNELS_COMMON. Error: Embree's own, or "cancelled"; the image is
 * then zeroed. */
bool vpl_sum_render(const struct vpl_sum_desc *desc, struct image *image);

#endif
