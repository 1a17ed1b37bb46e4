/* Lights that the path tracer samples by the tree, beside the same light of few. */
#include "hand_made.h"

#include "reference/scene/emission.h"
#include "scene/lights/emitter.h"

#include <assert.h>

enum { COUNT = 40, DARK = 30 };
static_assert(COUNT <= (int)LIGHTS_ALL_MAX && COUNT + DARK > (int)LIGHTS_ALL_MAX, "");

static uint32_t random_state;

static float next(float low, float high) {
    random_state = random_state * 1664525u + 1013904223u;
    return low + (high - low) * (float)(random_state >> 8) / (float)(1 << 24);
}

/* A floor and a wall, metal on request, and a screen between. */
static void start_corner(struct world *world, bool metal) {
    world_init(world);
    add_rectangle(world, 0, at(0, 0, 1), at(1, 0, 0), at(0, 0, -1));
    add_rectangle(world, 0, at(0, 0, 1), at(0, 0, -1), at(0, 1.5F, 0));
    add_rectangle(world, 1, at(.2F, .3F, .8F), at(.3F, 0, 0), at(0, 0, -.3F));
    world_finish(world);
    look_down(world, .1F, .1F, .8F, .29F);
    world->materials[0].metalness = metal;
    world->materials[0].roughness = .3F;
}

static struct path_tracer_desc describe_lights(struct world *world, struct emitter *lights,
                                               int count) {
    struct path_tracer_desc desc = describe(world, 8, is_long_run() ? 2048 : 64);
    desc.emitters = (struct emitters){.items = lights, .count = count};
    desc.bounces = 1;
    desc.seen = true;
    return desc;
}

/* Indirect light has most of the noise, and is part of some sums. */
static void check_means(const struct image *few, const struct image *many) {
    assert_int_equal(few->channel_count, many->channel_count);
    for (int c = 0; c < few->channel_count; c++) {
        const char *name = few->names[c];
        bool is_sum = strlen(name) == 1 || strncmp(name, "specular", 8) == 0;
        double tolerance = is_sum || strncmp(name, "indirect", 8) == 0 ? .15 : .012;
        if (!strstr(name, "error") && mean_of(few, c) != 0)
            check_near(name, mean_of(many, c) / mean_of(few, c), 1,
                       is_long_run() ? tolerance / 6 : tolerance);
    }
}

/* Points, spheres, spots of which some have a range, rectangles, and suns of two sizes. */
static struct emitter next_light(int i) {
    static const enum emitter_type types[] = {EMITTER_POINT, EMITTER_POINT, EMITTER_SPOT,
                                              EMITTER_SPOT,  EMITTER_AREA,  EMITTER_DIRECTIONAL};
    static const float powers[] = {1, 1, 3, 5, 3, .05F};
    struct emitter light = emitter_new(types[i % 6]);
    emitter_aim(&light, (float[]){next(-1, 1), -1, next(-1, 1)});
    for (int c = 0; c < 3; c++) {
        light.position[c] = next(c == 1 ? .4F : .2F, c == 1 ? 1.4F : .9F);
        light.intensity[c] = powers[i % 6] * next(.1F, 1);
    }
    light.cos_inner = .9F;
    light.range = i % 6 == 3 ? 1 : 0;
    light.size[0] = i % 6 == 1 ? .1F : i % 6 == 4 ? .2F : i % 12 == 11 ? .2F : 0;
    light.size[1] = i % 6 == 4 ? .1F : 0;
    return light;
}

/* Dark lights make many of few. */
static void compare_with_dark(bool metal, bool medium) {
    OWNED(world) world;
    struct emitter lights[COUNT + DARK];
    OWNED(image) few, many;
    random_state = 11;
    for (int i = 0; i < COUNT + DARK; i++) {
        lights[i] = next_light(i);
        if (i >= COUNT)
            memset(lights[i].intensity, 0, sizeof lights[i].intensity);
    }
    start_corner(&world, metal);
    struct path_tracer_desc desc = describe_lights(&world, lights, COUNT);
    for (int c = 0; c < 3 && medium; c++)
        desc.medium.scattering[c] = 1;
    render(&desc, &few);
    desc.emitters.count = COUNT + DARK;
    struct path_tracer_progress reached = render(&desc, &many);
    check_at_most("no noise told", reached.noise == 0, 0);
    check_means(&few, &many);
}

TEST(metal) {
    compare_with_dark(true, false);
}

TEST(medium) {
    compare_with_dark(false, true);
}

/* Equal lights in one place are one, and their direct light has no noise at all. */
TEST(one_place) {
    enum { LIGHTS = 200 };
    OWNED(world) world;
    struct emitter lights[LIGHTS];
    OWNED(image) image;
    world_in_sphere(&world);
    for (int i = 0; i < LIGHTS; i++) {
        lights[i] = world.light;
        glm_vec3_divs(lights[i].intensity, LIGHTS, lights[i].intensity);
    }
    struct path_tracer_desc desc = describe_lights(&world, lights, LIGHTS);
    render(&desc, &image);
    check_at_most("spread of direct", spread_about(&image, CHANNEL_DIRECT, 1), 3e-3);
    check_near("indirect", mean_of(&image, CHANNEL_INDIRECT), .5, 2.5e-3);
}

/* A rectangle cut into tiles, and a wide sun into layers, over metal: found by rays, too. */
static void compare_parts(struct emitter whole, int across) {
    OWNED(world) world;
    struct emitter lights[400];
    OWNED(image) one, many;
    int count = across * across;
    start_corner(&world, true);
    for (int i = 0; i < count; i++) {
        lights[i] = whole;
        glm_vec3_divs(lights[i].intensity, (float)count, lights[i].intensity);
        if (whole.type != EMITTER_AREA)
            continue;
        for (int k = 0; k < 2; k++)
            lights[i].size[k] /= (float)across;
        float part[2] = {(float)(i % across), (float)(i / across)},
              middle = (float)across / 2 - .5F;
        glm_vec3_muladds(whole.right, (part[0] - middle) * lights[i].size[0], lights[i].position);
        glm_vec3_muladds(whole.up, (part[1] - middle) * lights[i].size[1], lights[i].position);
    }
    struct path_tracer_desc desc = describe_lights(&world, &whole, 1);
    render(&desc, &one);
    desc = describe_lights(&world, lights, count);
    render(&desc, &many);
    check_means(&one, &many);
}

TEST(parts) {
    struct emitter area = emitter_new(EMITTER_AREA), sun = emitter_new(EMITTER_DIRECTIONAL);
    glm_vec3_copy((vec3){.6F, 1, .5F}, area.position);
    area.size[0] = .6F;
    area.size[1] = .4F;
    compare_parts(area, 20);
    sun.size[0] = .5F;
    emitter_aim(&sun, (float[]){-1, -1, 0});
    compare_parts(sun, 10);
}

RUN_TESTS(NULL, NULL)
