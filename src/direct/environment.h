/* The light of an environment map, added to that of another method, which draws the lamps: by default 120 area lights
 * with soft shadows [Dong 2011 §5.3.2]. */
#ifndef DIRECT_ENVIRONMENT_H
#define DIRECT_ENVIRONMENT_H

#include "direct/direct.h"

struct environment_settings {
    int lights, fit; /* enum sky_fit */
    int shadow_rays;
    int directions; /* that reflected light starts from, at most */
};

extern const struct settings_part sky_part;

/* Not among direct_methods, nor named by users: draws desc.lamps first. desc.sky has one light at least. */
extern const struct direct_method environment_direct;

#endif
