/* Light paths through glass and mirrors: exact answers; relations that hold of any picture; and
 * what must end without numbers that are none. */
#include "light_scenes.h"

#include "reference/scene/medium_ball.h"
#include "reference/smooth.h"
#include "scene/lights/environment.h"

/* --- one interface ---------------------------------------------------------------------------- */

TEST(fresnel) {
    static const struct {
        double angle, reflectance;
    } rows[] = {{0, .04}, {30, .041523}, {60, .089187}, {89.999, 1}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        double angle = rows[i].angle * GLM_PI / 180;
        double within = asin(sin(angle) / 1.5);
        float enters = smooth_reflectance((float)cos(angle), 1 / 1.5F);
        check_near("reflectance", (double)enters, rows[i].reflectance, 2e-4 * (i == 3 ? 1 : .02));
        if (rows[i].angle < 80)
            check_near("from within", (double)smooth_reflectance((float)cos(within), 1.5F),
                       (double)enters, 1e-6);
        vec3s down = at((float)sin(angle), -(float)cos(angle), 0), refracted;
        assert_true(smooth_refract(down, at(0, 1, 0), 1 / 1.5F, &refracted));
        check_near("sine within", (double)refracted.x, sin(within), 1e-6);
    }
    vec3s refracted;
    assert_false(smooth_refract(at(.8F, -.6F, 0), at(0, 1, 0), 1.5F, &refracted));
    check_near("total reflection", (double)smooth_reflectance(.6F, 1.5F), 1, 0);
    check_near("of nothing", (double)smooth_reflectance(.3F, 1), 0, 1e-12);
}

/* --- rays ------------------------------------------------------------------------------------- */

/* A ray's way through smooth surfaces with the same pick at each. */
static struct smooth_ray follow(struct world *world, vec3s origin, vec3s direction, float pick,
                                int interfaces) {
    struct hit_table table;
    struct ray_scene rays;
    struct smooth_ray ray = {.origin = origin, .direction = direction};
    hit_table_init(&table, &world->scene, &world->geometry, MATERIALS_FULL);
    assert_true(hit_table_find_smooth(&table));
    check_ok("rays", ray_scene_init(&rays, &table));
    for (int i = 0; i < interfaces; i++) {
        struct hit hit;
        assert_true(ray_scene_hit(&rays, ray.origin, ray.direction, &hit));
        assert_non_null(hit.smooth);
        ray = smooth_leave(&rays, &hit, pick);
    }
    ray_scene_free(&rays);
    return ray;
}

/* Where the ray's x is 0, along y. */
static double crossing(const struct smooth_ray *ray) {
    return (double)(ray->origin.y - ray->origin.x / ray->direction.x * ray->direction.y);
}

/* Parallel rays through a ball meet R / 2 behind it, those aside a bit before. */
TEST(ball) {
    static const float asides[] = {.1F, .25F, .5F};
    for (size_t i = 0; i < sizeof asides / sizeof *asides; i++) {
        OWNED(world) world;
        world_init(&world);
        make_glass(&world.materials[MATERIAL_SMOOTH], 1.5F);
        add_ball(&world, MATERIAL_SMOOTH, 96, at(0, 0, 0), 1);
        world_finish(&world);
        double aside = (double)asides[i], bends = 2 * (asin(aside) - asin(aside / 1.5));
        struct smooth_ray ray = follow(&world, at(asides[i], 3, .001F), at(0, -1, 0), .999F, 2);
        assert_null(ray.inside);
        check_near("from the middle", -crossing(&ray), aside / sin(bends), .02);
        if (i == 0)
            check_near("behind the ball", -crossing(&ray) - 1, .5, .02);
    }
}

/* Around the y axis, seen from within. */
static void add_tube(struct world *world, int material, float height) {
    enum { SIDES = 256 };
    uint32_t index = world->geometry.index_count, first = world->geometry.vertex_count;
    for (int i = 0; i <= SIDES; i++) {
        float turn = 2 * GLM_PIf * (float)i / SIDES;
        vec3s out = at(cosf(turn), 0, sinf(turn));
        add_vertex(world, out, glms_vec3_negate(out), 0, 0);
        out.y = height;
        add_vertex(world, out, at(-out.x, 0, -out.z), 0, 0);
    }
    for (uint32_t i = 0; i < SIDES; i++) {
        uint32_t a = first + 2 * i;
        add_square(world, a, a + 2, a + 3, a + 1);
    }
    end_batch(world, material, index);
}

