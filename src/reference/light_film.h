/* Accumulates light rays in the layers caustic and volume of a picture, with their noise.
 *
 * Caustics are averaged with the albedo as weight, like direct light (reference/film.h). The spread
 * of independent batches of rays gives the error. */
#ifndef REFERENCE_LIGHT_FILM_H
#define REFERENCE_LIGHT_FILM_H

#include "base/image.h"
#include "base/unit.h"

/* Light that one ray deposits in a pixel. */
struct light_deposit {
    size_t pixel;
    bool is_volume;
    vec3s light;  /* irradiance over pi; of a volume radiance to the camera: W/(sr m2) */
    vec3s albedo; /* albedo of the surface */
    vec3s passes; /* transmittance to the camera */
};

struct light_film {
    int width, height;
    int batches; /* finished batches */
    struct light_pixel *pixels;
};

/* Error: memory. */
bool light_film_init(struct light_film *film, int width, int height);

/* Accepts a zeroed object. */
void light_film_free(struct light_film *film);

void light_film_add(struct light_film *film, const struct light_deposit *deposit);

/* Ends a batch. Call it after the batch's last deposit. */
void light_film_end_batch(struct light_film *film);

/* Adds CHANNELS_OF_CAUSTIC, and with a medium CHANNELS_OF_VOLUME, to a path tracer's image of equal
 * size. It adds their light to the beauty. Returns the standard error of their sum, RMS over
 * pixels, over its mean. */
double light_film_develop(const struct light_film *film, bool has_medium, struct image *image);

#endif
