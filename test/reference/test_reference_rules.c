/* The rules of the path tracer: what a material's sides and holes do, what a seed and a number of
 * threads do not, and that its noise is as large as it says. */
#include "hand_made.h"

#include "reference/sampler.h"
#include "reference/scene/ray_scene.h"
#include "reference/warp.h"

static const vec3s down = {{0, -1, 0}};

/* A floor that the camera sees as [0, 1]^2 from above, lit straight down by pi W/m2: direct light
 * over pi of 1. Something in between is added by the test. */
static void start_floor(struct world *world) {
    world_init(world);
    add_rectangle(world, 0, (vec3s){{-2, 0, 3}}, (vec3s){{5, 0, 0}}, (vec3s){{0, 0, -5}});
    look_down(world, 0, 0, 1, 3);
    place_light(world, EMITTER_DIRECTIONAL, glms_vec3_zero(), down, GLM_PIf);
}

/* A rectangle over half of what the camera sees, x < 1/2, facing up or down. */
static void add_half_cover(struct world *world, int material, bool faces_up) {
    vec3s u = {{1.5f, 0, 0}}, v = {{0, 0, -3}};
    add_rectangle(world, material, (vec3s){{-1, 1, 2}}, faces_up ? u : v, faces_up ? v : u);
}

static struct image render_floor(struct world *world, int bounces, int samples) {
    struct image image;
    world_finish(world);
    struct path_tracer_desc desc = describe(world, 8, samples);
    desc.bounces = bounces;
    render(&desc, &image);
    world_free(world);
    return image;
}

static const float *left_pixel(const struct image *image) {
    return image_at(image, 1, 4);
}

static const float *right_pixel(const struct image *image) {
    return image_at(image, 6, 4);
}

TEST(back_of_single_sided) {
    struct world world;
    start_floor(&world);
    add_half_cover(&world, 1, false);
    OWNED(image) image = render_floor(&world, 0, 4);
    check_near("the camera looks through the back", left_pixel(&image)[CHANNEL_DEPTH], 3, 1e-5);
    check_near("which casts a shadow", left_pixel(&image)[CHANNEL_DIRECT], 0, 0);
    check_near("beside it is light", right_pixel(&image)[CHANNEL_DIRECT], 1, 1e-6);
}

TEST(back_of_double_sided) {
    struct world world;
    start_floor(&world);
    world.materials[1].double_sided = true;
    world.materials[1].base_color[0] = 0.25f;
    add_half_cover(&world, 1, false);
    OWNED(image) image = render_floor(&world, 0, 4);
    check_near("the camera sees the back", left_pixel(&image)[CHANNEL_DEPTH], 2, 1e-5);
    check_near("lit like a front", left_pixel(&image)[CHANNEL_DIRECT], 1, 1e-6);
    check_near("with its normal towards us", left_pixel(&image)[CHANNEL_NORMAL + 1], 1, 1e-6);
    check_near("and its albedo", left_pixel(&image)[CHANNEL_ALBEDO], 0.25, 1e-6);
    check_near("beauty", left_pixel(&image)[CHANNEL_BEAUTY], 0.25, 1e-6);
}

/* Light bounces off the floor beside the cover to the cover's under side and down again: none of it
 * where the under side is the back of a single-sided material. */
TEST(bounce_off_a_back) {
    double under[3];
    for (int kind = 0; kind < 3; kind++) {
        struct world world;
        start_floor(&world);
        world.materials[1].double_sided = kind == 1;
        add_half_cover(&world, 1, kind < 2);
        /* From below the cover, so that it hides nothing. */
        world.camera.eye[1] = 0.5f;
        OWNED(image) image = render_floor(&world, 2, 256);
        under[kind] = left_pixel(&image)[CHANNEL_INDIRECT];
    }
    check_near("two bounces under a black back", under[0], 0, 0);
    assert_true(under[1] > 0.01);
    /* Two noisy pixels of one reference. */
    check_near("a double-sided back is as good as a front", under[1], under[2], 0.03 * under[2]);
}

/* A texture of 2 x 2 texels whose diagonal is holes. */
static void set_mask(struct world *world, struct scene_texture *texture) {
    static unsigned char texels[] = {255, 255, 255, 255, 255, 255, 255, 0,
                                     188, 188, 188, 0,   188, 188, 188, 255};
    *texture = (struct scene_texture){.bitmap = {2, 2, texels}, .nearest = true};
    world->scene.textures = texture;
    world->materials[1].base_color_texture = 0;
    world->materials[1].alpha_mask = true;
}

