/* Traced ambient occlusion beside closed forms, and what it leaves alone. */
#include "hand_made.h"

enum { SIZE = 8, SAMPLES = 256, AO = CHANNEL_PATH_TRACER_END + AO_OPEN, AO_ERROR };

/* A floor of 20 m with the corner of it that the camera sees, 1 mm wide at x, from a height that
 * nothing hides. */
static void start_floor(struct world *world) {
    world_init(world);
    add_rectangle(world, 0, at(-10, 0, 10), at(20, 0, 0), at(0, 0, -20));
    place_light(world, EMITTER_DIRECTIONAL, glms_vec3_zero(), at(0, -1, 0), 1);
}

static struct image look(struct world *world, float x, float height, float distance) {
    struct image image;
    look_down(world, x - 5e-4F, -5e-4F, 1e-3F, height);
    struct path_tracer_desc desc = describe(world, SIZE, SAMPLES);
    desc.ao_distance = distance;
    render(&desc, &image);
    return image;
}

static double rms_of(const struct image *image, int channel, double about) {
    double sum = 0;
    for (int i = 0; i < image->width * image->height; i++) {
        double value = (double)image_at(image, i % image->width, i / image->width)[channel];
        sum += (value - about) * (value - about);
    }
    return sqrt(sum / (image->width * image->height));
}

/* Within four standard errors of the mean over the pixels, and .0003 for facets and the width of
 * what is seen. */
static void check_open(const char *what, const struct image *image, double expected) {
    double noise = rms_of(image, AO_ERROR, 0) / SIZE;
    check_near(what, mean_of(image, AO), expected, 4 * noise + 3e-4);
    check_at_most("that noise", noise, 1e-3);
}

static void check_floor(const char *what, struct world *world, float x, float distance,
                        double expected) {
    world_finish(world);
    struct image image = look(world, x, .1F, distance);
    printf("  x = %g, D = %g\n", (double)x, (double)distance);
    check_open(what, &image, expected);
    image_free(&image);
}

TEST(plane) {
    OWNED(world) world;
    start_floor(&world);
    world_finish(&world);
    OWNED(image) image = look(&world, 0, .1F, 5);
    check_near("plane", mean_of(&image, AO), 1, 0);
    check_near("its noise", rms_of(&image, AO_ERROR, 0), 0, 0);
}

/* 1 - (acos u - u sqrt(1 - u^2)) / pi of a wall at u D: 1/2 at its foot, 1 from D on. */
TEST(wall) {
    OWNED(world) world;
    start_floor(&world);
    add_rectangle(&world, 0, at(0, 0, 10), at(0, 0, -20), at(0, 10, 0));
    for (int i = 0; i <= 4; i++) {
        double u = fmax(i / 4., .002), distance = 2;
        check_floor("wall", &world, (float)(u * distance), (float)distance,
                    1 - (acos(u) - u * sqrt(1 - u * u)) / GLM_PI);
    }
}

/* (H / D)^2 under a ceiling at H: the farther a ray counts, the less is open; 1 where it counts to
 * H. */
TEST(ceiling) {
    OWNED(world) world;
    start_floor(&world);
    add_rectangle(&world, 0, at(-10, .5F, -10), at(20, 0, 0), at(0, 0, 20));
    check_floor("ceiling at H < D", &world, 0, .625F, .64);
    check_floor("ceiling at H < D", &world, 0, 1, .25);
    check_floor("ceiling at H > D", &world, 0, .49F, 1);
}

/* Rings of a surface of revolution about y, from profile points (radius, height); normals towards
 * the axis at `focus` of height. */
static void add_turned(struct world *world, const vec2s *profile, int count, float focus) {
    enum { SIDES = 128 };
    uint32_t first = world->geometry.index_count, start = world->geometry.vertex_count;
    for (int j = 0; j < count; j++)
        for (int i = 0; i <= SIDES; i++) {
            double phi = 2 * GLM_PI * i / SIDES;
            vec3s p =
                at(profile[j].x * (float)cos(phi), profile[j].y, profile[j].x * (float)sin(phi));
            vec3s inwards = glms_vec3_sub(at(0, isnan(focus) ? p.y : focus, 0), p);
            add_vertex(world, p, vec3s_unit(inwards), 0, 0);
        }
    for (int j = 0; j + 1 < count; j++)
        for (uint32_t i = 0; i < SIDES; i++) {
            uint32_t a = start + (uint32_t)j * (SIDES + 1) + i, below = a + SIDES + 1;
            add_square(world, a, below, below + 1, a + 1);
        }
    end_batch(world, 0, first);
}

/* r^2 / (r^2 + h^2) in the middle of the floor of a round hole. */
TEST(hole) {
    OWNED(world) world;
    start_floor(&world);
    add_turned(&world, (vec2s[]){{{.5F, 1}}, {{.5F, 0}}}, 2, NAN);
    check_floor("hole of r = 1/2, h = 1", &world, 0, 5, .2);
    world_free(&world);
    start_floor(&world);
    add_turned(&world, (vec2s[]){{{.5F, .5F}}, {{.5F, 0}}}, 2, NAN);
    check_floor("hole of r = h", &world, 0, 5, .5);
}

