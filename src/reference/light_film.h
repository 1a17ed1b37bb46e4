/* Where light rays leave their light: the layers caustic and volume of a picture, with their noise.
 *
 * A caustic is averaged with the albedo as weight, as direct light is (reference/film.h). Rays come in batches that
 * know nothing of each other, whose spread tells the error.
 */
#ifndef REFERENCE_LIGHT_FILM_H
#define REFERENCE_LIGHT_FILM_H

#include "base/image.h"
#include "base/unit.h"

/* What one ray leaves in a pixel. */
struct light_deposit {
    size_t pixel;
    bool is_volume;
    vec3s light;  /* irradiance over pi; of a volume radiance as the eye sees it: W/(sr m2) */
    vec3s albedo; /* of the surface */
    vec3s passes; /* from there to the eye */
};

struct light_film {
    int width, height;
    int batches; /* so far */
    struct light_pixel *pixels;
};

/* Error: memory. */
bool light_film_init(struct light_film *film, int width, int height);

/* Accepts zeroed ones. */
void light_film_free(struct light_film *film);

void light_film_add(struct light_film *film, const struct light_deposit *deposit);

/* After the last deposit of each batch. */
void light_film_end_batch(struct light_film *film);

/* Adds CHANNELS_OF_CAUSTIC, and CHANNELS_OF_VOLUME where there is a medium, to a path tracer's image of that size, and
 * their light to its beauty. Returns the standard error of their sum over pixels, RMS over its mean. */
double light_film_develop(const struct light_film *film, bool has_medium, struct image *image);

#endif
