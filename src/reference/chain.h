/* Follows a camera ray through glass and mirrors to the first other surface. */
#ifndef REFERENCE_CHAIN_H
#define REFERENCE_CHAIN_H

#include "reference/scene/emission.h"

struct chain {
    bool hits; /* hits a surface, at `end`; else the ray leaves the scene, or the chain is cut */
    bool cut;
    struct hit end;
    vec3s direction; /* direction of the last ray */
    vec3s share;     /* fraction of the radiance at `end` that reaches the first surface */
    vec3s between;   /* radiance from the medium and from emissive glass along the chain */
};

/* Follows the chain from `first`, glass or a mirror, by the sampler's next pairs. */
struct chain chain_follow(const struct emission *emission, const struct ray_scene *rays,
                          const struct hit *first, struct sampler *sampler);

#endif
