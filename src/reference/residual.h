/* What a bound of the geometry term takes from the sum over VPLs, found by rays [Kollig and Keller 2004]:
 *
 *     E_r(x) = int L(y) max(0, 1 - b / G(x, y)) cos_x dw,    y the first surface along w,
 *
 * and the bounded sum and E_r are together the light of one bounce, for every bound b. As G <= 1 / d^2,
 * what is farther than b^-1/2 adds nothing, and only near surfaces are asked for their light.
 */
#ifndef REFERENCE_RESIDUAL_H
#define REFERENCE_RESIDUAL_H

#include "reference/sampler.h"
#include "reference/scene/emission.h"

struct residual {
    const struct ray_scene *rays;
    const struct emission *emission;
    float bound; /* b, 1/m2 */
    int samples;
};

/* An estimate of E_r over pi, of the light that y reflects diffusely; a seed of each place. */
vec3s residual_light(const struct residual *residual, const struct hit *x, uint32_t seed);

#endif
