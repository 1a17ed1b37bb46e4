/* Traced ambient occlusion: which fraction of rays from a surface, with density cosine over pi about its normal,
 * meets nothing within a distance. It is what techniques with ambient occlusion approximate.
 *
 * All surfaces occlude, from both sides, but for holes of alpha masks. A ray that would leave through the
 * back of its own triangle is occluded, as shading normals are treated by the path tracer.
 */
#ifndef REFERENCE_AO_H
#define REFERENCE_AO_H

#include "reference/film.h"
#include "reference/scene/ray_scene.h"

/* The fraction of rays: one for each sampler. */
float ao_trace(const struct ray_scene *rays, const struct hit *hit, float distance,
               const struct sampler *samplers, int count);

/* What a pixel's samples saw, each a fraction of rays: sums; all zero = none. */
struct ao_sums {
    float open[FILM_STREAMS], samples[FILM_STREAMS];
};

void ao_add(struct ao_sums *sums, int stream, float open);
void ao_merge(struct ao_sums *sums, const struct ao_sums *other);

/* Writes enum ao_channel's two: the mean over samples that show a surface, and its standard error. */
void ao_develop(const struct ao_sums *sums, float *channels);

/* The standard error, RMS over pixels, over the mean. A pixel of so many samples counts by its coverage. */
double ao_noise(const struct ao_sums *pixels, size_t count, int samples);

#endif
