#include "lights/sky.h"

#include "base/memory.h"
#include "base/unit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void environment_lights_fit(struct environment_lights *lights, const struct environment *sky,
                            enum sky_fit fit, int count) {
    lights->count = sky ? environment_fit(lights->items, sky, fit, count) : 0;
}

/* --- directional lights ----------------------------------------------------------------------- */

float environment_light_power(const struct environment_light *light) {
    vec3 vector;
    environment_light_vector(light, vector);
    return (light->radiance[0] + light->radiance[1] + light->radiance[2]) / 3 *
           glm_vec3_norm(vector);
}

/* The same as a vector towards it, by its weight. */
static void add_power(const struct environment_light *light, float weight, float to[3]) {
    vec3 vector;
    environment_light_vector(light, vector);
    float mean = (light->radiance[0] + light->radiance[1] + light->radiance[2]) / 3;
    glm_vec3_muladds(vector, weight * mean, to);
}

/* Both: the vector, and how long it would be if all came from one side. */
static void weighted_power(const struct environment_light *light, float weight, float power[4]) {
    glm_vec3_zero(power);
    add_power(light, weight, power);
    power[3] = weight * environment_light_power(light);
}

/* By how far it moves how much. */
static float cost_of_joining(const float a[4], const float b[4]) {
    vec3 x, y;
    vec3_unit_to((float *)a, x);
    vec3_unit_to((float *)b, y);
    return a[3] * b[3] / (a[3] + b[3]) * glm_vec3_distance2(x, y);
}

/* The two of the first `count` that cost least. */
static struct sky_join find_join(float (*powers)[4], int count) {
    struct sky_join least = {0, 1};
    float least_cost = INFINITY;
    for (int i = 0; i < count; i++)
        for (int k = i + 1; k < count; k++) {
            float cost = cost_of_joining(powers[i], powers[k]);
            if (cost < least_cost) {
                least_cost = cost;
                least = (struct sky_join){i, k};
            }
        }
    return least;
}

/* By even weights, so that joins stay as weights change. */
void environment_lights_find_joins(struct environment_lights *lights) {
    float powers[ENVIRONMENT_LIGHTS_MAX][4];
    for (int i = 0; i < lights->count; i++)
        weighted_power(&lights->items[i], 1, powers[i]);
    for (int k = 0, count = lights->count; count > 1; k++) {
        struct sky_join join = find_join(powers, count--);
        glm_vec4_add(powers[join.to], powers[join.from], powers[join.to]);
        glm_vec4_copy(powers[count], powers[join.from]);
        lights->joins[k] = join;
    }
}

/* --- groups ----------------------------------------------------------------------------------- */

static void join(struct sky_groups *groups, int light_count, struct sky_join pair) {
    int last = --groups->count;
    for (int i = 0; i < light_count; i++) {
        if (groups->of[i] == pair.from)
            groups->of[i] = pair.to;
        if (groups->of[i] == last)
            groups->of[i] = pair.from;
    }
}

void environment_lights_group(struct sky_groups *groups, const struct environment_lights *lights,
                              int count) {
    *groups = (struct sky_groups){.count = lights->count};
    for (int i = 0; i < lights->count; i++) {
        groups->of[i] = i;
        groups->weights[i] = 1;
    }
    for (int k = 0; groups->count > count; k++)
        join(groups, lights->count, lights->joins[k]);
}

/* Pairs of lights and pairs: number i is light i, number count + k the k-th pair. */
struct tree {
    int pairs[ENVIRONMENT_LIGHTS_MAX][2];
    float powers[2 * ENVIRONMENT_LIGHTS_MAX][4];
    float costs[2 * ENVIRONMENT_LIGHTS_MAX]; /* of all joining in it */
    int light_count;
};

static void build_tree(struct tree *tree, const struct environment_lights *lights) {
    int numbers[ENVIRONMENT_LIGHTS_MAX]; /* of each group, in the tree */
    tree->light_count = lights->count;
    for (int i = 0; i < lights->count; i++)
        numbers[i] = i;
    for (int k = 0; k < lights->count - 1; k++) {
        struct sky_join pair = lights->joins[k];
        tree->pairs[k][0] = numbers[pair.to];
        tree->pairs[k][1] = numbers[pair.from];
        numbers[pair.to] = lights->count + k;
        numbers[pair.from] = numbers[lights->count - 1 - k];
    }
}

