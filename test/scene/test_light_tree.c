/* The light tree beside sums over all lights, and the bounds of lights beside integrals. */
#include "support.h"

#include "base/unit.h"
#include "scene/lights/light_tree.h"
#include "shared/light_tree.h"

static uint32_t random_state;

static float next(float low, float high) {
    random_state = random_state * 1664525u + 1013904223u;
    return low + (high - low) * (float)(random_state >> 8) / (float)(1 << 24);
}

static void next_direction(float direction[3]) {
    float height = next(-1, 1), turn = next(0, 2 * GLM_PIf), across = sqrtf(1 - height * height);
    glm_vec3_copy((vec3){across * cosf(turn), across * sinf(turn), height}, direction);
}

/* One of each kind: point, sphere, spot, wide spot with a range, rectangle, disk, sun, wide sun. */
static struct emitter next_light(int kind) {
    static const enum emitter_type types[] = {
        EMITTER_POINT, EMITTER_POINT, EMITTER_SPOT,        EMITTER_SPOT,       EMITTER_AREA,
        EMITTER_AREA,  EMITTER_POINT, EMITTER_DIRECTIONAL, EMITTER_DIRECTIONAL};
    struct emitter light = emitter_new(types[kind % 9]);
    vec3 axis;
    next_direction(axis);
    emitter_aim(&light, axis);
    for (int c = 0; c < 3; c++) {
        light.position[c] = next(-5, 5);
        light.intensity[c] =
            expf(next(-3, 3)) * (types[kind % 9] == EMITTER_DIRECTIONAL ? .01F : 1);
    }
    light.range = kind % 9 == 3 ? 6 : 0;
    light.cos_outer = kind % 9 == 2 ? .9F : 0;
    light.cos_inner = kind % 9 == 2 ? .95F : .3F;
    light.size[0] = kind % 2 ? .4F : 0;
    light.size[1] = kind % 9 == 4 ? (light.size[0] = .3F, .8F) : 0;
    return light;
}

struct lights {
    struct emitter *items;
    struct light_bounds *bounds;
    int count;
    struct light_tree tree;
};

static void build(struct lights *lights) {
    lights->bounds = mem_alloc((size_t)lights->count, sizeof *lights->bounds);
    for (int i = 0; i < lights->count; i++)
        lights->bounds[i] = light_bounds_of(&lights->items[i]);
    light_tree_init(&lights->tree, lights->bounds, lights->count);
}

/* kind -1: of all kinds in turn. */
static struct lights make_lights(int count, int kind) {
    struct lights lights = {.items = mem_alloc((size_t)count, sizeof *lights.items)};
    lights.count = count;
    random_state = 7;
    for (int i = 0; i < count; i++)
        lights.items[i] = next_light(kind < 0 ? i : kind);
    build(&lights);
    return lights;
}

static void free_lights(struct lights *lights) {
    light_tree_free(&lights->tree);
    mem_free(lights->items, lights->bounds);
}

struct place {
    vec3 position, normal;
};

static struct place next_place(void) {
    struct place place = {{next(-6, 6), next(-6, 6), next(-6, 6)}, {0, 0, 0}};
    next_direction(place.normal);
    return place;
}

/* Irradiance of one of the light's places, mean of RGB. */
static double irradiance(const struct emitter *light, const struct place *at) {
    struct emitter piece = emitter_piece(light, (float[]){next(0, 1), next(0, 1)});
    float mean = (piece.intensity[0] + piece.intensity[1] + piece.intensity[2]) / 3;
    vec3 to;
    glm_vec3_negate_to(piece.direction, to);
    float distance = 1, cos_axis = 1;
    if (piece.type != EMITTER_DIRECTIONAL) {
        glm_vec3_sub(piece.position, (float *)at->position, to);
        distance = glm_vec3_norm(to);
        cos_axis = -glm_vec3_dot(piece.direction, to) / distance;
    }
    float cosine = fmaxf(glm_vec3_dot((float *)at->normal, to) / distance, 0);
    return (double)(mean * cosine * emitter_cone(&piece, cos_axis) *
                    emitter_in_range(&piece, distance) / (distance * distance));
}