/* A sun at 45 degrees into a mirror tube without a lid: the caustic's cusp lies half a radius from
 * the middle. */
TEST(cusp) {
    OWNED(world) world;
    OWNED(image) image;
    enum { SIZE = 64 };
    world_init(&world);
    make_mirror(&world.materials[MATERIAL_SMOOTH], 1);
    add_floor(&world, 2.4F);
    add_tube(&world, MATERIAL_SMOOTH, 1);
    world_finish(&world);
    look_down(&world, -1, -1, 2, 3);
    place_light(&world, EMITTER_DIRECTIONAL, at(0, 0, 0), at(1, -1, 0), 1);
    struct light_tracer_result result =
        trace(&world, NULL, &(struct look){.size = SIZE, .samples = 1, .paths = 1000000}, &image);
    int best = 0, first = image_find_channel(&image, "caustic.G");
    double most = 0;
    for (int x = 0; x < SIZE; x++) { /* along the axis */
        double light = 0;
        for (int y = SIZE / 2 - 1; y <= SIZE / 2; y++)
            light += (double)image_at(&image, x, y)[first];
        if (light > most) {
            most = light;
            best = x;
        }
    }
    check_near("the cusp's place", 2 * (best + .5) / SIZE - 1, .5, 1.5 * 2 / SIZE);
    check_balance(&result.balance);
}

/* --- exact answers ---------------------------------------------------------------------------- */

/* A floor beside an upright mirror: the light comes from behind the mirror, too. */
TEST(mirror) {
    enum { STEPS = 100 };
    OWNED(world) world;
    OWNED(image) image;
    double expected = 0;
    world_init(&world);
    make_mirror(&world.materials[MATERIAL_SMOOTH], .8F);
    add_floor(&world, 2);
    add_rectangle(&world, MATERIAL_SMOOTH, at(-1, 0, 1.5F), at(0, 0, -3), at(0, 1.5F, 0));
    world_finish(&world);
    world.geometry.radius = 6;
    look_down(&world, -.5F, -.5F, 1, 3);
    place_light(&world, EMITTER_POINT, at(.5F, 1, 0), at(0, -1, 0), 1);
    for (int i = 0; i < STEPS; i++)
        for (int k = 0; k < STEPS; k++) {
            double x = (i + .5) / STEPS - .5 + 2.5, z = (k + .5) / STEPS - .5;
            expected += .8 / pow(x * x + 1 + z * z, 1.5) / STEPS / STEPS;
        }
    struct light_tracer_result result =
        trace(&world, NULL, &(struct look){.size = 16, .samples = 4, .paths = 300000}, &image);
    check_near("irradiance over that of the mirrored light",
               GLM_PI * mean_of_layer(&image, "caustic") / expected, 1, .005);
    check_balance(&result.balance);
}

/* A slab of glass between a light and the floor, seen below it. */
TEST(slab) {
    OWNED(world) world;
    OWNED(image) image;
    world_init(&world);
    make_glass(&world.materials[MATERIAL_SMOOTH], 1.5F);
    add_floor(&world, 2);
    add_box(&world, MATERIAL_SMOOTH, at(-.3F, .8F, -.3F), at(.3F, 1, .3F));
    world_finish(&world);
    look_down(&world, -.04F, -.04F, .08F, .5F);
    place_light(&world, EMITTER_SPOT, at(0, 2, 0), at(0, -1, 0), 1);
    world.light.cos_outer = .99F; /* so that it meets no side */
    world.light.cos_inner = .992F;
    trace(&world, NULL, &(struct look){.size = 4, .samples = 4, .paths = 500000}, &image);
    check_near("irradiance on the axis", GLM_PI * mean_of_layer(&image, "caustic"), .246564, .001);
    image_free(&image);
    place_light(&world, EMITTER_DIRECTIONAL, at(0, 2, 0), at(0, -1, 0), 1);
    trace(&world, NULL, &(struct look){.size = 4, .samples = 4, .paths = 300000}, &image);
    /* And what is reflected twice within. */
    check_near("of a sun", GLM_PI * mean_of_layer(&image, "caustic"), .9216 / (1 - .0016), .006);
}

