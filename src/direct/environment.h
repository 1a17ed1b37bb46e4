/* Adds environment lighting to another method, which draws the lamps: by default 120 area lights
 * with soft shadows [Dong 2011 §5.3.2]. Specular surfaces also trace rays of their lobe (SKY.md).
 */
#ifndef DIRECT_ENVIRONMENT_H
#define DIRECT_ENVIRONMENT_H

#include "direct/direct.h"

struct environment_settings {
    int lights, fit; /* fit: enum sky_fit */
    int shadow_rays; /* per environment light */
    int directions;  /* maximum of directions from which reflected light starts */
};

extern const struct settings_part sky_part;

/* Draws desc.lamps first. desc.sky has at least one light. Not in direct_methods: users cannot name
 * it. */
extern const struct direct_method environment_direct;

#endif
