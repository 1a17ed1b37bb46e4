/* An edge-avoiding a-trous wavelet filter [Dammertz et al. 2010, Edge-Avoiding A-Trous Wavelet
 * Transform for Fast Global Illumination Filtering]. As in [Schied et al. 2017, Spatiotemporal
 * Variance-Guided Filtering] the light's variance controls it, without time.
 *
 * Each level weights 5 x 5 pixels, 2^level apart. The weight is a B3 spline times similarity of
 * plane, normal, and light in units of its noise. Except for the plane, weights are symmetric, so
 * little energy is lost. Cost: levels x 25 x pixels. */
#ifndef REFERENCE_ATROUS_H
#define REFERENCE_ATROUS_H

#include <stdbool.h>

#include "base/unit.h"

struct atrous_guide {
    vec3s position, normal; /* metres; unit, or zero without a surface: such pixels are ignored */
    float pixel_size;       /* size of the pixel at the surface, metres */
    bool is_lonely;         /* set by atrous_find_lonely() */
};

struct atrous_pixel {
    vec3s light;
    float variance; /* of the mean over RGB */
};

struct atrous_desc {
    int width, height;
    const struct atrous_guide *guides; /* one a pixel */
    int levels;
    /* Number of first levels that do not compare light. With few paths, differences exceed their
     * estimated variance, and rare bright light would be lost. */
    int blind_levels;
    int threads; /* 0: all cores; the result does not depend on it */
};

/* Marks pixels whose neighbours mostly show other surfaces: leaves, mouldings, edges. They accept
 * less similar neighbours, because they have only a few paths of their own. */
void atrous_find_lonely(int width, int height, struct atrous_guide *guides);

/* Filters in place. From level to level the variance falls as for independent pixels. This keeps
 * more edges of light than the true variance, but is too small for other uses. */
void atrous_filter(const struct atrous_desc *desc, struct atrous_pixel *pixels);

/* Replaces variances by means over 7 x 7 pixels of the same surface. Without `known` they are
 * estimated from the spread of the light. */
void atrous_estimate_variance(const struct atrous_desc *desc, bool known,
                              struct atrous_pixel *pixels);

#endif
