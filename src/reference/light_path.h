/* Traces one light ray through glass and mirrors, and its deposits in the picture. */
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
    bool straight; /* as in struct light_tracer_desc */
};

struct light_deposits {
    struct light_deposit *items;
    int count, room;
};

/* Follows the ray with its flux. It appends deposits and adds to `balance`. */
void light_path_trace(const struct light_path_scene *scene, const struct light_ray *ray,
                      struct sampler *sampler, struct light_deposits *deposits,
                      struct light_balance *balance);

#endif
