#include "reference/smooth.h"

#include <math.h>

/* Of the angle of refraction; negative: total reflection. */
static float cosine2_within(float cosine, float from_to) {
    return 1 - from_to * from_to * (1 - cosine * cosine);
}

float smooth_reflectance(float cosine, float from_to) {
    float within2 = cosine2_within(cosine, from_to);
    if (within2 <= 0)
        return 1;
    float within = sqrtf(within2);
    float parallel = (cosine - from_to * within) / (cosine + from_to * within);
    float across = (from_to * cosine - within) / (from_to * cosine + within);
    return (parallel * parallel + across * across) / 2;
}

bool smooth_refract(vec3s direction, vec3s normal, float from_to, vec3s *refracted) {
    float cosine = -glms_vec3_dot(direction, normal);
    float within2 = cosine2_within(cosine, from_to);
    if (within2 <= 0)
        return false;
    *refracted = vec3s_unit(glms_vec3_muladds(normal, from_to * cosine - sqrtf(within2),
                                              glms_vec3_scale(direction, from_to)));
    return true;
}

static vec3s reflect(vec3s direction, vec3s normal) {
    return vec3s_unit(glms_vec3_muladds(normal, -2 * glms_vec3_dot(direction, normal), direction));
}

static bool is_solid(const struct material *material) {
    return material_smooth_kind(material) == SMOOTH_GLASS && !material->thin_walled;
}

const struct material *smooth_inside(const struct hit *hit, const struct material *inside) {
    return hit->smooth && hit->is_back && is_solid(hit->smooth) ? hit->smooth : inside;
}

vec3s smooth_passes(const struct material *glass, float length) {
    vec3s passes = glms_vec3_one();
    for (int c = 0; c < 3; c++)
        if (glass->absorption[c] > 0 && length > 0) /* 0 times infinity is no number */
            passes.raw[c] = expf(-glass->absorption[c] * length);
    return passes;
}

/* Light that enters or leaves glass. */
static bool pass(const struct hit *hit, vec3s normal, vec3s *direction, float pick) {
    const struct material *glass = hit->smooth;
    bool leaves = hit->is_back && !glass->thin_walled;
    float index = fmaxf(glass->index_of_refraction, 1), from_to = leaves ? index : 1 / index;
    float reflectance = smooth_reflectance(-glms_vec3_dot(*direction, normal), from_to);
    if (glass->thin_walled)
        reflectance = 2 * reflectance / (1 + reflectance);
    return pick >= reflectance &&
           (glass->thin_walled || smooth_refract(*direction, normal, from_to, direction));
}

/* By that normal. False: the light ends on the wrong side of the triangle. */
static bool leave_by(const struct ray_scene *rays, const struct hit *hit, vec3s normal, float pick,
                     struct smooth_ray *ray) {
    const struct material *material = hit->smooth;
    bool is_mirror = material_smooth_kind(material) == SMOOTH_MIRROR;
    ray->direction = glms_vec3_negate(hit->towards);
    bool passes = !is_mirror && pass(hit, normal, &ray->direction, pick);
    if (!passes)
        ray->direction = reflect(ray->direction, normal);
    float side = passes ? -1 : 1;
    ray->origin =
        ray_scene_above(rays, hit->position, glms_vec3_scale(hit->geometric_normal, side));
    ray->share = is_mirror ? hit->tint : glms_vec3_one();
    if (passes)
        ray->share = glms_vec3_scale(hit->tint, material->transmission * (1 - material->metalness));
    ray->inside = is_solid(material) && passes != hit->is_back ? material : NULL;
    return side * glms_vec3_dot(ray->direction, hit->geometric_normal) > 0;
}

struct smooth_ray smooth_leave(const struct ray_scene *rays, const struct hit *hit, float pick) {
    struct smooth_ray ray;
    if (glms_vec3_dot(hit->normal, hit->towards) <= 0 ||
        !leave_by(rays, hit, hit->normal, pick, &ray))
        leave_by(rays, hit, hit->geometric_normal, pick, &ray);
    return ray;
}
