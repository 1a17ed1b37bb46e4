/* One ray of light through glass and mirrors, and what it leaves in the picture. */
#ifndef REFERENCE_LIGHT_PATH_H
#define REFERENCE_LIGHT_PATH_H

#include "reference/camera_link.h"
#include "reference/light_film.h"
#include "reference/light_rays.h"
#include "reference/light_tracer.h"

struct light_path_scene {
    const struct ray_scene *rays;
    const struct emission *emission;
    struct camera_link link;
    bool straight; /* light_tracer_desc's */
};

struct light_deposits {
    struct light_deposit *items;
    int count, room;
};

/* Follows a ray with that flux. */
void light_path_trace(const struct light_path_scene *scene, const struct light_ray *ray,
                      struct sampler *sampler, struct light_deposits *deposits,
                      struct light_balance *balance);

#endif