/* A mirror that reflects all sends all light to the floor that lies below, and all of that
 * is seen. */
TEST(energy) {
    OWNED(world) world;
    OWNED(image) image;
    world_init(&world);
    make_glass(&world.materials[MATERIAL_SMOOTH], 1.7F);
    world.materials[MATERIAL_SMOOTH].absorption[1] = 2;
    add_floor(&world, 2);
    add_ball(&world, MATERIAL_SMOOTH, 32, at(0, .6F, 0), .3F);
    world_finish(&world);
    look_down(&world, -1, -1, 2, .2F);
    place_light(&world, EMITTER_SPOT, at(0, 2, 0), at(0, -1, 0), 1);
    world.light.cos_outer = .8F;
    world.light.cos_inner = .9F;
    struct light_tracer_result result =
        trace(&world, NULL, &(struct look){.size = 16, .samples = 4, .paths = 100000}, &image);
    check_balance(&result.balance);
    check_near("seen over landed",
               4 * GLM_PI * mean_of_layer(&image, "caustic") / result.balance.landed, 1, 1e-3);
    double aimed = result.balance.landed;
    image_free(&image);
    result =
        trace(&world, NULL,
              &(struct look){.size = 16, .samples = 4, .paths = 100000, .straight = true}, &image);
    check_near("emitted over the light's flux",
               result.balance.emitted / emitter_flux(&world.light, 1), 1, 2e-3);
    check_near("landed over that of rays to the ball", result.balance.landed / aimed, 1, .01);
}

/* --- without glass ---------------------------------------------------------------------------- */

static const struct medium fog = {
    .scattering = {.3F, .2F, .1F}, .absorption = {.05F, .1F, 0}, .g = .4F};

/* From the side; an orthographic camera looks down, too. */
static void look_along(struct world *world, bool orthographic) {
    world->camera = FILLED(camera, .eye = {0, .5F, 2.2F}, .right = {1, 0, 0}, .up = {0, 1, 0},
                           .forward = {0, 0, -1}, .fov_y = .45F);
    if (orthographic)
        world->camera =
            FILLED(camera, .orthographic = true, .eye = {0, 1.6F, 1.6F}, .right = {1, 0, 0},
                   .up = {0, .8F, -.6F}, .forward = {0, -.6F, -.8F}, .y_extent = .7F);
}

/* Light straight from the light is direct light and airlight. */
TEST(straight) {
    static const struct {
        const char *name;
        enum emitter_type type;
        bool orthographic, cuts;
    } rows[] = {{"spot", EMITTER_SPOT, false, false},
                {"spot", EMITTER_SPOT, true, false},
                {"spot", EMITTER_SPOT, false, true},
                {"sun", EMITTER_DIRECTIONAL, false, false},
                {"area", EMITTER_AREA, false, false}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        OWNED(world) world;
        OWNED(image) image;
        world_init(&world);
        add_floor(&world, 2);
        finish(&world, 1.8F);
        look_along(&world, rows[i].orthographic);
        struct geometry_part floor = {.vertex_count = 4, .index_count = 6};
        if (rows[i].cuts) { /* a third of the floor, and nothing of the medium */
            memcpy(floor.bounds_min, world.geometry.bounds_min, sizeof floor.bounds_min);
            memcpy(floor.bounds_max, world.geometry.bounds_max, sizeof floor.bounds_max);
            world.geometry.parts = &floor;
            world.geometry.part_count = 1;
            world.camera.near = 2;
            world.camera.far = 2.7F;
        }
        place_light(&world, rows[i].type, at(.2F, 1.4F, 0), at(.1F, -1, 0), 1);
        world.light.cos_outer = .8F;
        world.light.cos_inner = .9F;
        if (rows[i].type == EMITTER_AREA)
            world.light.size[0] = .3F;
        emitter_aim(&world.light, world.light.direction);
        trace(&world, NULL,
              &(struct look){
                  .size = 32, .samples = 128, .paths = 400000, .straight = true, .medium = fog},
              &image);
        printf("    %s%s%s\n", rows[i].name, rows[i].orthographic ? ", orthographic" : "",
               rows[i].cuts ? ", near and far cut off" : "");
        check_near("lines over airlight",
                   mean_of_layer(&image, "volume") / mean_of_layer(&image, "airlight"), 1, .004);
        check_near("lands over direct light",
                   reflected(&image, "caustic") / reflected(&image, "direct"), 1, .004);
    }
}

