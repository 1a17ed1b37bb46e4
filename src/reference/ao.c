#include "reference/ao.h"

#include "reference/channels.h"
#include "reference/warp.h"

#include <math.h>

float ao_trace(const struct ray_scene *rays, const struct hit *hit, float distance,
               const struct sampler *samplers, int count) {
    vec3s from = ray_scene_departure(rays, hit);
    float open = 0;
    for (int i = 0; i < count; i++) {
        struct sampler sampler = samplers[i];
        vec3s direction = warp_to_cosine(sampler_next(&sampler), hit->normal);
        if (glms_vec3_dot(direction, hit->geometric_normal) > 0)
            open += glms_vec3_hadd(ray_scene_is_open(rays, from, direction, distance)) / 3;
    }
    return open / (float)count;
}

void ao_add(struct ao_sums *sums, int stream, float open) {
    sums->open[stream] += open;
    sums->samples[stream] += 1;
}

void ao_merge(struct ao_sums *sums, const struct ao_sums *other) {
    for (int s = 0; s < FILM_STREAMS; s++) {
        sums->open[s] += other->open[s];
        sums->samples[s] += other->samples[s];
    }
}

struct estimate {
    double mean, variance, samples;
};

/* The variance of a ratio, to first order: the streams' samples differ where pixels are partly
 * covered. */
static struct estimate estimate(const struct ao_sums *sums) {
    double open = 0, samples = 0, square_sum = 0;
    int used = 0;
    for (int s = 0; s < FILM_STREAMS; s++) {
        open += (double)sums->open[s];
        samples += (double)sums->samples[s];
        used += sums->samples[s] > 0;
    }
    if (used == 0)
        return (struct estimate){0};
    double mean = open / samples;
    for (int s = 0; s < FILM_STREAMS; s++)
        square_sum += pow((double)sums->open[s] - mean * (double)sums->samples[s], 2);
    double variance = used > 1 ? square_sum * used / (used - 1) / (samples * samples) : 0;
    return (struct estimate){mean, variance, samples};
}

void ao_develop(const struct ao_sums *sums, float *channels) {
    struct estimate pixel = estimate(sums);
    channels[AO_OPEN] = (float)pixel.mean;
    channels[AO_STANDARD_ERROR] = (float)sqrt(pixel.variance);
}

double ao_noise(const struct ao_sums *pixels, size_t count, int samples) {
    double mean_sum = 0, variance_sum = 0;
    for (size_t i = 0; i < count; i++) {
        struct estimate pixel = estimate(&pixels[i]);
        double coverage = pixel.samples / samples;
        mean_sum += coverage * pixel.mean;
        variance_sum += coverage * coverage * pixel.variance;
    }
    return mean_sum > 0 ? sqrt(variance_sum * (double)count) / mean_sum : 0;
}
