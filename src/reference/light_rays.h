/* Rays that start from the lights, each with its part of their flux. */
#ifndef REFERENCE_LIGHT_RAYS_H
#define REFERENCE_LIGHT_RAYS_H

#include "reference/scene/emission.h"

/* Where all rays go to: a ball around what they are to meet, in which every ray that meets it starts or arrives. */
struct light_aim {
    vec3s center;
    float radius; /* metres; infinite: the rays go wherever the light shines */
};

/* Around all glass and mirrors. */
struct light_aim light_aim_of(const struct hit_table *table);

struct light_ray {
    struct emitter piece; /* the light without a size that it starts from */
    vec3s origin, direction;
    vec3s flux; /* of the whole light's rays to the aim, W */
};

/* A ray of the n-th light, by a place and two numbers more in [0, 1); false: it has no flux. */
bool light_ray_start(const struct emission *emission, int n, vec2s place, vec2s sample,
                     const struct light_aim *aim, float clearance, struct light_ray *ray);

/* The number of rays of the n-th light: most by its flux, and some for each. */
int light_ray_count(const struct emission *emission, int n, double all);

#endif
