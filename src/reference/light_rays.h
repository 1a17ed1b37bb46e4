/* Starts rays from the lights, each with a part of their flux. */
#ifndef REFERENCE_LIGHT_RAYS_H
#define REFERENCE_LIGHT_RAYS_H

#include "reference/scene/emission.h"

/* Target of all rays: a ball around the surfaces that they must reach. */
struct light_aim {
    vec3s center;
    float radius; /* metres; infinite: rays go wherever the light shines */
};

/* Returns a ball around all glass and mirrors; infinite if there are none. */
struct light_aim light_aim_of(const struct hit_table *table);

struct light_ray {
    struct emitter piece; /* point light at the ray's origin */
    vec3s origin, direction;
    vec3s flux; /* flux of the whole light towards the aim, W */
};

/* Makes a ray of the n-th light by a place and two more numbers in [0, 1). False: no flux. */
bool light_ray_start(const struct emission *emission, int n, vec2s place, vec2s sample,
                     const struct light_aim *aim, float clearance, struct light_ray *ray);

/* Returns the number of rays of the n-th light, of `all`: most by flux, some equally. */
int light_ray_count(const struct emission *emission, int n, double all);

#endif
