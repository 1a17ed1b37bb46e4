/* Light of the sky in the path tracer, beside closed forms: evenly bright, of one texel, behind a wall. */
#include "hand_made.h"

#include "reference/alias.h"
#include "scene/environment.h"

#include <stdio.h>

/* --- picking ---------------------------------------------------------------------------------- */

/* Evenly spaced numbers pick each as often as it weighs, and leave numbers that are even again. */
static void test_alias(void **state) {
    (void)state;
    enum { COUNT = 7, PICKS = 1 << 20 };
    static const double weights[COUNT] = {3, 0, .001, 1, 8, 0, 1.999};
    struct alias alias;
    double picked[COUNT] = {0}, left[COUNT] = {0};
    alias_init(&alias, weights, COUNT);
    for (int i = 0; i < PICKS; i++) {
        float number = ((float)i + .5F) / PICKS;
        int pick = alias_pick(&alias, &number);
        assert_true(number >= 0 && number < 1);
        picked[pick]++;
        left[pick] += (double)number;
    }
    for (int i = 0; i < COUNT; i++) {
        check_near("picked of 2^20", picked[i], weights[i] / 14 * PICKS, 2);
        if (weights[i] > .1)
            check_near("mean of what is left", left[i] / picked[i], .5, 1e-3);
    }
    alias_free(&alias);
}

/* --- skies ------------------------------------------------------------------------------------ */

static struct environment even_sky(int width, float radiance) {
    struct environment sky = {.width = width, .height = width / 2, .strength = 1};
    size_t count = (size_t)width * (size_t)width / 2;
    sky.texels = mem_alloc(count, sizeof *sky.texels);
    for (size_t i = 0; i < count; i++)
        sky.texels[i][0] = sky.texels[i][1] = sky.texels[i][2] = radiance;
    return sky;
}

/* Black but for one texel, of R, G, B as 1 to 2 to 4. */
static struct environment dotted_sky(int width, int x, int y, float radiance) {
    struct environment sky = even_sky(width, 0);
    for (int c = 0; c < 3; c++)
        sky.texels[y * width + x][c] = radiance * (float)(1 << c);
    return sky;
}

static struct path_tracer_desc under(struct world *world, const struct environment *sky, int size,
                                     int samples) {
    struct path_tracer_desc desc = describe(world, size, samples);
    desc.emitters = (struct emitters){.items = NULL, .count = 0, .sky = sky};
    return desc;
}

static vec3s at(float x, float y, float z) {
    return (vec3s){{x, y, z}};
}

/* The outside of a cube of edge 2 around the origin. */
static void add_cube(struct world *world) {
    add_rectangle(world, 0, at(-1, -1, 1), at(2, 0, 0), at(0, 2, 0));
    add_rectangle(world, 0, at(1, -1, -1), at(-2, 0, 0), at(0, 2, 0));
    add_rectangle(world, 0, at(1, -1, 1), at(0, 0, -2), at(0, 2, 0));
    add_rectangle(world, 0, at(-1, -1, -1), at(0, 0, 2), at(0, 2, 0));
    add_rectangle(world, 0, at(-1, 1, 1), at(2, 0, 0), at(0, 0, -2));
    add_rectangle(world, 0, at(-1, -1, -1), at(2, 0, 0), at(0, 0, 2));
}

static void look_at_corner(struct world *world, float far) {
    world->camera = (struct camera){.eye = {far, far, far}, .fov_y = .4F};
    camera_look(&world->camera, world->camera.eye, (float[]){-1, -1, -1}, (float[]){0, 1, 0});
}

