/* The reference: an unbiased path tracer for diffuse and specular surfaces.
 *
 * A path of b bounces is camera -> x0 ... -> xb -> light. Vertices are sampled by the BRDF. The
 * last is also found by light rays' first hits, which all pixels share (light_vertices.h). The
 * power heuristic weights both, light by light [Veach 1997, §9.2.4]. Environments, and on specular
 * surfaces lights with a size, are also found by rays of the BRDF. More than 64 lights, and many
 * emissive triangles, are sampled by trees (scene/lights/light_tree.h), else each light counts at
 * each vertex. There is no clamping and no Russian roulette. Independent streams of samples give
 * the noise. Caustics of point lights on smooth metal stay noisy. A medium attenuates all segments;
 * the layer airlight has single scattering (reference/airlight.h). Without `smooth` glass and
 * mirrors are opaque specular surfaces. Shading normals have no terminator correction. A surface
 * reflects only between directions on one side of its triangle. Cost: pixels x samples x paths x
 * bounces rays, plus shadow rays. */
#ifndef REFERENCE_PATH_TRACER_H
#define REFERENCE_PATH_TRACER_H

#include "base/image.h"
#include "scene/camera.h"
#include "scene/lights/emitter.h"
#include "scene/mesh/geometry.h"
#include "scene/surface_layers.h"

struct path_tracer_progress {
    double done;  /* estimated fraction of the work, in [0, 1] */
    double noise; /* current noise; 0 before the first estimate, which needs two samples */
    int samples;  /* samples of a pixel, of the finished passes */
};

/* Required: the first four members. Zero selects the default of the others. */
struct path_tracer_desc {
    const struct scene *scene; /* source of materials and textures */
    const struct geometry *geometry;
    const struct camera *camera;
    struct emitters emitters; /* at least one light or the environment */
    /* In place of the camera's pixels: a column of `height` sensors, white and no occluders; NULL:
     * none. Width and `every` are then 1. */
    const struct sensor *sensors;
    int width, height; /* default 800 */
    /* Default 1. n: renders one pixel of each n x n (path_tracer_pixel), into a smaller picture. */
    int every;
    int bounces; /* 0: only direct light */
    int samples; /* samples of a pixel; 0: until `noise` is reached, 2^20 at most */
    int paths;   /* paths of indirect light of a sample; default 1 below 16 samples, else 4 */
    /* Target standard error, default 0.01. Indirect layer: RMS over its mean. Direct light of
     * lights with a size, specular light and airlight: over the beauty's mean. Also of ao. */
    double noise;
    uint32_t seed;
    int materials;        /* enum materials */
    struct medium medium; /* all zero: none */
    /* Glass and mirrors (material_smooth_kind) refract and reflect camera rays and block all
     * others. Light through them comes only from light paths (reference/light_tracer.h). They show
     * specular light. */
    bool smooth;
    bool centers;      /* samples pixel centres, like a rasteriser; else the pixel's area */
    bool seen;         /* adds the layers unshadowed and visibility (reference/seen.h) */
    float ao_distance; /* range of the layer ao, metres (reference/ao.h); 0: no layer */
    bool ao_alone;     /* skips direct and indirect light, whose noise then does not count */
    /* Hides the environment from the camera, but not from surfaces, mirrors and glass. */
    bool hides_sky;
    /* Layers of surfaces, "id.node,uv" (scene/surface_layers.h); NULL: none. */
    const char *surface_layers;
    const struct surface_motion *motion; /* for those of motion */
    bool denoise; /* filters the indirect layer (reference/denoise.h), after the noise estimate */
    int threads;  /* 0: all cores; the picture does not depend on it */
    /* Called repeatedly from any thread, one at a time; false cancels. */
    bool (*progress)(void *user, const struct path_tracer_progress *progress);
    /* Called on the calling thread with the current picture after each pass except the last, to
     * show progress. Passes then are more numerous and start with few samples. The tracer owns the
     * image. */
    void (*show)(void *user, const struct image *image, const struct path_tracer_progress *reached);
    void *user;
};

/* Position in the whole picture of pixel x, y of a picture of every n x n: random within its
 * square. */
struct pixel {
    int x, y;
};
struct pixel path_tracer_pixel(int every, int x, int y);

/* Renders into a new image. It has CHANNELS_OF_PATH_TRACER; _SEEN and _AO on request; _SPECULAR if
 * some surface is specular; _AIRLIGHT with a medium. `reached` gets samples and noise, unless NULL.
 * Error: Embree's own, or "cancelled"; the image is then zeroed. */
bool path_tracer_render(const struct path_tracer_desc *desc, struct image *image,
                        struct path_tracer_progress *reached);

#endif
