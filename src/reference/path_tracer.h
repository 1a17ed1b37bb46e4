/* The reference: a path tracer for diffuse and specular surfaces under spots, points, directional and area lights,
 * and a sky.
 *
 * A path of b bounces runs camera -> x0 -> x1 ... -> xb -> light. All vertices but the last are
 * found by sampling the reflection, of a Lambertian surface the cosine; the last one both so and by the first hits of light rays, weighted
 * by the power heuristic [Veach 1997, §9.2.4]: light that bounces off a small bright patch is hard
 * for the first way, corners are hard for the second. No clamping, no Russian roulette: the result
 * is unbiased, and its noise is estimated from independent streams of samples. The light rays' hits
 * are traced once and shared by all pixels (reference/light_vertices.h). Of several lights each has
 * its own two ways, weighted apart. A light with a size ends each path at another place of it, and
 * its direct light has noise too: the greater of the two counts. To the sky there is a way more, by
 * the cosine at the path's last vertex, weighted with the others; of specular surfaces, to all lights with a
 * size. A light without one that smooth metal throws onto other surfaces, a caustic, is found by light
 * rays' hits alone, and stays noisy.
 *
 * A medium takes its share of light on all segments. What it scatters once from the lights towards the eye is the
 * layer airlight (reference/airlight.h); nothing is scattered twice.
 *
 * Glass and mirrors are specular surfaces as others, opaque, unless `smooth` says otherwise.
 *
 * Vertices carry shading normals without any terminator correction. A surface passes light only
 * between directions on one side of its triangle.
 */
#ifndef REFERENCE_PATH_TRACER_H
#define REFERENCE_PATH_TRACER_H

#include "base/image.h"
#include "scene/camera.h"
#include "scene/lights/emitter.h"
#include "scene/mesh/geometry.h"

struct path_tracer_progress {
    double done;  /* estimated share of the work, in [0, 1] */
    double noise; /* so far; 0 before the first estimate, for which one sample is too few */
    int samples;  /* per pixel, of the finished passes */
};

/* All but the first four may be 0. */
struct path_tracer_desc {
    const struct scene *scene; /* its materials and textures */
    const struct geometry *geometry;
    const struct camera *camera;
    struct emitters emitters; /* one at least, or the sky */
    int width, height;        /* default 800 */
    int every; /* default 1; n: only one pixel of each n x n, path_tracer_pixel, in a picture so much smaller */
    int bounces; /* 0 = direct light only */
    int samples; /* per pixel; 0 = until noise is reached */
    int paths;   /* of indirect light from each sample; default 1 below 16 samples, else 4 */
    double
        noise; /* standard error of the indirect layer, RMS over its mean, of direct light of lights with
                     a size, of specular light and airlight over the beauty's mean, and of ao; default 0.01 */
    uint32_t seed;
    int materials;        /* enum materials */
    struct medium medium; /* all zero: none */
    /* Glass and mirrors (material_smooth_kind) refract and reflect camera rays, and block all others: what they let
     * through comes by light paths alone (reference/light_tracer.h). What they show is specular light. */
    bool smooth;
    bool centers;      /* through pixels' centres, as a rasteriser has them; else all over pixels */
    bool seen;         /* the layers unshadowed and visibility, too: reference/seen.h */
    float ao_distance; /* metres: the layer ao, too (reference/ao.h); 0 = none */
    bool ao_alone;     /* without direct and indirect light: their noise is not waited for */
    bool hides_sky;    /* which is not seen, and shines */
    bool denoise;      /* the indirect layer (reference/denoise.h), after the noise is told */
    int threads;       /* 0 = all cores; does not change the picture */
    /* Called now and then from any of the threads, one at a time; false cancels. */
    bool (*progress)(void *user, const struct path_tracer_progress *progress);
    /* Called on the calling thread with the picture so far, of each pass but the last, which are then
     * more and begin with few samples: for who watches. The image is the tracer's. */
    void (*show)(void *user, const struct image *image, const struct path_tracer_progress *reached);
    void *user;
};

/* Where the pixel x, y of a picture of every n x n lies in the whole one: anywhere in its square, by
 * chance. */
struct pixel {
    int x, y;
};
struct pixel path_tracer_pixel(int every, int x, int y);

/* Renders into a new image with CHANNELS_OF_PATH_TRACER, CHANNELS_OF_SEEN where asked for, CHANNELS_OF_SPECULAR
 * where some surface has it, CHANNELS_OF_AO where asked for, and CHANNELS_OF_AIRLIGHT where there is a medium; reached,
 * unless NULL, tells samples and
 * noise. Error: Embree's own, or "cancelled"; the image is then zeroed. */
bool path_tracer_render(const struct path_tracer_desc *desc, struct image *image,
                        struct path_tracer_progress *reached);

#endif