static float probability(const struct lights *lights, const struct place *at, int light) {
    return light_tree_probability(&lights->tree, at->position, at->normal, light);
}

/* --- bounds ----------------------------------------------------------------------------------- */

/* Of the falloff over all directions, with the cosine beyond the cone. */
TEST(orientation) {
    enum { STEPS = 20000 };
    const float cones[][2] = {{0, GLM_PI_2f}, {.5F, .3F}, {1.2F, GLM_PI_2f}, {2.5F, GLM_PI_2f}};
    for (int i = 0; i < 4; i++) {
        struct light_bounds bounds = {.theta_o = cones[i][0], .theta_e = cones[i][1]};
        double sum = 0, end = fmin((double)(cones[i][0] + cones[i][1]), GLM_PI);
        for (int k = 0; k < STEPS; k++) {
            double angle = (k + .5) / STEPS * end;
            sum +=
                2 * GLM_PI * cos(fmax(angle - (double)cones[i][0], 0)) * sin(angle) * end / STEPS;
        }
        check_near("M_O", (double)light_bounds_orientation(&bounds), sum, 1e-5 * sum);
    }
    struct light_bounds lambert = {.theta_e = GLM_PI_2f}, point = {.theta_o = GLM_PIf};
    check_near("a surface", (double)light_bounds_orientation(&lambert), GLM_PI, 1e-5);
    check_near("a point", (double)light_bounds_orientation(&point), 4 * GLM_PI, 1e-5);
}

/* A cone of two holds both and is no wider than needed; a dark light counts nothing. */
TEST(merged_cones) {
    random_state = 3;
    double outside = 0, spare = 0;
    for (int i = 0; i < 2000; i++) {
        struct light_bounds part[2] = {{.power = 1, .theta_o = next(0, 1)},
                                       {.power = 2, .theta_o = next(0, 1)}};
        next_direction(part[0].axis);
        next_direction(part[1].axis);
        struct light_bounds sum = light_bounds_merge(&part[0], &part[1]);
        double reach[2];
        for (int k = 0; k < 2; k++) {
            reach[k] = acos((double)glm_clamp(glm_vec3_dot(sum.axis, part[k].axis), -1, 1)) +
                       (double)part[k].theta_o;
            outside = fmax(outside, fmin(reach[k], GLM_PI) - (double)sum.theta_o);
        }
        if (sum.theta_o < GLM_PIf)
            spare = fmax(spare, (double)sum.theta_o - fmax(reach[0], reach[1]));
    }
    check_at_most("a cone outside, radians", outside, 1e-3);
    check_at_most("cones wider than needed, radians", spare, 1e-3);
    struct light_bounds lit = {.power = 1, .high = {1, 1, 1}}, dark = {.low = {-9, 0, 0}};
    struct light_bounds sum = light_bounds_merge(&dark, &lit);
    assert_memory_equal(&sum, &lit, sizeof sum);
}

/* --- probabilities ---------------------------------------------------------------------------- */

/* Writes the probabilities of all lights below a node, and returns that of no light there. */
static double walk(const struct light_node *nodes, int node, const struct place *at, double all,
                   double *of_lights) {
    int link = nodes[node].link;
    if (link < 0) {
        of_lights[-1 - link] = all;
        return 0;
    }
    double first = (double)light_node_importance(&nodes[link], at->position, at->normal);
    double second = (double)light_node_importance(&nodes[link + 1], at->position, at->normal);
    if (first + second == 0)
        return all;
    return walk(nodes, link, at, all * first / (first + second), of_lights) +
           walk(nodes, link + 1, at, all * second / (first + second), of_lights);
}

