#include "reference/film.h"

#include "reference/channels.h"

#include <math.h>

/* Takes the place of the albedo where it is zero, so that the light on a black surface is told. */
static const float least_weight = 1e-6f;

static void add(float sum[3], const float value[3]) {
    for (int c = 0; c < 3; c++)
        sum[c] += value[c];
}

void film_pixel_add(struct film_pixel *pixel, int stream, const struct film_sample *sample) {
    vec3s light = glms_vec3_add(sample->direct.diffuse, sample->indirect.diffuse);
    vec3s specular = glms_vec3_add(sample->direct.specular, sample->indirect.specular);
    vec3s weight = glms_vec3_adds(sample->albedo, least_weight);
    pixel->coverage += 1;
    add(pixel->position, sample->position.raw);
    add(pixel->albedo, sample->albedo.raw);
    add(pixel->normal, sample->normal.raw);
    vec3s plain = glms_vec3_add(glms_vec3_mul(sample->albedo, light), sample->emitted);
    add(pixel->beauty, glms_vec3_mul(plain, sample->passes).raw);
    add(pixel->beauty, glms_vec3_mul(specular, sample->passes).raw);
    add(pixel->emitted, sample->emitted.raw);
    add(pixel->direct, glms_vec3_mul(weight, sample->direct.diffuse).raw);
    add(pixel->streams[stream].weight, weight.raw);
    add(pixel->streams[stream].indirect, glms_vec3_mul(weight, sample->indirect.diffuse).raw);
    pixel->streams[stream].direct += glms_vec3_dot(weight, sample->direct.diffuse);
}

void film_pixel_add_background(struct film_pixel *pixel, vec3s radiance, vec3s passes) {
    add(pixel->beauty, glms_vec3_mul(radiance, passes).raw);
    add(pixel->emitted, radiance.raw);
}

void film_pixel_merge(struct film_pixel *pixel, const struct film_pixel *other) {
    pixel->coverage += other->coverage;
    add(pixel->position, other->position);
    add(pixel->albedo, other->albedo);
    add(pixel->normal, other->normal);
    add(pixel->beauty, other->beauty);
    add(pixel->emitted, other->emitted);
    add(pixel->direct, other->direct);
    for (int s = 0; s < FILM_STREAMS; s++) {
        add(pixel->streams[s].weight, other->streams[s].weight);
        add(pixel->streams[s].indirect, other->streams[s].indirect);
        pixel->streams[s].direct += other->streams[s].direct;
    }
}

static double total_weight(const struct film_pixel *pixel, int channel) {
    double sum = 0;
    for (int s = 0; s < FILM_STREAMS; s++)
        sum += pixel->streams[s].weight[channel];
    return sum;
}

static int used_streams(const struct film_pixel *pixel) {
    int count = 0;
    for (int s = 0; s < FILM_STREAMS; s++)
        count += pixel->streams[s].weight[0] > 0;
    return count;
}

struct film_estimate film_pixel_estimate(const struct film_pixel *pixel) {
    struct film_estimate estimate = {0};
    int used = used_streams(pixel);
    for (int c = 0; c < 3 && used > 0; c++) {
        const struct film_stream *streams = pixel->streams;
        double weight = total_weight(pixel, c), sum = 0, square_sum = 0;
        for (int s = 0; s < FILM_STREAMS; s++)
            sum += streams[s].indirect[c];
        double mean = sum / weight;
        /* What a stream has beyond its weight's share: the variance of a ratio, to first order. */
        for (int s = 0; s < FILM_STREAMS; s++)
            square_sum += pow(streams[s].indirect[c] - mean * streams[s].weight[c], 2);
        estimate.mean[c] = mean;
        if (used > 1)
            estimate.variance[c] = square_sum * used / (used - 1) / (weight * weight);
    }
    return estimate;
}

struct film_direct_estimate film_pixel_estimate_direct(const struct film_pixel *pixel) {
    const struct film_stream *streams = pixel->streams;
    double weight = 0, sum = 0, square_sum = 0;
    int used = used_streams(pixel);
    for (int s = 0; s < FILM_STREAMS; s++) {
        sum += (double)streams[s].direct;
        for (int c = 0; c < 3; c++)
            weight += (double)streams[s].weight[c];
    }
    if (used == 0)
        return (struct film_direct_estimate){0};
    for (int s = 0; s < FILM_STREAMS; s++) {
        double own = 0;
        for (int c = 0; c < 3; c++)
            own += (double)streams[s].weight[c];
        square_sum += pow((double)streams[s].direct - sum / weight * own, 2);
    }
    double variance = used > 1 ? square_sum * used / (used - 1) / (weight * weight) : 0;
    return (struct film_direct_estimate){sum / weight, variance};
}

void film_seen_add(struct film_seen *sums, int stream, vec3s albedo, const struct seen *seen) {
    vec3s weight = glms_vec3_adds(albedo, least_weight);
    add(sums->unshadowed, glms_vec3_mul(weight, seen->unshadowed).raw);
    add(sums->visible, seen->visible.raw);
    add(sums->all, seen->all.raw);
    sums->streams[stream].visible += glms_vec3_hadd(seen->visible);
    sums->streams[stream].all += glms_vec3_hadd(seen->all);
}

void film_seen_merge(struct film_seen *sums, const struct film_seen *other) {
    add(sums->unshadowed, other->unshadowed);
    add(sums->visible, other->visible);
    add(sums->all, other->all);
    for (int s = 0; s < FILM_STREAMS; s++) {
        sums->streams[s].visible += other->streams[s].visible;
        sums->streams[s].all += other->streams[s].all;
    }
}

