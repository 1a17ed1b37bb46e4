#include "reference/chain.h"

#include "reference/airlight.h"
#include "reference/smooth.h"

#include <math.h>

/* Within glass there is no medium. */
static void travel(const struct emission *emission, const struct ray_scene *rays,
                   const struct smooth_ray *ray, float length, const struct sampler *sampler,
                   struct chain *chain) {
    if (ray->inside) {
        chain->share = glms_vec3_mul(chain->share, smooth_passes(ray->inside, length));
        return;
    }
    if (!emission->medium.exists)
        return;
    vec3s light = airlight_along(emission, rays, ray->origin, ray->direction, length, sampler, 1);
    chain->between = glms_vec3_add(chain->between, glms_vec3_mul(chain->share, light));
    chain->share = glms_vec3_mul(
        chain->share, medium_transmittance(&emission->medium, ray->origin, ray->direction, length));
}

struct chain chain_follow(const struct emission *emission, const struct ray_scene *rays,
                          const struct hit *first, struct sampler *sampler) {
    struct chain chain = {.hits = true, .end = *first, .share = glms_vec3_one()};
    uint32_t pair = sampler->pair, of_step = 2 + 2 * (uint32_t)emission->count;
    for (int i = 0; chain.hits && chain.end.smooth; i++) {
        if (i == SMOOTH_MOST || glms_vec3_max(chain.share) <= 0) {
            chain.cut = true;
            chain.hits = false;
            break;
        }
        sampler->pair = pair + of_step * (uint32_t)i;
        struct smooth_ray ray = smooth_leave(rays, &chain.end, sampler_next(sampler).x);
        chain.share = glms_vec3_mul(chain.share, ray.share);
        chain.direction = ray.direction;
        chain.hits = ray_scene_hit(rays, ray.origin, ray.direction, &chain.end);
        vec3s panes = chain.end.share;
        if (chain.hits)
            ray.inside = smooth_inside(&chain.end, ray.inside);
        float length = chain.hits ? glms_vec3_distance(ray.origin, chain.end.position) : INFINITY;
        travel(emission, rays, &ray, length, sampler, &chain);
        chain.share = glms_vec3_mul(chain.share, panes);
        if (chain.hits && chain.end.smooth)
            chain.between = glms_vec3_muladd(
                chain.share, surfaces_glow(&emission->surfaces, &chain.end), chain.between);
    }
    return chain;
}