/* They sum to 1 with that of no light; and each light that arrives has some. */
TEST(sum) {
    enum { MOST = 1093 };
    for (int count = 1; count <= MOST; count = 3 * count + 1) {
        struct lights lights = make_lights(count, -1);
        double worst = 0, apart = 0;
        for (int i = 0; i < 60; i++) {
            struct place at = next_place();
            double of_lights[MOST] = {0}, sum = walk(lights.tree.nodes, 0, &at, 1, of_lights);
            for (int n = 0; n < count; n++) {
                double p = (double)probability(&lights, &at, n);
                sum += p;
                apart = fmax(apart, fabs(p - of_lights[n]));
                if (irradiance(&lights.items[n], &at) > 0)
                    assert_true(p > 0);
            }
            worst = fmax(worst, fabs(sum - 1));
        }
        check_at_most("sum beside 1", worst, 1e-5);
        check_at_most("a probability beside a walk's", apart, 1e-5);
        free_lights(&lights);
    }
}

/* Even numbers find each light as often as its probability says, and their mean is the sum. */
TEST(samples) {
    enum { COUNT = 500, SAMPLES = 1 << 18 };
    struct lights lights = make_lights(COUNT, -1);
    for (int i = 0; i < 6; i++) {
        struct place at = next_place();
        double light[COUNT], sum = 0, mean = 0, worst = 0;
        int found[COUNT] = {0};
        for (int n = 0; n < COUNT; n++)
            sum += light[n] = irradiance(&lights.items[n], &at);
        for (int k = 0; k < SAMPLES; k++) {
            float p;
            int n = light_tree_sample(&lights.tree, at.position, at.normal,
                                      ((float)k + .5F) / SAMPLES, &p);
            if (n < 0)
                continue;
            found[n]++;
            mean += light[n] / (double)p / SAMPLES;
        }
        for (int n = 0; n < COUNT; n++)
            worst = fmax(worst, fabs(found[n] - SAMPLES * (double)probability(&lights, &at, n)));
        check_at_most("samples of a light beside its probability", worst, 4);
        check_near("mean over the sum", mean / sum, 1, 3e-3);
    }
    free_lights(&lights);
}

/* One point's irradiance is known, so that equal lights in one place have no noise at all. */
TEST(equal_lights) {
    enum { COUNT = 1000 };
    struct lights lights = {mem_alloc(COUNT, sizeof *lights.items), NULL, COUNT, {0}};
    struct place at = {{0, 0, 0}, {0, 1, 0}};
    for (int i = 0; i < COUNT; i++) {
        lights.items[i] = emitter_new(EMITTER_POINT);
        glm_vec3_copy((vec3){1, 2, 0}, lights.items[i].position);
    }
    build(&lights);
    double one = irradiance(&lights.items[0], &at), worst = 0;
    for (int k = 0; k < 100; k++) {
        float p;
        int n = light_tree_sample(&lights.tree, at.position, at.normal, (float)k / 100, &p);
        worst =
            fmax(worst, fabs(irradiance(&lights.items[n], &at) / (double)p / (COUNT * one) - 1));
    }
    check_at_most("error of one of 1,000 lights in one place", worst, 1e-4);
    free_lights(&lights);
}

/* Another order, and dark lights between: each has the probability that it had. */
TEST(order) {
    enum { COUNT = 800 };
    struct lights lights = make_lights(COUNT, -1), turned = {.count = 2 * COUNT};
    turned.items = mem_alloc(2 * COUNT, sizeof *turned.items);
    for (int i = 0; i < 2 * COUNT; i++) {
        turned.items[i] = lights.items[i / 2 * 7 % COUNT];
        if (i % 2)
            memset(turned.items[i].intensity, 0, sizeof turned.items[i].intensity);
    }
    build(&turned);
    assert_int_equal(turned.tree.node_count, lights.tree.node_count);
    double worst = 0;
    for (int k = 0; k < 10; k++) {
        struct place at = next_place();
        for (int i = 0; i < COUNT; i++) {
            double before = (double)probability(&lights, &at, i * 7 % COUNT);
            double after = (double)probability(&turned, &at, 2 * i);
            worst = fmax(worst, fabs(after - before) / (before + 1e-9));
            assert_true(probability(&turned, &at, 2 * i + 1) == 0);
        }
    }
    check_at_most("change of probability by order", worst, 1e-3);
    free_lights(&turned);
    free_lights(&lights);
}