/* Of the share over all colours; as film_pixel_estimate's. */
static double seen_variance(const struct film_seen *sums) {
    double visible = 0, all = 0, square_sum = 0;
    int used = 0;
    for (int s = 0; s < FILM_STREAMS; s++) {
        visible += (double)sums->streams[s].visible;
        all += (double)sums->streams[s].all;
        used += sums->streams[s].all > 0;
    }
    if (used < 2)
        return 0;
    for (int s = 0; s < FILM_STREAMS; s++) {
        const struct film_seen_stream *stream = &sums->streams[s];
        square_sum += pow((double)stream->visible - visible / all * (double)stream->all, 2);
    }
    return square_sum * used / (used - 1) / (all * all);
}

void film_seen_develop(const struct film_seen *sums, const struct film_pixel *pixel,
                       float *channels) {
    for (int c = 0; c < 3; c++) {
        float weight = (float)total_weight(pixel, c), all = sums->all[c];
        channels[CHANNEL_UNSHADOWED + c] = weight > 0 ? sums->unshadowed[c] / weight : 0;
        channels[CHANNEL_VISIBILITY + c] = all > 0 ? sums->visible[c] / all : 0;
    }
    channels[CHANNEL_DIRECT_ERROR] = (float)sqrt(film_pixel_estimate_direct(pixel).variance);
    channels[CHANNEL_VISIBILITY_ERROR] = (float)sqrt(seen_variance(sums));
}

void film_specular_add(struct film_specular *sums, int stream, const struct film_sample *sample) {
    add(sums->direct, sample->direct.specular.raw);
    add(sums->all[stream], sample->direct.specular.raw);
    add(sums->all[stream], sample->indirect.specular.raw);
}

void film_specular_merge(struct film_specular *sums, const struct film_specular *other) {
    add(sums->direct, other->direct);
    for (int s = 0; s < FILM_STREAMS; s++)
        add(sums->all[s], other->all[s]);
}

/* Of a pixel's samples, so many are of a stream. */
static int stream_samples(int stream, int samples) {
    return (samples + FILM_STREAMS - 1 - stream) / FILM_STREAMS;
}

/* Of sums of radiance by streams, over all samples. */
static struct film_estimate estimate_radiance(const float streams[FILM_STREAMS][3], int samples) {
    struct film_estimate estimate = {0};
    int used = samples < FILM_STREAMS ? samples : FILM_STREAMS;
    for (int c = 0; c < 3; c++) {
        double sum = 0, square_sum = 0;
        for (int s = 0; s < used; s++)
            sum += (double)streams[s][c];
        double mean = sum / samples;
        for (int s = 0; s < used; s++)
            square_sum += pow((double)streams[s][c] - mean * stream_samples(s, samples), 2);
        estimate.mean[c] = mean;
        if (used > 1)
            estimate.variance[c] = square_sum * used / (used - 1) / ((double)samples * samples);
    }
    return estimate;
}

struct film_estimate film_specular_estimate(const struct film_specular *sums, int samples) {
    return estimate_radiance(sums->all, samples);
}

void film_airlight_add(struct film_airlight *sums, struct film_pixel *pixel, int stream,
                       vec3s radiance) {
    add(pixel->beauty, radiance.raw);
    add(sums->streams[stream], radiance.raw);
}

void film_airlight_merge(struct film_airlight *sums, const struct film_airlight *other) {
    for (int s = 0; s < FILM_STREAMS; s++)
        add(sums->streams[s], other->streams[s]);
}

struct film_estimate film_airlight_estimate(const struct film_airlight *sums, int samples) {
    return estimate_radiance(sums->streams, samples);
}

void film_airlight_develop(const struct film_airlight *sums, int samples, float *channels) {
    struct film_estimate estimate = film_airlight_estimate(sums, samples);
    for (int c = 0; c < 3; c++) {
        channels[AIRLIGHT_RADIANCE + c] = (float)estimate.mean[c];
        channels[AIRLIGHT_STANDARD_ERROR + c] = (float)sqrt(estimate.variance[c]);
    }
}

void film_specular_develop(const struct film_specular *sums, int samples, float *channels) {
    struct film_estimate estimate = film_specular_estimate(sums, samples);
    for (int c = 0; c < 3; c++) {
        float direct = sums->direct[c] / (float)samples, all = (float)estimate.mean[c];
        channels[SPECULAR_DIRECT + c] = direct;
        channels[SPECULAR_INDIRECT + c] = all - direct;
        channels[SPECULAR_ALL + c] = all;
        channels[SPECULAR_STANDARD_ERROR + c] = (float)sqrt(estimate.variance[c]);
    }
}

void film_pixel_develop(const struct film_pixel *pixel, int samples, float *channels) {
    struct film_estimate estimate = film_pixel_estimate(pixel);
    channels[CHANNEL_ALPHA] = pixel->coverage / (float)samples;
    for (int c = 0; c < 3; c++) {
        float weight = (float)total_weight(pixel, c);
        channels[CHANNEL_BEAUTY + c] = pixel->beauty[c] / (float)samples;
        channels[CHANNEL_EMITTED + c] = pixel->emitted[c] / (float)samples;
        channels[CHANNEL_DIRECT + c] = weight > 0 ? pixel->direct[c] / weight : 0;
        channels[CHANNEL_INDIRECT + c] = (float)estimate.mean[c];
        channels[CHANNEL_ALBEDO + c] = pixel->albedo[c] / (float)samples;
        channels[CHANNEL_NORMAL + c] = pixel->normal[c];
        channels[CHANNEL_STANDARD_ERROR + c] = (float)sqrt(estimate.variance[c]);
    }
    vec3_unit(&channels[CHANNEL_NORMAL]);
}
