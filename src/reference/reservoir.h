/* One of several lights or places, picked by what it would give without its shadow, so that one shadow
 * ray stands for all [Talbot et al. 2005]. */
#ifndef REFERENCE_RESERVOIR_H
#define REFERENCE_RESERVOIR_H

#include "reference/scene/ray_scene.h"

/* Begin with a random number in [0, 1) as `pick`, all else zero. */
struct reservoir {
    float pick, sum, picked; /* the number; how bright all are, and the one that is kept */
    struct reflected light;  /* what that one gives */
    vec3s source;            /* from where */
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

/* What all that was offered gives at the hit, by the shadow ray of the one. */
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
