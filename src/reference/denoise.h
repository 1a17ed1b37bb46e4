/* Removes most noise of a path-traced picture.
 *
 * Indirect light is filtered as irradiance (reference/atrous.h), so textures stay sharp. Positions
 * and normals of the samples separate surfaces. The spread of the sample streams gives the noise; a
 * single stream's noise is estimated from neighbours. Direct light is not filtered: noise of points
 * is at edges within pixels, which a filter would widen, and lights with a size stay noisy.
 * Specular light is not filtered either, because edges in a mirror are not edges of the mirror. */
#ifndef REFERENCE_DENOISE_H
#define REFERENCE_DENOISE_H

#include "reference/film.h"
#include "reference/primary.h"

struct denoise_desc {
    const struct film_pixel *pixels;
    const struct primary_rays *primary;
    int samples, paths;   /* samples of a pixel; paths of indirect light of a sample */
    int threads;          /* 0: all cores */
    int specular_channel; /* first channel of CHANNELS_OF_SPECULAR; 0: none */
    int airlight_channel; /* first channel of CHANNELS_OF_AIRLIGHT; 0: none */
};

/* Filters `image`, developed from the pixels: indirect layer and beauty. Standard errors stay those
 * of the unfiltered light. */
void denoise(const struct denoise_desc *desc, struct image *image);

#endif
