/* What the camera sees through glass and in mirrors: the first other surface along a chain of them. */
#ifndef REFERENCE_CHAIN_H
#define REFERENCE_CHAIN_H

#include "reference/scene/emission.h"

struct chain {
    bool hits; /* a surface, at `end`; else the ray leaves the scene, or the chain is cut */
    bool cut;
    struct hit end;
    vec3s direction; /* of the last ray */
    vec3s share;     /* of the radiance there that comes to the first surface */
    vec3s airlight;  /* what comes there from the medium along the chain, radiance */
};

/* From a surface that is glass or a mirror, by the sampler's next pairs. */
struct chain chain_follow(const struct emission *emission, const struct ray_scene *rays,
                          const struct hit *first, struct sampler *sampler);

#endif