/* A slab above the view; or none. */
static void make_roof(struct world *world, const struct material *glass) {
    world_init(world);
    add_floor(world, 2);
    if (glass) {
        world->materials[MATERIAL_SMOOTH] = *glass;
        add_box(world, MATERIAL_SMOOTH, at(-.8F, 1.2F, -.8F), at(.8F, 1.2001F, .8F));
    }
    finish(world, 1.8F);
    look_along(world, false);
    place_light(world, EMITTER_POINT, at(.1F, 1.6F, 0), at(0, -1, 0), 1);
}

/* Glass that bends nothing is not there. */
TEST(index_one) {
    struct material glass;
    make_glass(&glass, 1);
    for (int thin = 0; thin < 2; thin++) {
        OWNED(world) world;
        OWNED(image) with, without;
        struct look look = {.size = 32, .samples = 64, .paths = 1500000, .medium = fog};
        glass.thin_walled = thin;
        make_roof(&world, &glass);
        trace(&world, NULL, &look, &with);
        world_free(&world);
        make_roof(&world, NULL);
        trace(&world, NULL, &look, &without);
        assert_true(reflected(&with, "caustic") > reflected(&with, "direct"));
        check_near("direct and caustic over direct light without",
                   (reflected(&with, "direct") + reflected(&with, "caustic")) /
                       reflected(&without, "direct"),
                   1, .005);
        check_near("airlight and volume over airlight without",
                   (mean_of_layer(&with, "airlight") + mean_of_layer(&with, "volume")) /
                       mean_of_layer(&without, "airlight"),
                   1, .01);
        check_near("beauty over beauty without",
                   mean_of_layer(&with, "") / mean_of_layer(&without, ""), 1, .01);
    }
}

/* However far away the lamp is, rays go to all of the glass. */
TEST(far) {
    OWNED(world) world;
    OWNED(image) image;
    struct material glass;
    make_glass(&glass, 1);
    make_roof(&world, &glass);
    look_down(&world, -.6F, -.6F, 1.2F, 1.1F);
    place_light(&world, EMITTER_POINT, at(0, 2e4F, 0), at(0, -1, 0), 4e8F);
    trace(&world, NULL, &(struct look){.size = 8, .samples = 4, .paths = 100000}, &image);
    check_near("irradiance", GLM_PI * mean_of_layer(&image, "caustic"), 1, .005);
}

/* Nor does it hide anything from the camera above it. */
TEST(window) {
    struct material glass;
    make_glass(&glass, 1);
    double beauty[2];
    for (int with = 0; with < 2; with++) {
        OWNED(world) world;
        OWNED(image) image;
        make_roof(&world, with ? &glass : NULL);
        look_down(&world, -.6F, -.6F, 1.2F, 1.5F);
        place_light(&world, EMITTER_POINT, at(.1F, .8F, 0), at(0, -1, 0), 1);
        trace(&world, NULL,
              &(struct look){.size = 16, .samples = 64, .paths = 20000, .medium = fog}, &image);
        beauty[with] = mean_of_layer(&image, "");
        printf("    specular light %g\n", with ? mean_of_layer(&image, "specular") : 0);
    }
    check_near("seen through over seen", beauty[1] / beauty[0], 1, .005);
}

/* Glass takes no light and adds none. */
TEST(seen_through) {
    float texels[2][3] = {{1, 1, 1}, {1, 1, 1}};
    struct environment sky = {.width = 2, .height = 1, .texels = texels, .strength = 1};
    for (int kind = 0; kind < 3; kind++) {
        OWNED(world) world;
        OWNED(image) image;
        world_init(&world);
        make_glass(&world.materials[MATERIAL_SMOOTH], kind ? 1.5F : 1);
        if (kind == 2)
            make_mirror(&world.materials[MATERIAL_SMOOTH], .7F);
        add_ball(&world, MATERIAL_SMOOTH, 24, at(0, 0, 0), 1);
        world_finish(&world);
        look_down(&world, -1.2F, -1.2F, 2.4F, 3);
        struct path_tracer_desc desc = describe(&world, 16, 16);
        desc.emitters = (struct emitters){.sky = &sky};
        desc.smooth = true;
        render(&desc, &image);
        double alpha = mean_of(&image, CHANNEL_ALPHA);
        check_near("a ball under a sky of 1", mean_of_layer(&image, ""),
                   1 - (kind == 2 ? .3 : 0) * alpha, 1e-3);
        check_near("its specular light", mean_of_layer(&image, "specular"),
                   (kind == 2 ? .7 : 1) * alpha, 1e-3);
    }
}

