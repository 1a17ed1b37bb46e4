/* A reservoir: samples one of several lights or places by its unshadowed light, so that one shadow
 * ray represents all [Talbot et al. 2005]. */
#ifndef REFERENCE_RESERVOIR_H
#define REFERENCE_RESERVOIR_H

#include "reference/scene/ray_scene.h"

/* Start with a random number in [0, 1) as `pick` and zeros elsewhere. */
struct reservoir {
    float pick, sum, picked; /* random number; total brightness; brightness of the sample */
    struct reflected light;  /* light of the sample */
    vec3s source;            /* origin of this light */
};

static inline void reservoir_offer(struct reservoir *reservoir, const struct reflected *given,
                                   vec3s source) {
    float bright = glms_vec3_max(given->diffuse) + glms_vec3_max(given->specular);
    reservoir->sum += bright;
    if (reservoir->pick * reservoir->sum < bright) {
        reservoir->pick *= reservoir->sum / bright;
        reservoir->light = *given;
        reservoir->source = source;
        reservoir->picked = bright;
    } else if (bright < reservoir->sum) {
        reservoir->pick = (reservoir->pick * reservoir->sum - bright) / (reservoir->sum - bright);
    }
}

/* Returns the light of everything offered, at the hit, by one shadow ray to the sample. */
static inline struct reflected reservoir_light(const struct reservoir *reservoir,
                                               const struct ray_scene *rays,
                                               const struct hit *hit) {
    if (reservoir->picked == 0)
        return (struct reflected){0};
    vec3s passes = ray_scene_passes(rays, ray_scene_departure(rays, hit), reservoir->source);
    return reflected_scale(&reservoir->light,
                           glms_vec3_scale(passes, reservoir->sum / reservoir->picked));
}

#endif
