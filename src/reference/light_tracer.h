/* A light tracer for caustics of glass and mirrors on diffuse surfaces and in a medium, which
 * camera paths do not find with point lights.
 *
 * Rays leave all lights (points of area lights, suns of the sky) towards a ball around glass and
 * mirrors. They follow chains through exact geometry (reference/smooth.h). Where a chain ends on
 * another surface, its diffusely reflected light goes to the pixel that shows the point [Veach
 * 1997]. A medium scatters light along later segments, at equiangular points as seen from the
 * camera [Kulla and Fajardo 2012]. The mean is unbiased. The error falls with the root of the
 * number of rays. As in [Dong 2011 §8], caustics seen through glass are missing; there is no
 * medium in glass and no multiple scattering. Cost: desc.paths rays x their interfaces. */
#ifndef REFERENCE_LIGHT_TRACER_H
#define REFERENCE_LIGHT_TRACER_H

#include "base/image.h"
#include "scene/camera.h"
#include "scene/lights/emitter.h"
#include "scene/mesh/geometry.h"

/* Flux of all rays by outcome, mean of RGB, W. */
struct light_balance {
    double emitted;
    double missed;   /* met another surface first */
    double landed;   /* reached another surface after glass or mirrors */
    double absorbed; /* by glass, mirrors and the medium */
    double escaped;  /* left the scene */
    double cut;      /* lost at SMOOTH_MOST interfaces */
};

/* Required: the first seven members. Zero selects the default of the others. */
struct light_tracer_desc {
    const struct scene *scene;
    const struct geometry *geometry;
    const struct camera *camera;
    struct emitters emitters;
    int width, height; /* size of the path tracer's image */
    int paths;         /* approximate number of rays */
    struct medium medium;
    uint32_t seed;
    /* Also deposits light before the first glass or mirror: direct light and airlight. Rays go
     * everywhere. */
    bool straight;
    int threads; /* 0: all cores; the picture does not depend on it */
    /* Called repeatedly on the calling thread with the completed fraction; false cancels. */
    bool (*progress)(void *user, double done);
    void *user;
};

struct light_tracer_result {
    /* There is glass or a mirror. Else nothing is traced, and the layers are black. */
    bool has_smooth;
    double noise; /* standard error over the mean of caustic and volume, RMS over pixels */
    struct light_balance balance;
};

/* Adds CHANNELS_OF_CAUSTIC, and with a medium CHANNELS_OF_VOLUME, to a path tracer's image made
 * with desc.smooth. It adds their light to the beauty. Error: Embree's own, memory, or
 * "cancelled". */
bool light_tracer_render(const struct light_tracer_desc *desc, struct image *image,
                         struct light_tracer_result *result);

#endif
