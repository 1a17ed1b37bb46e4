/* Where samples are gathered into pixels, with an estimate of the noise.
 *
 * Direct and indirect light of the diffuse parts are averaged with the albedo as weight: then
 * beauty = albedo x (direct + indirect) + specular + emitted holds in every pixel, also where a pixel shows
 * several surfaces, and partly covered pixels have no dark seam. Specular light is radiance, and averaged
 * as it is. A medium takes its share from the beauty alone, and adds airlight to it.
 */
#ifndef REFERENCE_FILM_H
#define REFERENCE_FILM_H

#include "base/image.h"
#include "base/unit.h"
#include "reference/seen.h"

/* Samples come in independent streams, whose spread tells the error: points of one low-discrepancy
 * stream repel each other, so theirs does not. More streams make a surer estimate, longer ones a
 * smaller error. */
enum { FILM_STREAMS = 4 };

struct film_sample {
    vec3s position, albedo, normal;
    struct reflected direct, indirect;
    vec3s emitted; /* radiance */
    vec3s passes;  /* the share of all this that comes to the eye */
};

/* Sums over samples; all zero = none. */
struct film_pixel {
    float coverage, position[3], albedo[3], normal[3];
    float beauty[3], direct[3]; /* times the albedo */
    float emitted[3];
    struct film_stream {
        float weight[3], indirect[3]; /* the albedo, the light times it */
        float direct;                 /* the light times it, the sum over RGB */
    } streams[FILM_STREAMS];
};

struct film_estimate {
    double mean[3],
        variance[3]; /* of the indirect light, and of that mean: 0 for a single stream */
};

void film_pixel_add(struct film_pixel *pixel, int stream, const struct film_sample *sample);

/* A sample that sees no surface, and the share of the radiance that comes to the eye. */
void film_pixel_add_background(struct film_pixel *pixel, vec3s radiance, vec3s passes);

/* What a pixel sees of a medium, where there is one: sums of radiance. */
struct film_airlight {
    float streams[FILM_STREAMS][3];
};

/* To the pixel's beauty, too. */
void film_airlight_add(struct film_airlight *sums, struct film_pixel *pixel, int stream,
                       vec3s radiance);
void film_airlight_merge(struct film_airlight *sums, const struct film_airlight *other);
struct film_estimate film_airlight_estimate(const struct film_airlight *sums, int samples);

/* Writes enum airlight_channel's layers. */
void film_airlight_develop(const struct film_airlight *sums, int samples, float *channels);

/* What a pixel sees of the lights, where that is asked for: sums, weighted as struct film_pixel's. */
struct film_seen {
    float unshadowed[3], visible[3], all[3];
    struct film_seen_stream {
        float visible, all; /* the sums over RGB */
    } streams[FILM_STREAMS];
};

void film_seen_add(struct film_seen *sums, int stream, vec3s albedo, const struct seen *seen);
void film_seen_merge(struct film_seen *sums, const struct film_seen *other);

/* Writes the layers from CHANNEL_UNSHADOWED on. */
void film_seen_develop(const struct film_seen *sums, const struct film_pixel *pixel,
                       float *channels);

/* What a pixel sees of specular reflection, where some surface has it: sums. */
struct film_specular {
    float direct[3];
    float all[FILM_STREAMS][3];
};

void film_specular_add(struct film_specular *sums, int stream, const struct film_sample *sample);
void film_specular_merge(struct film_specular *sums, const struct film_specular *other);

/* Of all specular reflection, the mean and its variance: 0 for a single sample. */
struct film_estimate film_specular_estimate(const struct film_specular *sums, int samples);

/* Writes enum specular_channel's layers. */
void film_specular_develop(const struct film_specular *sums, int samples, float *channels);

/* Of the direct light, the mean of RGB, and the variance of that. */
struct film_direct_estimate {
    double mean, variance;
};
struct film_direct_estimate film_pixel_estimate_direct(const struct film_pixel *pixel);

/* Adds the sums of one to another. */
void film_pixel_merge(struct film_pixel *pixel, const struct film_pixel *other);

/* The mean is exact where the pixel's albedo is all one, else consistent: a ratio of two means. */
struct film_estimate film_pixel_estimate(const struct film_pixel *pixel);

/* Writes all layers but the depth; samples counts those that saw nothing too. */
void film_pixel_develop(const struct film_pixel *pixel, int samples, float *channels);

#endif