/* A bowl that is the share f of its sphere, lit and looked into from its open top. */
static void start_bowl(struct world *world, double share) {
    enum { RINGS = 64 };
    vec2s profile[RINGS + 1];
    double rim = acos(2 * share - 1); /* from the top */
    for (int i = 0; i <= RINGS; i++) {
        double theta = rim + (GLM_PI - rim) * i / RINGS;
        profile[i] = (vec2s){{(float)sin(theta), (float)cos(theta)}};
    }
    world_init(world);
    add_turned(world, profile, RINGS + 1, 0);
    place_light(world, EMITTER_DIRECTIONAL, glms_vec3_zero(), at(0, -1, 0), 1);
    world_finish(world);
}

/* Form factors between points of a sphere are equal: 1 - f at every point. */
TEST(bowl) {
    static const double shares[] = {.25, .5, .75};
    for (int i = 0; i < 3; i++)
        for (int far = 0; far < 2; far++) {
            OWNED(world) world;
            start_bowl(&world, shares[i]);
            OWNED(image) image = look(&world, far ? .6F : .01F, 0, 4);
            printf("  %g of a sphere, %s\n", shares[i], far ? "up its side" : "at its bottom");
            check_open("bowl", &image, 1 - shares[i]);
        }
}

/* In a hemisphere all pixels have the same value: their distance from it is what their standard
 * errors tell. */
TEST(noise) {
    OWNED(world) world;
    OWNED(image) image;
    start_bowl(&world, .5);
    look_down(&world, -.5F, -.5F, 1, 0);
    struct path_tracer_desc desc = describe(&world, 32, 32);
    desc.ao_distance = 4;
    struct path_tracer_progress reached = render(&desc, &image);
    double off = rms_of(&image, AO, .5);
    check_near("estimated error over error", rms_of(&image, AO_ERROR, 0) / off, 1, .08);
    check_near("the same of the noise that is told", reached.noise * .5 / off, 1, .08);
    image_free(&image);
    desc.samples = 0;
    desc.noise = reached.noise / 3;
    check_at_most("noise until which it traces", render(&desc, &image).noise, desc.noise);
    check_at_most("error", rms_of(&image, AO, .5), 1.2 * .5 * desc.noise);
}

/* Holes of alpha masks are no ceiling. */
TEST(alpha_mask) {
    static unsigned char texel[4] = {255, 255, 255, 0};
    struct scene_texture texture = {.bitmap = {1, 1, texel}, .nearest = true};
    for (int solid = 0; solid < 2; solid++) {
        OWNED(world) world;
        start_floor(&world);
        texel[3] = solid ? 255 : 0;
        world.scene.textures = &texture;
        world.materials[1].base_color_texture = 0;
        world.materials[1].alpha_mask = true;
        add_rectangle(&world, 1, at(-10, .5F, -10), at(20, 0, 0), at(0, 0, 20));
        check_floor(solid ? "solid" : "hole", &world, 0, 1, solid ? .25 : 1);
    }
}

/* The mean is over samples that show a surface: no dark seam, and 0 beside it. */
TEST(background) {
    OWNED(world) world;
    OWNED(image) image;
    start_floor(&world);
    world_finish(&world);
    look_down(&world, 9, 0, 2.125F, 1); /* the floor ends within a pixel */
    struct path_tracer_desc desc = describe(&world, SIZE, 16);
    desc.ao_distance = 5;
    render(&desc, &image);
    for (int x = 0; x < SIZE; x++) {
        double coverage = (double)image_at(&image, x, 4)[CHANNEL_ALPHA];
        printf("  coverage %g\n", coverage);
        check_near("open", (double)image_at(&image, x, 4)[AO], coverage > 0, 0);
    }
}

/* The layer does not depend on threads, and the other layers not on it; specular ones come before
 * it. */
TEST(same_bits) {
    OWNED(world) world;
    struct image images[4];
    start_floor(&world);
    world.materials[1].roughness = .3F;
    world.materials[1].metalness = 1;
    add_rectangle(&world, 1, at(0, 0, 10), at(0, 0, -20), at(0, 10, 0));
    world_finish(&world);
    look_down(&world, -.5F, -.5F, 1, 3);
    for (int i = 0; i < 4; i++) {
        struct path_tracer_desc desc = describe(&world, SIZE, 8);
        desc.bounces = 1;
        desc.ao_distance = i > 0 ? 1 : 0;
        desc.ao_alone = i == 3;
        desc.threads = i;
        render(&desc, &images[i]);
    }
    int count = images[0].channel_count;
    assert_int_equal(images[1].channel_count, count + AO_END);
    assert_string_equal(images[1].names[count + AO_OPEN], "ao.Y");
    assert_string_equal(images[1].names[count + AO_STANDARD_ERROR], "standard_error.ao.Y");
    for (int i = 0; i < SIZE * SIZE; i++) {
        const float *without = image_at(&images[0], i % SIZE, i / SIZE),
                    *with = image_at(&images[1], i % SIZE, i / SIZE);
        assert_memory_equal(with, without, (size_t)count * sizeof *with);
    }
    assert_memory_equal(images[1].pixels, images[2].pixels,
                        SIZE * SIZE * (size_t)images[1].channel_count * sizeof(float));
    check_near("beside a metal wall", mean_of(&images[1], count + AO_OPEN), .75, .25);
    check_near("alone: light", mean_of(&images[3], CHANNEL_BEAUTY), 0, 0);
    check_near("the same layer", mean_of(&images[3], count + AO_OPEN),
               mean_of(&images[1], count + AO_OPEN), 0);
    for (int i = 0; i < 4; i++)
        image_free(&images[i]);
}

RUN_TESTS(NULL, NULL)