TEST(alpha_mask) {
    struct world world;
    struct scene_texture texture;
    start_floor(&world);
    set_mask(&world, &texture);
    add_rectangle(&world, 1, (vec3s){{0, 1, 1}}, (vec3s){{1, 0, 0}}, (vec3s){{0, 0, -1}});
    OWNED(image) image = render_floor(&world, 0, 4);
    /* uv (0, 0) is at the lower left of the picture and texel (0, 0) lies there. */
    const float *solid = image_at(&image, 1, 6), *hole = image_at(&image, 6, 6);
    check_near("solid texel", solid[CHANNEL_DEPTH], 2, 1e-5);
    check_near("its albedo is factor x texel", solid[CHANNEL_ALBEDO], 0.5, 1e-6);
    check_near("hole", hole[CHANNEL_DEPTH], 3, 1e-5);
    check_near("light falls through it", hole[CHANNEL_DIRECT], 1, 1e-6);
    const float *dark = image_at(&image, 6, 1);
    /* Byte 188 is 0.5029 of linear light. */
    check_near("sRGB-encoded texel", dark[CHANNEL_ALBEDO], 0.5 * 0.502886, 1e-5);
    image_free(&image);

    start_floor(&world);
    set_mask(&world, &texture);
    add_rectangle(&world, 1, (vec3s){{0, 1, 1}}, (vec3s){{1, 0, 0}}, (vec3s){{0, 0, -1}});
    world.camera.eye[1] = 0.5f;
    image = render_floor(&world, 0, 4);
    check_near("shadow of the solid", image_at(&image, 1, 6)[CHANNEL_DIRECT], 0, 0);
    check_near("light under the hole", image_at(&image, 6, 6)[CHANNEL_DIRECT], 1, 1e-6);
}

/* Four rays at once see what each sees alone, holes too. */
TEST(packets) {
    OWNED(world) world;
    struct scene_texture texture;
    struct hit_table table;
    struct ray_scene rays;
    start_floor(&world);
    add_half_cover(&world, 0, true);
    set_mask(&world, &texture);
    add_rectangle(&world, 1, (vec3s){{0, 0.5f, 1}}, (vec3s){{1, 0, 0}}, (vec3s){{0, 0, -1}});
    world_finish(&world);
    hit_table_init(&table, &world.scene, &world.geometry, MATERIALS_FULL);
    check_ok("build", ray_scene_init(&rays, &table));
    int seen = 0, asked = 0;
    for (uint32_t n = 0; n < 1000; n++) {
        struct sampler sampler = {.index = n};
        vec2s at = sampler_next(&sampler);
        vec3s from = {{at.x, 0.1f, at.y}}, to[4];
        vec3s passes[4];
        bool wanted[4];
        for (int i = 0; i < 4; i++) {
            vec2s end = sampler_next(&sampler);
            to[i] = (vec3s){{end.x, i ? 0.5f * (float)i + 0.1f : 0.1f, end.y}};
            wanted[i] = (n + (uint32_t)i) % 5 != 0;
        }
        ray_scene_passes_4(&rays, from, to, wanted, passes);
        for (int i = 0; i < 4; i++) {
            bool visible = passes[i].x > 0;
            assert_int_equal(visible, wanted[i] && ray_scene_visible(&rays, from, to[i]));
            seen += visible;
            asked += wanted[i];
        }
    }
    printf("    %d of %d are visible\n", seen, asked);
    assert_true(seen > asked / 4 && seen < asked * 3 / 4);
    ray_scene_free(&rays);
}