/* --- relations -------------------------------------------------------------------------------- */

static void make_bright(struct world *world) {
    world_init(world);
    make_glass(&world->materials[MATERIAL_SMOOTH], 1.5F);
    add_floor(world, 2);
    add_ball(world, MATERIAL_SMOOTH, 24, at(0, .5F, 0), .3F);
    world_finish(world);
    look_down(world, -.5F, -.5F, 1, .15F);
    place_light(world, EMITTER_POINT, at(.3F, 2, 0), at(0, -1, 0), 1);
}

TEST(relations) {
    OWNED(world) world;
    struct image one, again, halves, more;
    make_bright(&world);
    struct look look = {.size = 16, .samples = 1, .paths = 60000, .threads = 1};
    struct light_tracer_result few = trace(&world, NULL, &look, &one);
    look.threads = 3;
    trace(&world, NULL, &look, &again);
    size_t bytes = sizeof(float) * 256 * (size_t)one.channel_count;
    assert_memory_equal(one.pixels, again.pixels, bytes);
    image_free(&again);
    struct emitter pair[2] = {world.light, world.light};
    for (int c = 0; c < 3; c++)
        pair[0].intensity[c] = pair[1].intensity[c] = world.light.intensity[c] / 2;
    trace(&world, &(struct emitters){.items = pair, .count = 2}, &look, &halves);
    double mean = mean_of_layer(&one, "caustic");
    look.size *= 2;
    trace(&world, NULL, &look, &again);
    check_near("twice the pixels over one", mean_of_layer(&again, "caustic") / mean, 1, 1e-3);
    image_free(&again);
    look.size /= 2;
    look.paths *= 4;
    look.seed = 7;
    struct light_tracer_result many = trace(&world, NULL, &look, &more);
    check_near("two half lights over one", mean_of_layer(&halves, "caustic") / mean, 1, .02);
    check_near("four times the rays over one", mean_of_layer(&more, "caustic") / mean, 1, .02);
    check_near("noise over twice the noise", few.noise / many.noise / 2, 1, .35);
    images_free(&one, &halves, &more);
}

/* A beam that a window lets through, seen from the front and from behind. */
TEST(sides) {
    double volumes[2];
    for (int side = 0; side < 2; side++) {
        OWNED(world) world;
        OWNED(image) image;
        float turn = side ? -1 : 1;
        world_init(&world);
        make_glass(&world.materials[MATERIAL_SMOOTH], 1);
        world.materials[MATERIAL_SMOOTH].thin_walled = true;
        add_rectangle(&world, MATERIAL_SMOOTH, at(-.9F, -.2F, -.2F), at(0, 0, .4F), at(0, .4F, 0));
        finish(&world, 1.5F);
        world.camera = FILLED(camera, .orthographic = true, .eye = {1.6F * turn, 0, 1.2F * turn},
                              .right = {.6F * turn, 0, -.8F * turn}, .up = {0, 1, 0},
                              .forward = {-.8F * turn, 0, -.6F * turn}, .y_extent = .1F);
        place_light(&world, EMITTER_DIRECTIONAL, at(0, 0, 0), at(1, 0, 0), 1);
        struct medium thin = {.scattering = {1e-3F, 1e-3F, 1e-3F}, .g = .6F * turn};
        trace(&world, NULL, &(struct look){.size = 8, .samples = 1, .paths = 30000, .medium = thin},
              &image);
        volumes[side] = mean_of_layer(&image, "volume");
    }
    /* Irradiance 1 along the view's path through a beam .4 wide, and twice the radius of the medium
     * on its way. */
    double expected = 1e-3 * .4 / .6 * (double)medium_phase(.6F, .8F) * exp(-1e-3 * 2 * 1.5);
    check_near("from the front over expected", volumes[0] / expected, 1, .002);
    check_near("from behind, for -g, over expected", volumes[1] / expected, 1, .002);
}

