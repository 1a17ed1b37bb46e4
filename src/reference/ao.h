/* Traces ambient occlusion: the fraction of cosine-distributed rays about a surface's normal that
 * meet nothing within a distance. Techniques with ambient occlusion approximate it.
 *
 * All surfaces occlude from both sides, except holes of alpha masks. A ray that would leave through
 * the back of its own triangle is occluded, as in the path tracer. */
#ifndef REFERENCE_AO_H
#define REFERENCE_AO_H

#include "reference/film.h"
#include "reference/scene/ray_scene.h"

/* Returns the fraction of open rays, one ray a sampler. distance: metres. */
float ao_trace(const struct ray_scene *rays, const struct hit *hit, float distance,
               const struct sampler *samplers, int count);

/* Sums of a pixel's samples, each a fraction of rays; all zero: none. */
struct ao_sums {
    float open[FILM_STREAMS], samples[FILM_STREAMS];
};

void ao_add(struct ao_sums *sums, int stream, float open);
void ao_merge(struct ao_sums *sums, const struct ao_sums *other);

/* Writes the channels of enum ao_channel: mean over samples on surfaces, and its standard error. */
void ao_develop(const struct ao_sums *sums, float *channels);

/* Returns the standard error, RMS over pixels, over the mean. Pixels count by their coverage. */
double ao_noise(const struct ao_sums *pixels, size_t count, int samples);

#endif
