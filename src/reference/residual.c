#include "reference/residual.h"

#include "reference/warp.h"

#include <math.h>

/* The share of y's light that the bound takes; direction and distance are those from x to y. */
static float share_taken(float bound, const struct hit *x, vec3s direction, const struct hit *y) {
    float cos_x = glms_vec3_dot(x->normal, direction), cos_y = -glms_vec3_dot(y->normal, direction);
    if (cos_x <= 0 || cos_y <= 0 || hit_is_black(y))
        return 0;
    float term = cos_x * cos_y / glms_vec3_distance2(x->position, y->position);
    return fmaxf(0, 1 - bound / term);
}

/* Over pi, by the density of cosines. */
static vec3s along(const struct residual *residual, const struct hit *x, struct sampler *sampler) {
    vec3s direction = warp_to_cosine(sampler_next(sampler), x->normal);
    struct hit y;
    if (glms_vec3_dot(direction, x->geometric_normal) <= 0 ||
        !ray_scene_hit(residual->rays, ray_scene_departure(residual->rays, x), direction, &y))
        return glms_vec3_zero();
    float share = share_taken(residual->bound, x, direction, &y);
    if (share == 0)
        return glms_vec3_zero();
    struct reflected direct = emission_direct(residual->emission, residual->rays, &y, sampler, 1);
    vec3s sent = glms_vec3_mul(y.share, glms_vec3_mul(y.brdf.albedo, direct.diffuse));
    return glms_vec3_scale(sent, share);
}

vec3s residual_light(const struct residual *residual, const struct hit *x, uint32_t seed) {
    vec3s sum = glms_vec3_zero();
    for (int i = 0; i < residual->samples; i++) {
        struct sampler sampler = {.seed = seed, .index = (uint32_t)i};
        sum = glms_vec3_add(sum, along(residual, x, &sampler));
    }
    return glms_vec3_scale(sum, 1 / (float)residual->samples);
}