/* The error that is told is that between two seeds. */
TEST(noise) {
    OWNED(world) world;
    OWNED(image) image, other;
    double square = 0, told = 0;
    make_bright(&world);
    struct look look = {.size = 32, .samples = 1, .paths = 60000};
    trace(&world, NULL, &look, &image);
    look.seed = 1;
    trace(&world, NULL, &look, &other);
    int light = image_find_channel(&image, "caustic.G");
    int error = image_find_channel(&image, "standard_error.caustic.G");
    for (int i = 0; i < 32 * 32; i++) {
        const float *a = image_at(&image, i % 32, i / 32), *b = image_at(&other, i % 32, i / 32);
        square += pow((double)(a[light] - b[light]), 2);
        told += pow((double)a[error], 2) + pow((double)b[error], 2);
    }
    check_near("difference over errors", sqrt(square / told), 1, .25);
}

/* --- what is hard ----------------------------------------------------------------------------- */

enum hard {
    HARD_EYE_INSIDE,
    HARD_NESTED,
    HARD_OPEN,
    HARD_TOTAL,
    HARD_BLACK,
    HARD_LIGHT_INSIDE,
    HARD_WALL_INSIDE,
    HARD_COUNT
};

static void make_hard(struct world *world, enum hard hard) {
    world_init(world);
    make_glass(&world->materials[MATERIAL_SMOOTH], hard == HARD_TOTAL ? 1e6F : 1.5F);
    make_glass(&world->materials[MATERIAL_INNER], 1.8F);
    if (hard == HARD_BLACK)
        for (int c = 0; c < 3; c++)
            world->materials[MATERIAL_SMOOTH].absorption[c] = 1e6F;
    add_floor(world, 2);
    if (hard == HARD_OPEN)
        add_rectangle(world, MATERIAL_SMOOTH, at(-.5F, .5F, .5F), at(1, 0, 0), at(0, 0, -1));
    else
        add_ball(world, MATERIAL_SMOOTH, 16, at(0, .5F, 0), .3F);
    if (hard == HARD_NESTED)
        add_ball(world, MATERIAL_INNER, 16, at(0, .5F, 0), .2F);
    if (hard == HARD_WALL_INSIDE)
        add_box(world, MATERIAL_FLOOR, at(-.1F, .4F, -.1F), at(.1F, .6F, .1F));
    finish(world, 2);
    look_along(world, false);
    if (hard == HARD_EYE_INSIDE)
        memcpy(world->camera.eye, at(0, .5F, .2F).raw, sizeof(vec3s));
    bool inside = hard == HARD_LIGHT_INSIDE || hard == HARD_TOTAL;
    place_light(world, EMITTER_POINT, inside ? at(.1F, .5F, 0) : at(.3F, 1.5F, 0), at(0, -1, 0), 1);
}

TEST(hard) {
    static const char *const names[] = {"camera inside glass", "nested glass",
                                        "an open mesh",        "total reflection everywhere",
                                        "absorption of 1e6",   "a light inside glass",
                                        "a box inside glass"};
    for (int hard = 0; hard < HARD_COUNT; hard++) {
        OWNED(world) world;
        OWNED(image) image;
        make_hard(&world, (enum hard)hard);
        printf("    %s\n", names[hard]);
        struct light_tracer_result result =
            trace(&world, NULL,
                  &(struct look){.size = 16, .samples = 4, .paths = 20000, .medium = fog}, &image);
        check_finite(&image);
        check_balance(&result.balance);
        if (hard == HARD_TOTAL)
            assert_true(result.balance.cut > .9 * result.balance.emitted);
        if (hard == HARD_LIGHT_INSIDE)
            assert_true(mean_of_layer(&image, "caustic") > .01 &&
                        mean_of_layer(&image, "direct") == 0);
    }
}

/* Nothing is traced where there is nothing to bend light. */
TEST(no_glass) {
    OWNED(world) world;
    OWNED(image) image;
    world_in_sphere(&world);
    struct light_tracer_result result =
        trace(&world, NULL, &(struct look){.size = 8, .samples = 1, .paths = 1000}, &image);
    assert_false(result.has_smooth);
    check_near("caustic", mean_of_layer(&image, "caustic"), 0, 0);
    check_near("direct light", mean_of_layer(&image, "direct"), 1, 1e-3);
}

RUN_TESTS(NULL, NULL)