/* Where a pixel shows two surfaces, and where it is partly empty. */
TEST(albedo_weighting) {
    OWNED(world) world;
    world_init(&world);
    world.materials[1].base_color[0] = 0.1f;
    add_rectangle(&world, 0, (vec3s){{0, 0, 1}}, (vec3s){{0.5f, 0, 0}}, (vec3s){{0, 0, -0.75f}});
    add_rectangle(&world, 1, (vec3s){{0.5f, 1, 1}}, (vec3s){{0.5f, 0, 0}}, (vec3s){{0, 0, -0.75f}});
    look_down(&world, 0, 0, 1, 3);
    place_light(&world, EMITTER_POINT, (vec3s){{0.2f, 2, 0.5f}}, down, 5);
    world_finish(&world);
    OWNED(image) image;
    struct path_tracer_desc desc = describe(&world, 1, 4096);
    desc.bounces = 1;
    render(&desc, &image);
    const float *pixel = image.pixels;
    check_near("coverage", pixel[CHANNEL_ALPHA], 0.75, 1e-3);
    check_near("mean albedo", pixel[CHANNEL_ALBEDO], 0.75 * 0.3, 1e-3);
    check_near("beauty = albedo x (direct + indirect)", pixel[CHANNEL_BEAUTY],
               pixel[CHANNEL_ALBEDO] * (pixel[CHANNEL_DIRECT] + pixel[CHANNEL_INDIRECT]), 1e-5);
}

/* An open box in which all parts of the tracer work. */
static void make_corner(struct world *world) {
    world_init(world);
    add_rectangle(world, 0, (vec3s){{0, 0, 1}}, (vec3s){{1, 0, 0}}, (vec3s){{0, 0, -1}});
    add_rectangle(world, 1, (vec3s){{0, 0, 1}}, (vec3s){{0, 0, -1}}, (vec3s){{0, 1, 0}});
    look_down(world, 0, 0, 1, 3);
    place_light(world, EMITTER_SPOT, (vec3s){{0.9f, 0.8f, 0.5f}}, (vec3s){{-1, -0.1f, 0.1f}}, 5);
    world->light.cos_inner = cosf(0.4f);
    world->light.cos_outer = cosf(0.5f);
    world_finish(world);
}

TEST(threads_and_seeds) {
    OWNED(world) world;
    OWNED(image) one, three, other;
    make_corner(&world);
    struct path_tracer_desc desc = describe(&world, 32, 32);
    desc.bounces = 2;
    desc.threads = 1;
    double noise = render(&desc, &one).noise;
    desc.threads = 3;
    render(&desc, &three);
    desc.seed = 1;
    render(&desc, &other);
    size_t count = 32 * 32 * (size_t)one.channel_count;
    assert_memory_equal(one.pixels, three.pixels, count * sizeof(float));
    /* Two independent pictures differ by sqrt 2 times the noise: 1024 pixels of unlike noise tell
     * that to some 5 %. */
    double squares = 0, values = 3 * 32 * 32, mean = 0;
    for (size_t pixel = 0; pixel < 32 * 32; pixel++)
        for (int c = CHANNEL_INDIRECT; c < CHANNEL_INDIRECT + 3; c++) {
            const float *a = image_at(&one, (int)pixel % 32, (int)pixel / 32);
            const float *b = image_at(&other, (int)pixel % 32, (int)pixel / 32);
            squares += pow(a[c] - b[c], 2);
            mean += a[c] / values;
        }
    double difference = sqrt(squares / values / 2) / mean;
    check_near("noise between seeds, as estimated", difference, noise, 0.15 * noise);
    double errors = 0;
    for (size_t pixel = 0; pixel < 32 * 32; pixel++)
        for (int c = 0; c < 3; c++)
            errors += pow(
                image_at(&one, (int)pixel % 32, (int)pixel / 32)[CHANNEL_STANDARD_ERROR + c], 2);
    check_near("RMS of the standard errors", sqrt(errors / values) / mean, noise, 1e-4 * noise);
}

/* Counts that are no multiple of the streams, and a single path. */
TEST(few_samples) {
    OWNED(world) world;
    struct image image;
    make_corner(&world);
    struct path_tracer_desc desc = describe(&world, 64, 64);
    desc.bounces = 1;
    render(&desc, &image);
    double reference = mean_of(&image, CHANNEL_INDIRECT);
    image_free(&image);
    for (int samples = 1; samples <= 7; samples += 3) {
        desc.samples = samples;
        struct path_tracer_progress reached = render(&desc, &image);
        assert_int_equal(reached.samples, samples);
        /* 4096 pixels of a path each have a noise of 2 %. */
        check_near("mean", mean_of(&image, CHANNEL_INDIRECT), reference,
                   0.06 / sqrt(samples) * reference);
        if (samples == 1)
            check_near("noise that one sample does not tell", reached.noise, 0, 0);
        else
            check_at_most("noise of some", 0.01, reached.noise);
        image_free(&image);
    }
}

static bool count_calls(void *user, const struct path_tracer_progress *progress) {
    int *calls = user;
    assert_true(progress->done >= 0 && progress->done <= 1);
    return ++*calls < 20;
}

