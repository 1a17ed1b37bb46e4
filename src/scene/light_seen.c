#include "scene/light_seen.h"

#include "base/halton.h"

#include <math.h>

enum {
    SEEN_SIDE = 8, /* places a side of the picture */
    SEEN = SEEN_SIDE * SEEN_SIDE,
    FACED = 8,   /* seen places that each lit place is tried with */
    LIT = 256,   /* rays of all lights together */
    LIT_MIN = 8, /* rays of each at least */
    ROUNDS = 16, /* of as many rays, until one place has a way */
};

struct seen {
    struct surface_hit places[SEEN];
    int count;
};

static vec3s vector(const float v[3]) {
    return (vec3s){{v[0], v[1], v[2]}};
}

static void find_seen(struct seen *seen, const struct surface_rays *rays,
                      const struct camera *camera, float aspect) {
    seen->count = 0;
    for (int i = 0; i < SEEN; i++) {
        const float point[2] = {((float)(i % SEEN_SIDE) + .5F) / SEEN_SIDE,
                                ((float)(i / SEEN_SIDE) + .5F) / SEEN_SIDE};
        seen->count +=
            surface_rays_find_seen(rays, camera, point, aspect, &seen->places[seen->count]);
    }
}

struct light_ray {
    vec3s origin, direction;
    float flux; /* over that of others */
};

/* Parallel, through a disk as wide as the scene. */
static struct light_ray ray_of_sun(const struct emitter *sun, const struct geometry *geometry,
                                   double x, double y) {
    float radius = geometry->radius * (float)sqrt(x), angle = 2 * GLM_PIf * (float)y;
    vec3s from =
        glms_vec3_muladds(vector(sun->direction), -2 * geometry->radius, vector(geometry->center));
    from = glms_vec3_muladds(vector(sun->right), radius * cosf(angle), from);
    from = glms_vec3_muladds(vector(sun->up), radius * sinf(angle), from);
    return (struct light_ray){from, vector(sun->direction), 1};
}

/* Even over what the light shines into, as VPLs by flux are. */
static struct light_ray ray_of_lamp(const struct emitter *lamp, float clearance, double x,
                                    double y) {
    double end = 1 - emitter_solid_angle(lamp) / (2 * GLM_PI), z = 1 - x * (1 - end);
    float across = (float)sqrt(fmax(0, 1 - z * z)), angle = 2 * GLM_PIf * (float)y;
    vec3s direction = glms_vec3_scale(vector(lamp->direction), (float)z);
    direction = glms_vec3_muladds(vector(lamp->right), across * cosf(angle), direction);
    direction = glms_vec3_muladds(vector(lamp->up), across * sinf(angle), direction);
    vec3s origin = glms_vec3_muladds(direction, clearance, vector(lamp->position));
    return (struct light_ray){origin, direction, emitter_cone(lamp, (float)z)};
}

static struct light_ray light_ray(const struct surface_rays *rays, const struct emitter *emitter,
                                  uint32_t number) {
    const float place[2] = {(float)radical_inverse(5, number), (float)radical_inverse(7, number)};
    const struct emitter piece = emitter_piece(emitter, place);
    double x = radical_inverse(2, number), y = radical_inverse(3, number);
    return piece.type == EMITTER_DIRECTIONAL ? ray_of_sun(&piece, rays->geometry, x, y)
                                             : ray_of_lamp(&piece, rays->clearance, x, y);
}

static bool faces(const struct surface_rays *rays, const struct surface_hit *a,
                  const struct surface_hit *b) {
    vec3s path = glms_vec3_sub(b->position, a->position);
    return glms_vec3_dot(path, a->normal) > 0 && glms_vec3_dot(path, b->normal) < 0 &&
           !surface_rays_blocked(rays, a->position, b->position);
}

/* Tries others for each lit place. */
static bool is_faced(const struct surface_rays *rays, const struct seen *seen,
                     const struct surface_hit *lit, uint32_t number) {
    bool faced = false;
    for (uint32_t i = 0; i < FACED && !faced; i++) {
        double at = radical_inverse(2, number * FACED + i);
        faced = faces(rays, lit, &seen->places[(int)(at * seen->count)]);
    }
    return faced;
}

struct fluxes {
    double all, useful;
};

static void add_light(struct fluxes *fluxes, const struct surface_rays *rays,
                      const struct seen *seen, const struct emitter *emitter,
                      const uint32_t numbers[2]) {
    double flux = emitter_flux(emitter, rays->geometry->radius);
    for (uint32_t i = numbers[0]; i < numbers[1]; i++) {
        struct surface_hit lit;
        struct light_ray ray = light_ray(rays, emitter, i);
        if (!surface_rays_find(rays, ray.origin, ray.direction, &lit))
            continue;
        fluxes->all += flux * ray.flux;
        if (is_faced(rays, seen, &lit, i))
            fluxes->useful += flux * ray.flux;
    }
}

float light_seen(const struct surface_rays *rays, const struct emitters *emitters,
                 const struct camera *camera, float aspect) {
    struct seen seen;
    struct fluxes fluxes = {0, 0};
    find_seen(&seen, rays, camera, aspect);
    if (seen.count == 0 || emitters->count == 0)
        return 1;
    uint32_t share = LIT / (uint32_t)emitters->count, each = share > LIT_MIN ? share : LIT_MIN;
    for (uint32_t round = 0; round < ROUNDS && fluxes.useful <= 0; round++) {
        const uint32_t numbers[] = {1 + round * each, 1 + (round + 1) * each};
        for (int e = 0; e < emitters->count; e++)
            add_light(&fluxes, rays, &seen, &emitters->items[e], numbers);
    }
    return fluxes.useful > 0 ? (float)(fluxes.useful / fluxes.all) : 1;
}
