#include "reference/airlight.h"

#include "reference/vector.h"

#include <math.h>

struct ray {
    vec3s origin, direction;
    float segment[2]; /* in the medium */
};

/* A point of the ray: how far along it, and the metres of ray that it stands for. */
struct point {
    float along, stands_for;
};

/* Even in psi, where tan(angle / 2) = tan(psi) / k, k = (1 + g) / (1 - g), and the angle is that of
 * the scattering: its density is a wrapped Cauchy distribution, as pointed as the phase function
 * is, and even in the angle where g = 0. */
static float psi_at(float from_foot, float h, float k) {
    float r = hypotf(from_foot, h);
    return from_foot > 0 ? atan2f(k * (r + from_foot), h) : atan2f(k * h, r - from_foot);
}

static struct point point_towards(const struct ray *ray, vec3s light, float g, float least_h,
                                  float sample) {
    vec3s to_light = glms_vec3_sub(light, ray->origin);
    float foot = glms_vec3_dot(to_light, ray->direction);
    vec3s aside = glms_vec3_muladds(ray->direction, -foot, to_light);
    float h = fmaxf(glms_vec3_norm(aside), least_h), k = (1 + g) / (1 - g);
    float from = psi_at(ray->segment[0] - foot, h, k), to = psi_at(ray->segment[1] - foot, h, k);
    float psi = glm_lerp(from, to, sample), s = sinf(psi), c = k * cosf(psi);
    float r = h * (s * s + c * c) / (2 * s * c);
    float along = foot - h * (c * c - s * s) / (2 * s * c);
    return (struct point){along, (to - from) * 2 * k * r * r / ((s * s + c * c) * h)};
}

/* By the light that passes the medium. */
static struct point point_by_depth(const struct ray *ray, const struct medium_ball *medium,
                                   float sample) {
    float sigma = glms_vec3_hadd(medium->extinction) / 3;
    float length = ray->segment[1] - ray->segment[0], stopped = -expm1f(-sigma * length);
    float along = sigma * length < 1e-3F ? sample * length : -log1pf(-sample * stopped) / sigma;
    float density = sigma * length < 1e-3F ? 1 / length : sigma * expf(-sigma * along) / stopped;
    return (struct point){ray->segment[0] + along, 1 / density};
}

static vec3s from_piece(const struct emission *emission, const struct ray_scene *rays,
                        const struct ray *ray, const struct emitter *piece, float sample) {
    const struct medium_ball *medium = &emission->medium;
    bool directional = piece->type == EMITTER_DIRECTIONAL;
    vec3s light = vector_of(piece->position),
          to_light = glms_vec3_negate(vector_of(piece->direction));
    float distance = 2 * emission->radius, strength = 1;
    struct point point =
        directional ? point_by_depth(ray, medium, sample)
                    : point_towards(ray, light, medium->g, 1e-6F * emission->radius, sample);
    vec3s x = glms_vec3_muladds(ray->direction, point.along, ray->origin);
    if (!directional) {
        vec3s path = glms_vec3_sub(light, x);
        distance = glms_vec3_norm(path);
        float cos_axis = glms_vec3_dot(path, to_light) / distance;
        to_light = glms_vec3_scale(path, 1 / distance);
        strength = emitter_cone(piece, cos_axis) * emitter_in_range(piece, distance) /
                   (distance * distance);
    }
    float phase = medium_phase(medium->g, glms_vec3_dot(to_light, ray->direction));
    float share = strength * phase * point.stands_for;
    if (!(share > 0 && isfinite(share)))
        return glms_vec3_zero();
    vec3s open = ray_scene_passes(rays, x, glms_vec3_muladds(to_light, distance, x));
    vec3s passes = glms_vec3_mul(medium_passes(medium, point.along - ray->segment[0]),
                                 medium_transmittance(medium, x, to_light, distance));
    vec3s scattered = glms_vec3_mul(medium->scattering, vector_of(piece->intensity));
    scattered =
        glms_vec3_mul(scattered, glms_vec3_mul(open, ray_scene_share(rays, ray->origin, x)));
    scattered = glms_vec3_mul(scattered, emission_slide(piece, glms_vec3_negate(to_light)));
    return glms_vec3_scale(glms_vec3_mul(scattered, passes), share);
}

/* Lights of the tree for each sampler. */
enum { AIRLIGHT_CHOICES = 8 };

/* Samples a light of the tree by its light at some point of the ray, or evenly: all light along the
 * ray has a chance. Returns its number, or -1; writes 1 over its probability. */
static int choose_light(const struct emission *emission, const struct ray *ray,
                        struct sampler *sampler, float *weight) {
    float along = point_by_depth(ray, &emission->medium, sampler_next(sampler).x).along;
    vec2s sample = sampler_next(sampler);
    vec3s x = glms_vec3_muladds(ray->direction, along, ray->origin), anywhere = glms_vec3_zero();
    float probability;
    int count = emission->light_count, n = (int)(sample.y * (float)count);
    if (sample.x < .5F)
        n = light_tree_sample(&emission->tree, x.raw, anywhere.raw, sample.y, &probability);
    if (n < 0)
        return -1;
    probability = light_tree_probability(&emission->tree, x.raw, anywhere.raw, n);
    *weight = 1 / (.5F * probability + .5F / (float)count);
    return n;
}

static vec3s from_source(const struct emission *emission, const struct ray_scene *rays,
                         const struct ray *ray, int n, struct sampler *sampler) {
    vec2s place = sampler_next(sampler);
    struct emitter piece = emission_piece(emission, n, place);
    return from_piece(emission, rays, ray, &piece, sampler_next(sampler).x);
}

static vec3s from_tree(const struct emission *emission, const struct ray_scene *rays,
                       const struct ray *ray, struct sampler *sampler) {
    vec3s sum = glms_vec3_zero();
    float weight;
    for (int i = 0; emission->has_tree && i < AIRLIGHT_CHOICES; i++) {
        int n = choose_light(emission, ray, sampler, &weight);
        if (n >= 0)
            sum = glms_vec3_muladds(from_source(emission, rays, ray, n, sampler),
                                    weight / AIRLIGHT_CHOICES, sum);
    }
    return sum;
}

vec3s airlight_along(const struct emission *emission, const struct ray_scene *rays, vec3s origin,
                     vec3s direction, float length, const struct sampler *samplers, int count) {
    struct ray ray = {origin, direction, {0}};
    vec3s sum = glms_vec3_zero();
    if (!medium_segment(&emission->medium, origin, direction, length, ray.segment))
        return sum;
    for (int i = 0; i < count; i++) {
        struct sampler sampler = samplers[i];
        sum = glms_vec3_add(sum, from_tree(emission, rays, &ray, &sampler));
        for (int n = emission->has_tree ? emission->light_count : 0; n < emission->count; n++)
            sum = glms_vec3_add(sum, from_source(emission, rays, &ray, n, &sampler));
    }
    return glms_vec3_scale(sum, 1 / (float)count);
}
