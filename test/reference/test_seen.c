/* The path tracer's layers of what shadows are made of, beside closed forms: the share of a light
 * that a half plane leaves, and the light that there would be without it. */
#include "hand_made.h"

#include "scene/lights/environment.h"

/* A floor, and at height 1/2 all of a half plane that is left of x = 0. */
static void make_edge(struct world *world) {
    world_init(world);
    add_rectangle(world, 0, at(-50, 0, 50), at(100, 0, 0), at(0, 0, -100));
    add_rectangle(world, 0, at(-50, .5F, 50), at(50, 0, 0), at(0, 0, -100));
    world_finish(world);
}

/* Of radiance 1, down from height 1; height 0 is a disk. */
static struct emitter lamp_above(float width, float height) {
    struct emitter light = {.type = EMITTER_AREA, .size = {width, height}, .position = {0, 1, 0}};
    emitter_aim(&light, (float[]){0, -1, 0});
    glm_vec3_broadcast((float)emitter_extent(&light), light.intensity);
    return light;
}

/* What a bit of the floor at x sees, as a picture of few pixels. */
static struct image look(struct world *world, const struct emitters *emitters, float x,
                         int samples) {
    struct image image;
    look_down(world, x - 5e-4F, -5e-4F, 1e-3F, .3F);
    struct path_tracer_desc desc = describe(world, 8, samples);
    desc.emitters = *emitters;
    desc.seen = true;
    render(&desc, &image);
    return image;
}

static void check_share(const char *what, struct emitter light, float x, double expected) {
    OWNED(world) world;
    make_edge(&world);
    OWNED(image) image = look(&world, &(struct emitters){.items = &light, .count = 1}, x, 256);
    printf("  %s, x = %g\n", what, (double)x);
    for (int c = 0; c < 3; c++)
        check_near("visibility", mean_of(&image, CHANNEL_VISIBILITY + c), expected, 2e-3);
}

/* A square's share is clamp(1/2 + x), a disk's 1/2 + (s sqrt(1 - s^2) + asin s) / pi, s = 2 x. */
TEST(half_plane) {
    check_share("square", lamp_above(1, 1), -.6F, 0);
    check_share("square", lamp_above(1, 1), -.25F, .25);
    check_share("square", lamp_above(1, 1), 0, .5);
    check_share("square", lamp_above(1, 1), .4F, .9);
    check_share("square", lamp_above(1, 1), .6F, 1);
    check_share("disk", lamp_above(1, 0), -.25F, .195501);
    check_share("disk", lamp_above(1, 0), .25F, .804499);
}

/* The root of a channel's mean square distance from a value. */
static double spread_of(const struct image *image, int channel, double value) {
    double sum = 0;
    for (int i = 0; i < image->width * image->height; i++) {
        const float *pixel = image_at(image, i % image->width, i / image->width);
        sum += pow((double)pixel[channel] - value, 2);
    }
    return sqrt(sum / (image->width * image->height));
}

/* How far the pixels' shares are off the closed form is what their standard errors tell; of direct
 * light likewise. */
TEST(noise) {
    OWNED(world) world;
    struct emitter light = lamp_above(1, 1);
    make_edge(&world);
    OWNED(image) image = look(&world, &(struct emitters){.items = &light, .count = 1}, .1F, 32);
    double off = spread_of(&image, CHANNEL_VISIBILITY, .6);
    double estimated = spread_of(&image, CHANNEL_VISIBILITY_ERROR, 0);
    check_near("estimated error over error, visibility", estimated / off, 1, .25);
    off = spread_of(&image, CHANNEL_DIRECT, mean_of(&image, CHANNEL_DIRECT));
    estimated = spread_of(&image, CHANNEL_DIRECT_ERROR, 0);
    check_near("direct light", estimated / off, 1, .25);
}

/* Under the middle of the square, whatever hides it, E / L = .752275. */
TEST(unshadowed) {
    OWNED(world) world;
    struct emitter light = lamp_above(1, 1);
    make_edge(&world);
    OWNED(image) image = look(&world, &(struct emitters){.items = &light, .count = 1}, 0, 256);
    check_near("unshadowed", GLM_PI * mean_of(&image, CHANNEL_UNSHADOWED), .752275, 1e-4);
    check_near("direct", GLM_PI * mean_of(&image, CHANNEL_DIRECT), .752275 / 2, 1e-3);
}

/* A red light that is hidden and a green one that is not: each colour tells of its own; blue, of
 * both. */
TEST(two) {
    OWNED(world) world;
    struct emitter lights[2] = {{.type = EMITTER_POINT, .position = {-1, 1, 0}},
                                {.type = EMITTER_POINT, .position = {1, 1, 0}}};
    make_edge(&world);
    lights[0].intensity[0] = lights[1].intensity[1] = 1;
    lights[0].intensity[2] = 1, lights[1].intensity[2] = 3;
    OWNED(image) image = look(&world, &(struct emitters){.items = lights, .count = 2}, 0, 4);
    check_near("red", mean_of(&image, CHANNEL_VISIBILITY), 0, 0);
    check_near("green", mean_of(&image, CHANNEL_VISIBILITY + 1), 1, 0);
    check_near("blue", mean_of(&image, CHANNEL_VISIBILITY + 2), .75, 1e-3);
}

/* Of an even sky, half a plane at a height leaves half above its edge: of what could be seen. */
TEST(sky) {
    OWNED(world) world;
    float texel[2][3] = {{1, 1, 1}, {1, 1, 1}};
    struct environment sky = {.width = 2, .height = 1, .texels = texel, .strength = 1};
    make_edge(&world);
    OWNED(image) image = look(&world, &(struct emitters){.sky = &sky}, 0, 1024);
    check_near("unshadowed", mean_of(&image, CHANNEL_UNSHADOWED), 1, 5e-3);
    check_near("visibility", mean_of(&image, CHANNEL_VISIBILITY), .5, 5e-3);
}

RUN_TESTS(NULL, NULL)
