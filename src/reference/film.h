/* Accumulates samples in pixels and estimates the noise.
 *
 * Direct and indirect light of diffuse parts are averaged with the albedo as weight. So beauty =
 * albedo x (direct + indirect) + specular + emitted holds in every pixel, also with several
 * surfaces, and partly covered pixels have no dark seam. Specular light is averaged as radiance. A
 * medium attenuates only the beauty and adds its airlight. */
#ifndef REFERENCE_FILM_H
#define REFERENCE_FILM_H

#include "base/image.h"
#include "base/unit.h"
#include "reference/seen.h"

/* Independent streams of samples, whose spread gives the error. Points of one low-discrepancy
 * stream repel each other, so their spread does not. More streams make the estimate more certain;
 * longer ones make the error smaller. */
enum { FILM_STREAMS = 4 };

struct film_sample {
    vec3s position, albedo, normal;
    struct reflected direct, indirect;
    vec3s emitted; /* radiance, W/(sr m2) */
    vec3s passes;  /* transmittance to the camera */
};

/* Sums over samples; all zero: none. */
struct film_pixel {
    float coverage, position[3], albedo[3], normal[3];
    float beauty[3], direct[3]; /* with the albedo as factor */
    float emitted[3];
    struct film_stream {
        float weight[3], indirect[3]; /* albedo; light times the albedo */
        float direct;                 /* light times the albedo, sum over RGB */
    } streams[FILM_STREAMS];
};

struct film_estimate {
    /* Mean indirect light, and the variance of the mean: 0 for a single stream. */
    double mean[3], variance[3];
};

void film_pixel_add(struct film_pixel *pixel, int stream, const struct film_sample *sample);

/* Adds a sample without a surface. passes: transmittance to the camera. */
void film_pixel_add_background(struct film_pixel *pixel, vec3s radiance, vec3s passes);

/* Sums of a pixel's airlight, radiance, with a medium. */
struct film_airlight {
    float streams[FILM_STREAMS][3];
};

/* Adds airlight, also to the pixel's beauty. */
void film_airlight_add(struct film_airlight *sums, struct film_pixel *pixel, int stream,
                       vec3s radiance);
void film_airlight_merge(struct film_airlight *sums, const struct film_airlight *other);
struct film_estimate film_airlight_estimate(const struct film_airlight *sums, int samples);

/* Writes the layers of enum airlight_channel. */
void film_airlight_develop(const struct film_airlight *sums, int samples, float *channels);

/* Sums of a pixel's light visibility, on request, weighted as in struct film_pixel. */
struct film_seen {
    float unshadowed[3], visible[3], all[3];
    struct film_seen_stream {
        float visible, all; /* sums over RGB */
    } streams[FILM_STREAMS];
};

void film_seen_add(struct film_seen *sums, int stream, vec3s albedo, const struct seen *seen);
void film_seen_merge(struct film_seen *sums, const struct film_seen *other);

/* Writes the layers from CHANNEL_UNSHADOWED on. */
void film_seen_develop(const struct film_seen *sums, const struct film_pixel *pixel,
                       float *channels);

/* Sums of a pixel's specular reflection, if some surface is specular. */
struct film_specular {
    float direct[3];
    float all[FILM_STREAMS][3];
};

void film_specular_add(struct film_specular *sums, int stream, const struct film_sample *sample);
void film_specular_merge(struct film_specular *sums, const struct film_specular *other);

/* Returns the mean of all specular reflection and its variance: 0 for a single sample. */
struct film_estimate film_specular_estimate(const struct film_specular *sums, int samples);

/* Writes the layers of enum specular_channel. */
void film_specular_develop(const struct film_specular *sums, int samples, float *channels);

/* Mean of the direct light over RGB, and the variance of this mean. */
struct film_direct_estimate {
    double mean, variance;
};
struct film_direct_estimate film_pixel_estimate_direct(const struct film_pixel *pixel);

/* Adds the sums of `other`. */
void film_pixel_merge(struct film_pixel *pixel, const struct film_pixel *other);

/* Estimates indirect light. The mean is unbiased for constant albedo in the pixel, else consistent:
 * a ratio of two means. */
struct film_estimate film_pixel_estimate(const struct film_pixel *pixel);

/* Writes all layers except depth. samples: all of the pixel, also those without a surface. */
void film_pixel_develop(const struct film_pixel *pixel, int samples, float *channels);

#endif
