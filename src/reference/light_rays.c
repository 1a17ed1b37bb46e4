#include "reference/light_rays.h"

#include "reference/vector.h"
#include "reference/warp.h"

#include <math.h>

static void widen(const struct hit_table *table, const struct geometry_batch *batch, vec3s box[2]) {
    const struct geometry *geometry = table->geometry;
    for (uint32_t i = 0; i < batch->index_count; i++) {
        vec3s corner = vector_of(geometry->position[geometry->indices[batch->first_index + i]]);
        box[0] = glms_vec3_minv(box[0], corner);
        box[1] = glms_vec3_maxv(box[1], corner);
    }
}

struct light_aim light_aim_of(const struct hit_table *table) {
    const struct geometry *geometry = table->geometry;
    vec3s box[2] = {glms_vec3_fill(INFINITY), glms_vec3_fill(-INFINITY)};
    for (int b = 0; b < geometry->batch_count && table->has_smooth; b++)
        if (material_smooth_kind(&table->scene->materials[geometry->batches[b].material]))
            widen(table, &geometry->batches[b], box);
    if (!(box[0].x <= box[1].x))
        return (struct light_aim){.radius = INFINITY};
    float slack = 1e-3F * geometry->radius; /* of rounding */
    return (struct light_aim){glms_vec3_center(box[0], box[1]),
                              glms_vec3_distance(box[0], box[1]) / 2 + slack};
}

/* Even across the ball's cross section. */
static void start_far(const struct emission *emission, vec2s sample, const struct light_aim *aim,
                      struct light_ray *ray) {
    bool all = isinf(aim->radius);
    vec3s center = all ? emission->center : aim->center;
    float radius = all ? emission->radius : aim->radius;
    float back = 2 * emission->radius + glms_vec3_distance(center, emission->center);
    ray->direction = vector_of(ray->piece.direction);
    ray->origin = glms_vec3_muladds(warp_to_disc(sample, ray->direction), radius, center);
    ray->origin = glms_vec3_muladds(ray->direction, -back, ray->origin);
    ray->flux = glms_vec3_scale(ray->flux, GLM_PIf * radius * radius);
}

/* Even in the cone that holds the ball, where that is narrower than the light's own. */
static bool aim_at(const struct emitter *piece, const struct light_aim *aim, vec2s sample,
                   struct light_ray *ray) {
    vec3s path = glms_vec3_sub(aim->center, vector_of(piece->position));
    float distance = glms_vec3_norm(path), sine = aim->radius / distance;
    if (!(sine < 1))
        return false;
    float cosine = sqrtf(1 - sine * sine);
    if (piece->type == EMITTER_SPOT && cosine <= piece->cos_outer)
        return false;
    float height = sine * sine / (1 + cosine); /* 1 - cosine, of small balls far away, too */
    ray->direction = warp_to_cap(sample, glms_vec3_scale(path, 1 / distance), height);
    float falls = emitter_cone(piece, glms_vec3_dot(ray->direction, vector_of(piece->direction)));
    ray->flux = glms_vec3_scale(ray->flux, falls * 2 * GLM_PIf * height);
    return true;
}

static void start_near(vec2s sample, struct light_ray *ray) {
    const struct emitter *piece = &ray->piece;
    vec3s axis = vector_of(piece->direction);
    if (piece->type == EMITTER_AREA) {
        ray->direction = warp_to_cosine(sample, axis);
        ray->flux = glms_vec3_scale(ray->flux, GLM_PIf);
        return;
    }
    float rim = piece->type == EMITTER_SPOT ? piece->cos_outer : -1;
    ray->direction = warp_to_cone(sample, axis, rim);
    float falls = emitter_cone(piece, glms_vec3_dot(ray->direction, axis));
    ray->flux = glms_vec3_scale(ray->flux, falls * 2 * GLM_PIf * (1 - rim));
}

bool light_ray_start(const struct emission *emission, int n, vec2s place, vec2s sample,
                     const struct light_aim *aim, float clearance, struct light_ray *ray) {
    ray->piece = emission_piece(emission, n, place);
    ray->flux = vector_of(ray->piece.intensity);
    if (ray->piece.type == EMITTER_DIRECTIONAL) {
        start_far(emission, sample, aim, ray);
    } else {
        if (!aim_at(&ray->piece, aim, sample, ray))
            start_near(sample, ray);
        ray->origin = glms_vec3_muladds(ray->direction, clearance, vector_of(ray->piece.position));
        ray->flux = glms_vec3_mul(ray->flux, emission_slide(&ray->piece, ray->direction));
    }
    return glms_vec3_max(ray->flux) > 0;
}

int light_ray_count(const struct emission *emission, int n, double all) {
    double share = .9 * (double)emission->sources[n].share + .1 / emission->count;
    return (int)fmax(1, round(share * all));
}