static void weigh_tree(struct tree *tree, const struct environment_lights *lights,
                       const float weights[]) {
    for (int i = 0; i < lights->count; i++) {
        weighted_power(&lights->items[i], weights[i], tree->powers[i]);
        tree->costs[i] = 0;
    }
    for (int k = 0; k < lights->count - 1; k++) {
        int a = tree->pairs[k][0], b = tree->pairs[k][1], whole = lights->count + k;
        glm_vec4_add(tree->powers[a], tree->powers[b], tree->powers[whole]);
        tree->costs[whole] =
            tree->costs[a] + tree->costs[b] + cost_of_joining(tree->powers[a], tree->powers[b]);
    }
}

static void put_in_group(struct sky_groups *groups, const struct tree *tree, int number,
                         int group) {
    if (number < tree->light_count) {
        groups->of[number] = group;
        return;
    }
    const int *pair = tree->pairs[number - tree->light_count];
    put_in_group(groups, tree, pair[0], group);
    put_in_group(groups, tree, pair[1], group);
}

void environment_lights_group_by_weights(struct sky_groups *groups,
                                         const struct environment_lights *lights,
                                         const float weights[], int count) {
    struct tree *tree = mem_alloc(1, sizeof *tree);
    int parts[ENVIRONMENT_LIGHTS_MAX] = {2 * lights->count - 2}, part_count = lights->count > 0;
    build_tree(tree, lights);
    weigh_tree(tree, lights, weights);
    while (part_count > 0 && part_count < count && part_count < lights->count) {
        int widest = 0;
        for (int i = 1; i < part_count; i++)
            if (tree->costs[parts[i]] > tree->costs[parts[widest]])
                widest = i;
        if (parts[widest] < lights->count)
            break;
        const int *pair = tree->pairs[parts[widest] - lights->count];
        parts[part_count++] = pair[1];
        parts[widest] = pair[0];
    }
    *groups = (struct sky_groups){.count = part_count};
    for (int g = 0; g < part_count; g++)
        put_in_group(groups, tree, parts[g], g);
    memcpy(groups->weights, weights, (size_t)lights->count * sizeof *weights);
    free(tree);
}

bool sky_groups_same(const struct sky_groups *a, const struct sky_groups *b) {
    return memcmp(a, b, sizeof *a) == 0;
}

int environment_lights_suns(const struct environment_lights *lights) {
    static const float widest = .01F, least_share = .025F; /* sr */
    float all = 0;
    int suns = 0;
    for (int i = 0; i < lights->count; i++)
        all += environment_light_power(&lights->items[i]);
    while (suns < SKY_SUNS_MAX && suns < lights->count &&
           lights->items[suns].solid_angle < widest &&
           environment_light_power(&lights->items[suns]) >= least_share * all)
        suns++;
    return suns;
}

int environment_lights_bright(const struct environment_lights *lights) {
    static const float contrast = 8;
    float power = 0, area = 4 * GLM_PIf; /* of the lights that are left */
    int bright = 0;
    for (int i = 0; i < lights->count; i++)
        power += environment_light_power(&lights->items[i]);
    for (; bright < lights->count; bright++) {
        const struct environment_light *light = &lights->items[bright];
        float own = environment_light_power(light);
        power -= own;
        area -= light->solid_angle;
        if (own * area <= contrast * fmaxf(power, 0) * light->solid_angle)
            break;
    }
    return bright;
}

static struct emitter towards(const float direction[3]) {
    struct emitter emitter = {.type = EMITTER_DIRECTIONAL, .number = -1};
    vec3 away;
    glm_vec3_negate_to((float *)direction, away);
    emitter_aim(&emitter, away);
    return emitter;
}

static void add_light(const struct environment_light *light, float scale, struct emitter *emitter) {
    vec3 vector;
    environment_light_vector(light, vector);
    glm_vec3_muladds((float *)light->radiance, scale * glm_vec3_norm(vector), emitter->intensity);
}

/* Of a group's lights, how much power they have by their weights, and by the squares of these. */
struct weighted {
    float once, twice;
};

static struct weighted weighted_sums(const struct environment_lights *lights,
                                     const struct sky_groups *groups, int group) {
    struct weighted power = {0, 0};
    for (int i = 0; i < lights->count; i++)
        if (groups->of[i] == group) {
            float weight = groups->weights[i];
            power.once += weight * environment_light_power(&lights->items[i]);
            power.twice += weight * weight * environment_light_power(&lights->items[i]);
        }
    return power;
}

/* The mean weight of the power that is drawn. */
static float group_weight(const struct environment_lights *lights, const struct sky_groups *groups,
                          int group) {
    struct weighted power = weighted_sums(lights, groups, group);
    return power.once > 0 ? power.twice / power.once : 1;
}