/* E = pi on a convex body; and nothing indirect. */
static void test_even_on_convex(void **state) {
    (void)state;
    struct world world;
    struct environment sky = even_sky(32, 1);
    struct image image;
    world_init(&world);
    add_cube(&world);
    world_finish(&world);
    look_at_corner(&world, 2);
    struct path_tracer_desc desc = under(&world, &sky, 24, 64);
    desc.bounces = 2;
    render(&desc, &image);
    check_near("covered", mean_of(&image, CHANNEL_ALPHA), 1, 0);
    check_near("direct", mean_of(&image, CHANNEL_DIRECT), 1, 1e-3);
    check_near("its spread", spread_about(&image, CHANNEL_DIRECT, 1), 0, .02);
    check_near("indirect", mean_of(&image, CHANNEL_INDIRECT), 0, 0);
    image_free(&image);
    free(sky.texels);
    world_free(&world);
}

/* Where all is white and nothing absorbs, all is as bright as the sky: a room without two walls, in which
 * light comes by every way of the tracer. */
static void test_furnace(void **state) {
    (void)state;
    struct world world;
    struct environment sky = even_sky(32, 1);
    struct image image;
    world_init(&world);
    world.materials[0].double_sided = true;
    for (int c = 0; c < 3; c++)
        world.materials[0].base_color[c] = 1;
    add_rectangle(&world, 0, at(-1, -1, -1), at(0, 0, 2), at(2, 0, 0));
    add_rectangle(&world, 0, at(-1, -1, -1), at(2, 0, 0), at(0, 2, 0));
    add_rectangle(&world, 0, at(-1, -1, -1), at(0, 2, 0), at(0, 0, 2));
    add_rectangle(&world, 0, at(-1, 1, -1), at(2, 0, 0), at(0, 0, 2));
    world_finish(&world);
    world.camera = (struct camera){.eye = {.9F, 0, .9F}, .fov_y = 1};
    camera_look(&world.camera, world.camera.eye, (float[]){-1, -.2F, -1}, (float[]){0, 1, 0});
    struct path_tracer_desc desc = under(&world, &sky, 16, 512);
    desc.bounces = 100;
    render(&desc, &image);
    check_near("radiance", mean_of(&image, CHANNEL_BEAUTY), 1, 4e-3);
    check_at_most("direct light", mean_of(&image, CHANNEL_DIRECT), .6);
    image_free(&image);
    free(sky.texels);
    world_free(&world);
}

/* A floor, and a wall at x = 0. */
static void make_wall(struct world *world, float height, float length) {
    world_init(world);
    add_rectangle(world, 0, at(0, 0, length), at(length, 0, 0), at(0, 0, -2 * length));
    add_rectangle(world, 0, at(0, 0, -length), at(0, height, 0), at(0, 0, 2 * length));
    world_finish(world);
}

/* Half a wide sky lies behind an endless wall: E = pi (1 + cos phi) / 2, tan phi = height / x. */
static void test_wall(void **state) {
    (void)state;
    struct world world;
    struct environment sky = even_sky(32, 2);
    struct image image;
    make_wall(&world, 1, 200);
    for (int i = 1; i <= 4; i *= 2) {
        float x = .5F * (float)i;
        look_down(&world, x - .005F, 0, .01F, 50);
        struct path_tracer_desc desc = under(&world, &sky, 8, 256);
        render(&desc, &image);
        double expected = 1 + cos(atan(1 / (double)x));
        check_near("direct", mean_of(&image, CHANNEL_DIRECT), expected, 4e-3 * expected);
        image_free(&image);
    }
    free(sky.texels);
    world_free(&world);
}

/* A sky that is turned is a scene that is turned the other way: bright on one side only. */
static void test_turn(void **state) {
    (void)state;
    struct world world;
    struct environment sky = even_sky(32, 0);
    struct image image;
    for (int y = 0; y < 16; y++)
        for (int x = 24; x < 32; x++) /* from +Z to -X */
            sky.texels[y * 32 + x][0] = 1;
    make_wall(&world, 1, 200);
    look_down(&world, .495F, 0, .01F, 50);
    double got[2];
    for (int i = 0; i < 2; i++) {
        sky.turn = i ? 180 : 0;
        struct path_tracer_desc desc = under(&world, &sky, 8, 256);
        render(&desc, &image);
        got[i] = mean_of(&image, CHANNEL_DIRECT);
        image_free(&image);
    }
    check_near("in the open", got[1], .25, 2e-3);
    check_at_most("behind the wall", got[0], .2);
    free(sky.texels);
    world_free(&world);
}