TEST(noise_and_cancel) {
    OWNED(world) world;
    struct image image, coarse;
    make_corner(&world);
    struct path_tracer_desc desc = describe(&world, 16, 0);
    desc.bounces = 1;
    desc.noise = 0.002;
    struct path_tracer_progress fine = render(&desc, &image);
    desc.noise = 0.1;
    struct path_tracer_progress rough = render(&desc, &coarse);
    check_at_most("noise asked for", fine.noise, 0.002);
    assert_true(rough.samples < fine.samples);
    check_near("means agree", mean_of(&coarse, CHANNEL_INDIRECT), mean_of(&image, CHANNEL_INDIRECT),
               0.02 * mean_of(&image, CHANNEL_INDIRECT));
    images_free(&image, &coarse);

    int calls = 0;
    desc.progress = count_calls;
    desc.user = &calls;
    desc.noise = 1e-6;
    assert_false(path_tracer_render(&desc, &image, NULL));
    assert_string_equal(error_get(), "cancelled");
    assert_null(image.pixels);
}

/* The first 256 points of a pair are a (0,2)-net: one in each elementary interval. Over many seeds
 * any one point is uniform in the square. */
TEST(sampler) {
    int cells[64] = {0};
    for (uint32_t seed = 0; seed < 4096; seed++) {
        vec2s first = sampler_next(&(struct sampler){.seed = sampler_hash(seed, 7)});
        cells[(int)(first.x * 8) * 8 + (int)(first.y * 8)]++;
    }
    double chi_square = 0;
    for (int i = 0; i < 64; i++)
        chi_square += pow(cells[i] - 64, 2) / 64;
    /* 63 degrees of freedom: above 103 once in a thousand. */
    check_at_most("chi square of the first point", chi_square, 103);
    for (uint32_t pair = 0; pair < 3; pair++)
        for (int bits = 0; bits <= 8; bits++) {
            bool hit[256] = {0};
            for (uint32_t i = 0; i < 256; i++) {
                struct sampler sampler = {.seed = 5, .index = i, .pair = pair};
                vec2s p = sampler_next(&sampler);
                int cell = ((int)(p.x * (1 << bits)) << (8 - bits)) | (int)(p.y * (256 >> bits));
                assert_false(hit[cell]);
                hit[cell] = true;
            }
        }
}

TEST(warps) {
    static const vec3s axes[] = {{{0, 0, 1}}, {{0, 0, -1}}, {{0.6f, -0.8f, 0}}, {{0, 0.6f, -0.8f}}};
    enum { COUNT = 4096 };
    for (size_t a = 0; a < sizeof axes / sizeof *axes; a++) {
        double cosine = 0, cone = 0, radius2 = 0, worst = 0, least = 1;
        vec3s sideways = glms_vec3_zero();
        for (uint32_t i = 0; i < COUNT; i++) {
            vec2s sample = sampler_next(&(struct sampler){.index = i});
            vec3s p = warp_to_cosine(sample, axes[a]), q = warp_to_cone(sample, axes[a], 0.25f);
            vec3s r = warp_to_disc(sample, axes[a]);
            cosine += glms_vec3_dot(p, axes[a]) / COUNT;
            cone += glms_vec3_dot(q, axes[a]) / COUNT;
            radius2 += glms_vec3_norm2(r) / COUNT;
            least = fmin(least, glms_vec3_dot(q, axes[a]));
            worst = fmax(worst, fabs(glms_vec3_norm(p) - 1));
            worst = fmax(worst, fabs(glms_vec3_norm(q) - 1));
            worst = fmax(worst, fabsf(glms_vec3_dot(r, axes[a])));
            sideways = glms_vec3_add(sideways, glms_vec3_scale(r, 1.0f / COUNT));
        }
        check_near("mean cosine, 2/3", cosine, 2. / 3, 1e-3);
        check_near("mean cosine in the cone, (1 + 1/4) / 2", cone, 0.625, 1e-3);
        check_near("least cosine in the cone", least, 0.25, 1e-3);
        check_near("mean squared radius of the disc", radius2, 0.5, 1e-3);
        check_near("centre of the disc", glms_vec3_norm(sideways), 0, 2e-3);
        check_at_most("unit and in the plane", worst, 1e-6);
    }
}

RUN_TESTS(NULL, NULL)
