/* A light tracer: caustics of glass and mirrors on diffuse surfaces and in a medium, which paths from the camera do not
 * find where lights are points.
 *
 * Rays start from the lights, each with its part of the flux, and follow chains of glass and mirrors through the exact
 * geometry (reference/smooth.h). Where a chain of at least one ends on another surface, the light that its diffuse part
 * reflects goes to the pixel that shows the place [Veach 1997]. A medium scatters light along the segments after the
 * first interface. It goes to pixels from points of each segment, which are even in the angle as seen from the camera
 * [Kulla and Fajardo 2012]. The mean is exact; the error falls with the root of the number of rays. Glass and mirrors hide what is behind them, as in [Dong 2011, chapter 8]: a caustic that is seen through glass
 * is left out. There is no medium within glass, and nothing is scattered twice.
 *
 * All lights cast rays, those with a size from all their places, and the sky as suns. Rays go only to a ball around all
 * glass and mirrors.
 */
#ifndef REFERENCE_LIGHT_TRACER_H
#define REFERENCE_LIGHT_TRACER_H

#include "base/image.h"
#include "scene/camera.h"
#include "scene/lights/emitter.h"
#include "scene/mesh/geometry.h"

/* Where the flux of all rays went, the means of RGB, W. */
struct light_balance {
    double emitted;
    double missed;   /* met another surface first */
    double landed;   /* on another surface, after glass or mirrors */
    double absorbed; /* by glass, mirrors and the medium */
    double escaped;  /* left the scene */
    double cut;      /* by SMOOTH_MOST */
};

/* All but the first seven may be 0. */
struct light_tracer_desc {
    const struct scene *scene;
    const struct geometry *geometry;
    const struct camera *camera;
    struct emitters emitters;
    int width, height; /* of the path tracer's image */
    int paths;         /* about so many rays */
    struct medium medium;
    uint32_t seed;
    bool
        straight; /* also the light that met no glass or mirror yet: direct light and airlight; rays go everywhere */
    int threads; /* 0 = all cores; does not change the picture */
    /* Called now and then on the calling thread with the share of the work; false cancels. */
    bool (*progress)(void *user, double done);
    void *user;
};

struct light_tracer_result {
    bool
        has_smooth; /* there is glass or a mirror: else nothing was traced, and the layers are black */
    double noise; /* standard error over the mean of caustic and volume, RMS over pixels */
    struct light_balance balance;
};

/* Adds CHANNELS_OF_CAUSTIC to the image of a path tracer with desc.smooth, CHANNELS_OF_VOLUME where there is a medium,
 * and their light to its beauty. Error: Embree's own, memory, or "cancelled". */
bool light_tracer_render(const struct light_tracer_desc *desc, struct image *image,
                         struct light_tracer_result *result);

#endif