/* Behind the surface, out of range, and none at all. */
TEST(no_light) {
    struct light_tree none;
    float p, up[3] = {0, 1, 0}, above[3] = {0, 10, 0}, far[3] = {0, -200, 0};
    light_tree_init(&none, NULL, 0);
    assert_int_equal(light_tree_sample(&none, above, up, .5F, &p), -1);
    light_tree_free(&none);
    struct lights points = make_lights(300, 0), ranged = make_lights(300, 3);
    for (int k = 0; k < 20; k++) {
        float random = (float)k / 20;
        assert_int_equal(light_tree_sample(&points.tree, above, up, random, &p), -1);
        assert_true(light_tree_sample(&points.tree, far, up, random, &p) >= 0);
        assert_int_equal(light_tree_sample(&ranged.tree, far, up, random, &p), -1);
    }
    free_lights(&points);
    free_lights(&ranged);
}

/* Many points: each is a leaf, and all are found. So is one a million times brighter. */
TEST(many) {
    enum { COUNT = 100000 };
    struct lights lights = make_lights(COUNT, 0);
    struct place at = {{1, 2, 3}, {0, 0, 0}};
    double sum = 0;
    for (int i = 0; i < COUNT; i++) {
        const struct light_node *leaf = &lights.tree.nodes[lights.tree.leaves[i]];
        assert_int_equal(leaf->link, -1 - i);
        sum += (double)probability(&lights, &at, i);
    }
    check_near("sum of 100,000", sum, 1, 1e-3);
    lights.bounds[0].power *= 1e9F;
    assert_true(light_tree_refit(&lights.tree, lights.bounds));
    check_near("of the brightest", (double)probability(&lights, &at, 0), 1, 1e-2);
    free_lights(&lights);
}

/* A tree of moved lights samples them as they are; one of the same lights keeps its bits. */
TEST(refit) {
    enum { COUNT = 400 };
    struct lights lights = make_lights(COUNT, -1);
    size_t bytes = (size_t)lights.tree.node_count * sizeof *lights.tree.nodes;
    void *before = mem_alloc(1, bytes);
    memcpy(before, lights.tree.nodes, bytes);
    assert_true(light_tree_refit(&lights.tree, lights.bounds));
    assert_memory_equal(lights.tree.nodes, before, bytes);
    for (int i = 0; i < COUNT; i++) {
        lights.items[i] = next_light(i);
        if (i % 5 == 0)
            memset(lights.items[i].intensity, 0, sizeof lights.items[i].intensity);
        lights.bounds[i] = light_bounds_of(&lights.items[i]);
    }
    assert_true(light_tree_refit(&lights.tree, lights.bounds));
    for (int k = 0; k < 20; k++) {
        struct place at = next_place();
        double sum = 0;
        for (int n = 0; n < COUNT; n++) {
            double p = (double)probability(&lights, &at, n);
            sum += p;
            assert_true(irradiance(&lights.items[n], &at) > 0 ? p > 0 : n % 5 || p == 0);
        }
        check_at_most("sum after moves", sum, 1 + 1e-4);
    }
    light_tree_free(&lights.tree);
    light_tree_init(&lights.tree, lights.bounds, COUNT);
    lights.bounds[0].power = 1; /* was dark */
    assert_false(light_tree_refit(&lights.tree, lights.bounds));
    free(before);
    free_lights(&lights);
}

RUN_TESTS(NULL, NULL)