/* All light that passes by the weights passes by the mean weight, too. */
struct emitter sky_group_emitter(const struct environment_lights *lights,
                                 const struct sky_groups *groups, int group,
                                 const struct environment *sky) {
    vec3 power = {0, 0, 0};
    for (int i = 0; i < lights->count; i++)
        if (groups->of[i] == group) {
            struct environment_light light = environment_light_turned(&lights->items[i], sky);
            add_power(&light, groups->weights[i], power);
        }
    struct emitter emitter = towards(power);
    float scale = sky->strength / group_weight(lights, groups, group);
    for (int i = 0; i < lights->count; i++)
        if (groups->of[i] == group)
            add_light(&lights->items[i], scale * groups->weights[i], &emitter);
    return emitter;
}

/* One of its lights, as often as it has weighted power, stands for all. */
static float share_of(const struct environment_lights *lights, const struct sky_groups *groups,
                      int light) {
    return groups->weights[light] * environment_light_power(&lights->items[light]);
}

struct emitter sky_group_piece(const struct environment_lights *lights,
                               const struct sky_groups *groups, int group,
                               const struct environment *sky, const float place[2]) {
    float all = 0, before = 0;
    for (int i = 0; i < lights->count; i++)
        all += groups->of[i] == group ? share_of(lights, groups, i) : 0;
    int chosen = -1;
    float share = 0, within = 0;
    for (int i = 0; i < lights->count && (chosen < 0 || before <= place[0] * all); i++)
        if (groups->of[i] == group) {
            chosen = i;
            share = share_of(lights, groups, i) / all;
            within = (place[0] * all - before) / (share * all);
            before += share * all;
        }
    struct environment_light light = environment_light_turned(&lights->items[chosen], sky);
    vec3 direction;
    environment_light_direction(&light, (float[]){glm_clamp(within, 0, 1), place[1]}, direction);
    struct emitter emitter = towards(direction);
    add_light(&light, 1 / share, &emitter);
    return emitter;
}

/* --- points of lights ------------------------------------------------------------------------- */

/* Where the light's corners are on a plane across the axis, at distance 1, and their middle. */
static void project_corners(const struct environment_light *light, const struct emitter *axis,
                            float places[4][2], float middle[2]) {
    middle[0] = middle[1] = 0;
    for (int i = 0; i < 4; i++) {
        float *corner = (float *)light->corners[i];
        float along = -glm_vec3_dot(corner, (float *)axis->direction);
        places[i][0] = glm_vec3_dot(corner, (float *)axis->right) / along;
        places[i][1] = glm_vec3_dot(corner, (float *)axis->up) / along;
        middle[0] += places[i][0] / 4;
        middle[1] += places[i][1] / 4;
    }
}

/* Looks along the light so that what its corners are on a plane across has its middle on
 * the axis. */
static struct emitter axis_of(const struct environment_light *light, float places[4][2]) {
    vec3 vector;
    float middle[2];
    environment_light_vector(light, vector);
    struct emitter axis = towards(vector);
    for (int step = 0; step < 4; step++) {
        vec3 moved;
        project_corners(light, &axis, places, middle);
        glm_vec3_copy(axis.direction, moved);
        glm_vec3_muladds(axis.right, -middle[0], moved);
        glm_vec3_muladds(axis.up, -middle[1], moved);
        emitter_aim(&axis, moved);
    }
    project_corners(light, &axis, places, middle);
    return axis;
}

static struct sky_source source_of(const struct environment_light *light) {
    float places[4][2];
    struct emitter axis = axis_of(light, places);
    struct sky_source source = {
        .luminance =
            .2126F * light->radiance[0] + .7152F * light->radiance[1] + .0722F * light->radiance[2],
    };
    for (int i = 0; i < 4; i++)
        glm_vec3_copy((float *)light->corners[i], source.corners[i]);
    environment_light_vector(light, source.vector);
    glm_vec3_copy((float *)light->radiance, source.radiance);
    glm_vec3_negate_to(axis.direction, source.middle);
    for (int c = 0; c < 2; c++) {
        const float *across = c == 0 ? axis.right : axis.up;
        float x = (places[1][c] - places[0][c] + places[2][c] - places[3][c]) / 4,
              y = (places[3][c] - places[0][c] + places[2][c] - places[1][c]) / 4;
        glm_vec3_muladds((float *)across, x, source.side_x);
        glm_vec3_muladds((float *)across, y, source.side_y);
    }
    return source;
}

void sky_block_of(struct sky_block *block, const struct environment_lights *lights,
                  const struct environment *sky) {
    for (int i = 0; i < lights->count; i++) {
        struct environment_light light = environment_light_turned(&lights->items[i], sky);
        block->sources[i] = source_of(&light);
    }
}
