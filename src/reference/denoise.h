/* A path-traced picture without most of its noise.
 *
 * The indirect light is filtered (reference/atrous.h), as irradiance: what the albedo draws stays
 * sharp. Surfaces are told apart by the positions and normals that the samples themselves saw. The
 * noise is known from the streams of samples; of a single one it is guessed from the neighbours. The
 * direct light stays as it is: that of points has the noise of edges within pixels, which a filter over
 * pixels only makes wider; that of lights with a size stays noisy. So does specular light: what a mirror
 * shows has edges that no position or normal of the mirror tells.
 */
#ifndef REFERENCE_DENOISE_H
#define REFERENCE_DENOISE_H

#include "reference/film.h"
#include "reference/primary.h"

struct denoise_desc {
    const struct film_pixel *pixels;
    const struct primary_rays *primary;
    int samples, paths;   /* of each pixel, of indirect light from each sample */
    int threads;          /* 0 = all cores */
    int specular_channel; /* where CHANNELS_OF_SPECULAR begin; 0 = there are none */
    int airlight_channel; /* the same of CHANNELS_OF_AIRLIGHT */
};

/* image: developed from the pixels. Writes the indirect layer and beauty; the standard errors stay
 * those of the light before. */
void denoise(const struct denoise_desc *desc, struct image *image);

#endif
