/* An edge-avoiding a-trous wavelet filter: [Dammertz et al. 2010, Edge-Avoiding A-Trous Wavelet
 * Transform for Fast Global Illumination Filtering]; steered by the light's variance as in [Schied
 * et al. 2017, Spatiotemporal Variance-Guided Filtering], over space alone.
 *
 * Each level weights 5 x 5 pixels, 2^level apart, by a B3 spline, by how near they lie to the
 * pixel's tangent plane, by their normals, and by how their light differs in units of its noise. A
 * weight depends on two pixels in the same way from either side, but for the distance to the plane;
 * so that little energy is lost.
 */
#ifndef REFERENCE_ATROUS_H
#define REFERENCE_ATROUS_H

#include <stdbool.h>

#include "base/unit.h"

struct atrous_guide {
    vec3s position, normal; /* metres; unit, or zero where nothing is seen: such pixels stay out */
    float pixel_size;       /* there, metres */
    bool is_lonely;         /* set by atrous_find_lonely() */
};

struct atrous_pixel {
    vec3s light;
    float variance; /* of the mean over the channels */
};

struct atrous_desc {
    int width, height;
    const struct atrous_guide *guides; /* of each pixel */
    int levels;
    /* Levels at first that do not compare light. Few paths differ by more than their variance tells,
     * and what is bright and rare would be lost. */
    int blind_levels;
    int threads; /* 0 = all cores; does not change the result */
};

/* Marks the pixels whose neighbours mostly show other surfaces: leaves, mouldings, edges. They take
 * light from less like ones, for their own is but a few paths'. */
void atrous_find_lonely(int width, int height, struct atrous_guide *guides);

/* Filters in place. From level to level the variance falls as though pixels were independent, which
 * keeps more of the light's edges than its true one, and is too small for anything else. */
void atrous_filter(const struct atrous_desc *desc, struct atrous_pixel *pixels);

/* Replaces the variances by what the neighbours of the same surface tell: means of theirs over 7 x 7
 * pixels; or, where `known` is false, the spread of the light itself. */
void atrous_estimate_variance(const struct atrous_desc *desc, bool known,
                              struct atrous_pixel *pixels);

#endif
