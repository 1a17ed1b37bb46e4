#include "lights/sky_seen.h"

#include "base/halton.h"
#include "base/memory.h"
#include "base/parallel.h"

#include <math.h>
#include <stdlib.h>

enum {
    SEEN_SIDE = 16, /* places a side of the picture */
    AROUND = 2,     /* rays from each */
    PLACES = SEEN_SIDE * SEEN_SIDE * AROUND,
};

/* Of light that has longer ways, in mean weights: no direction is chosen less than half as often as
 * by its power. */
static const float least_weight = 1;

/* Over the mean distance of light from the middle of its door. */
static const float door_radius = 1.5F;

struct place {
    vec3s position, normal;
};

struct places {
    const struct surface_rays *rays;
    struct place items[PLACES];
    int count;
};

/* What the picture shows the light of by one bounce. */
static void find_places(struct places *places, const struct camera *camera, float aspect) {
    for (int i = 0; i < SEEN_SIDE * SEEN_SIDE; i++) {
        const float point[2] = {((float)(i % SEEN_SIDE) + .5F) / SEEN_SIDE,
                                ((float)(i / SEEN_SIDE) + .5F) / SEEN_SIDE};
        struct surface_hit seen, met;
        if (!surface_rays_find_seen(places->rays, camera, point, aspect, &seen))
            continue;
        for (int k = 0; k < AROUND; k++) {
            uint32_t number = (uint32_t)(1 + AROUND * i + k);
            const float at[2] = {(float)radical_inverse(2, number),
                                 (float)radical_inverse(3, number)};
            vec3s direction = surface_ray_direction(seen.normal, at);
            if (surface_rays_find(places->rays, seen.position, direction, &met))
                places->items[places->count++] = (struct place){met.position, met.normal};
        }
    }
}

/* Of a directional light from there, the cosine that comes to a place. */
static float cosine_at(const struct places *places, const struct place *place, vec3s to) {
    float cosine = glms_vec3_dot(to, place->normal);
    return cosine > 0 && surface_rays_leave(places->rays, place->position, to) ? cosine : 0;
}

/* Sums over lines of light that come to places, from the middle of the scene: how far a point is
 * from them, in squares, is across[p, p] - 2 feet[p] + squares, over their weight. */
struct lines {
    mat3s across;
    vec3s feet;
    float squares, weight;
};

static void add_line(struct lines *lines, float weight, vec3s at, vec3s to) {
    float along = glms_vec3_dot(at, to);
    lines->squares += weight * (glms_vec3_norm2(at) - along * along);
    lines->weight += weight;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            float part = weight * ((float)(i == k) - to.raw[i] * to.raw[k]);
            lines->across.raw[i][k] += part;
            lines->feet.raw[i] += part * at.raw[k];
        }
}

struct asking {
    const struct places *places;
    const struct environment_lights *lights;
    const struct environment *sky;
    float *cosines;      /* of each light, the sum over places */
    struct lines *lines; /* of each light */
};

static vec3s middle_of(const struct places *places) {
    const float *center = places->rays->geometry->center;
    return (vec3s){{center[0], center[1], center[2]}};
}

/* Each place asks in another direction of the light. */
static void ask_light(void *context, size_t index) {
    const struct asking *asking = context;
    const struct environment_light light =
        environment_light_turned(&asking->lights->items[index], asking->sky);
    const vec3s middle = middle_of(asking->places);
    /* Leaves the sky's strength out: it would change rounding, and answers are kept while it
     * changes. */
    float sum = 0, power = environment_light_power(&asking->lights->items[index]);
    for (int i = 0; i < asking->places->count; i++) {
        const struct place *place = &asking->places->items[i];
        uint32_t number = (uint32_t)i + 1;
        const float at[2] = {(float)radical_inverse(2, number), (float)radical_inverse(3, number)};
        vec3s to;
        environment_light_direction(&light, at, to.raw);
        to = vec3s_unit(to);
        float cosine = cosine_at(asking->places, place, to);
        add_line(&asking->lines[index], cosine * power, glms_vec3_sub(place->position, middle), to);
        sum += cosine;
    }
    asking->cosines[index] = sum;
}

/* Returns whether light comes to any. */
static bool find_weights(float weights[], struct lines lines[], const struct places *places,
                         const struct environment_lights *lights, const struct environment *sky) {
    float power = 0, useful = 0;
    parallel_for((size_t)lights->count, 0, ask_light,
                 &(struct asking){places, lights, sky, weights, lines});
    for (int i = 0; i < lights->count; i++) {
        power += environment_light_power(&lights->items[i]);
        useful += weights[i] * environment_light_power(&lights->items[i]);
    }
    float unit = power > 0 ? useful / power : 0;
    for (int i = 0; i < lights->count; i++)
        weights[i] = unit > 0 ? least_weight + weights[i] / unit : 1;
    return unit > 0;
}

static void add_lines(struct lines *sum, const struct lines *lines) {
    for (int k = 0; k < 3; k++)
        sum->across.col[k] = glms_vec3_add(sum->across.col[k], lines->across.col[k]);
    sum->feet = glms_vec3_add(sum->feet, lines->feet);
    sum->squares += lines->squares;
    sum->weight += lines->weight;
}

/* The point nearest to all lines. What is unknown along lines of one direction is told by the
 * middle of the scene. */
static struct sky_door door_of(const struct lines *lines, vec3s middle) {
    struct sky_door door = {0};
    const float little = 1e-3F * lines->weight;
    if (!(lines->weight > 0))
        return door;
    mat3s across = lines->across;
    for (int k = 0; k < 3; k++)
        across.raw[k][k] += little;
    vec3s at = glms_mat3_mulv(glms_mat3_inv(across), lines->feet);
    float squares = glms_vec3_dot(at, glms_mat3_mulv(lines->across, at)) -
                    2 * glms_vec3_dot(at, lines->feet) + lines->squares;
    glm_vec3_add(middle.raw, at.raw, door.position);
    door.radius = door_radius * sqrtf(fmaxf(squares, 0) / lines->weight);
    return door;
}

static void find_doors(struct sky_groups *groups, const struct lines lines[], int light_count,
                       vec3s middle) {
    struct lines sums[ENVIRONMENT_LIGHTS_MAX] = {0};
    for (int i = 0; i < light_count; i++)
        add_lines(&sums[groups->of[i]], &lines[i]);
    for (int g = 0; g < groups->count; g++)
        groups->doors[g] = door_of(&sums[g], middle);
}

void sky_groups_by_seen(struct sky_groups *groups, const struct environment_lights *lights,
                        int count, const struct environment *sky, const struct surface_rays *rays,
                        const struct camera *camera, float aspect) {
    float weights[ENVIRONMENT_LIGHTS_MAX];
    struct lines lines[ENVIRONMENT_LIGHTS_MAX] = {0};
    struct places *places = mem_alloc(1, sizeof *places);
    places->rays = rays;
    find_places(places, camera, aspect);
    if (find_weights(weights, lines, places, lights, sky)) {
        environment_lights_group_by_weights(groups, lights, weights, count);
        find_doors(groups, lines, lights->count, middle_of(places));
    } else
        environment_lights_group(groups, lights, count);
    free(places);
}