/* --- one texel -------------------------------------------------------------------------------- */

/* A floor under a plate, both of which shade and light each other. */
static void make_plate(struct world *world) {
    world_init(world);
    world->materials[0].double_sided = true;
    add_rectangle(world, 0, at(-2, 0, 2), at(4, 0, 0), at(0, 0, -4));
    add_rectangle(world, 0, at(-.5F, .5F, .5F), at(1, 0, 0), at(0, 0, -1));
    world_finish(world);
    world->camera = (struct camera){.eye = {0, .15F, 1.6F}, .fov_y = .8F};
    camera_look(&world->camera, world->camera.eye, (float[]){0, .1F, -1}, (float[]){0, 1, 0});
}

/* One bright texel is a directional light of L x solid angle. */
static void test_one_texel(void **state) {
    (void)state;
    enum { SIZE = 32, X = 700, Y = 130 };
    struct world world;
    struct environment sky = dotted_sky(1024, X, Y, 1e5F);
    struct image of_sky, of_sun;
    make_plate(&world);
    struct path_tracer_desc desc = under(&world, &sky, SIZE, 256);
    desc.bounces = 1;
    render(&desc, &of_sky);
    float power = 1e5F * (float)environment_solid_angle(&sky, Y), to_sky[3];
    environment_direction(&sky, X + .5, Y + .5, to_sky);
    place_light(&world, EMITTER_DIRECTIONAL, at(0, 0, 0), at(-to_sky[0], -to_sky[1], -to_sky[2]),
                power);
    desc.emitters = (struct emitters){.items = &world.light, .count = 1};
    for (int c = 0; c < 3; c++)
        world.light.intensity[c] = power * (float)(1 << c);
    render(&desc, &of_sun);
    for (int c = 0; c < 3; c++) {
        double direct = mean_of(&of_sun, CHANNEL_DIRECT + c);
        double indirect = mean_of(&of_sun, CHANNEL_INDIRECT + c);
        check_near("direct", mean_of(&of_sky, CHANNEL_DIRECT + c) / direct, 1, 2e-3);
        check_near("indirect", mean_of(&of_sky, CHANNEL_INDIRECT + c) / indirect, 1, .01);
    }
    double apart = 0, mean = mean_of(&of_sun, CHANNEL_DIRECT);
    for (int i = 0; i < SIZE * SIZE; i++)
        apart += pow((double)image_at(&of_sky, i % SIZE, i / SIZE)[CHANNEL_DIRECT] -
                         (double)image_at(&of_sun, i % SIZE, i / SIZE)[CHANNEL_DIRECT],
                     2);
    check_at_most("direct light apart, over its mean", sqrt(apart) / SIZE / mean, .02);
    image_free(&of_sky);
    image_free(&of_sun);
    free(sky.texels);
    world_free(&world);
}

/* A black sky is seen and lights nothing. */
static void test_black(void **state) {
    (void)state;
    struct world world;
    struct environment sky = even_sky(8, 0);
    struct image image;
    make_plate(&world);
    struct path_tracer_desc desc = under(&world, &sky, 8, 4);
    desc.bounces = 2;
    render(&desc, &image);
    for (int channel = CHANNEL_BEAUTY; channel < CHANNEL_ALPHA; channel++)
        check_near("black", mean_of(&image, channel), 0, 0);
    image_free(&image);
    free(sky.texels);
    world_free(&world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_alias),   cmocka_unit_test(test_even_on_convex),
        cmocka_unit_test(test_furnace), cmocka_unit_test(test_wall),
        cmocka_unit_test(test_turn),    cmocka_unit_test(test_one_texel),
        cmocka_unit_test(test_black),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
