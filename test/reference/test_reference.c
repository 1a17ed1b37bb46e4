/* The path tracer against closed forms. */
#include "hand_made.h"

/* The mean over the square that look_down sees, by the midpoint rule. */
static double mean_on_floor(const struct world *world,
                            double (*value)(const struct world *, double, double)) {
    enum { STEPS = 400 };
    const struct camera *camera = &world->camera;
    double sum = 0, size = 2 * camera->y_extent;
    for (int j = 0; j < STEPS; j++)
        for (int i = 0; i < STEPS; i++)
            sum += value(world, camera->eye[0] + size * ((i + 0.5) / STEPS - 0.5),
                         camera->eye[2] + size * ((j + 0.5) / STEPS - 0.5));
    return sum / STEPS / STEPS;
}

/* I cos / (pi d^2) within the cone, by the formula of KHR_lights_punctual. */
static double floor_direct(const struct world *world, double x, double z) {
    const struct emitter *light = &world->light;
    double dx = x - light->position[0], dy = -light->position[1], dz = z - light->position[2];
    double distance = sqrt(dx * dx + dy * dy + dz * dz), cone = 1;
    double cos_axis =
        (dx * light->direction[0] + dy * light->direction[1] + dz * light->direction[2]) / distance;
    if (light->type == EMITTER_SPOT) {
        double range = fmax(0.001, light->cos_inner - light->cos_outer);
        cone = fmin(fmax((cos_axis - light->cos_outer) / range, 0), 1);
    }
    return light->intensity[0] * cone * cone * (-dy / distance) / (GLM_PI * distance * distance);
}

TEST(light_on_floor) {
    OWNED(world) world;
    OWNED(image) image;
    world_init(&world);
    add_rectangle(&world, 0, (vec3s){{-5, 0, 5}}, (vec3s){{10, 0, 0}}, (vec3s){{0, 0, -10}});
    world_finish(&world);
    look_down(&world, -1, -1, 3, 4);
    static const struct {
        const char *what;
        enum emitter_type type;
        double inner, outer;
    } cases[] = {{"point light", EMITTER_POINT, 0, 0},
                 {"hard spot", EMITTER_SPOT, 29.9, 30},
                 {"soft spot", EMITTER_SPOT, 10, 40}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        place_light(&world, cases[i].type, (vec3s){{0.3f, 2, -0.2f}}, (vec3s){{0.2f, -1, 0.1f}}, 7);
        world.light.cos_inner = cosf(glm_rad((float)cases[i].inner));
        world.light.cos_outer = cosf(glm_rad((float)cases[i].outer));
        struct path_tracer_desc desc = describe(&world, 32, 64);
        render(&desc, &image);
        double expected = mean_on_floor(&world, floor_direct);
        /* 65536 stratified samples; the hard edge leaves about a tenth of a thousandth. */
        check_near(cases[i].what, mean_of(&image, CHANNEL_DIRECT), expected, 5e-4 * expected);
        check_near("beauty = albedo x direct", mean_of(&image, CHANNEL_BEAUTY), 0.5 * expected,
                   5e-4 * expected);
        check_near("no bounce asked for", mean_of(&image, CHANNEL_INDIRECT), 0, 0);
        check_near("depth", image_at(&image, 16, 16)[CHANNEL_DEPTH], 4, 1e-5);
        check_near("normal", image_at(&image, 16, 16)[CHANNEL_NORMAL + 1], 1, 1e-6);
        image_free(&image);
    }
    place_light(&world, EMITTER_DIRECTIONAL, glms_vec3_zero(), (vec3s){{1, -1, 0}}, 3);
    struct path_tracer_desc desc = describe(&world, 8, 4);
    render(&desc, &image);
    check_near("directional light", mean_of(&image, CHANNEL_DIRECT), 3 * sqrt(0.5) / GLM_PI, 1e-6);
}

/* Every pair of points of a sphere has the geometry term 1 / (4 R^2): each bounce is the
 * albedo times the one before, in every pixel. */
TEST(sphere) {
    OWNED(world) world;
    struct image image;
    world_in_sphere(&world);
    /* The facets' centres lie (pi / 64)^2 / 8 = 3e-4 nearer than the vertices, and light falls off
     * by the square: a thousandth covers it and the noise of the means. */
    double series = 0, power = 1;
    for (int bounces = 1; bounces <= 6; bounces += 5) {
        struct path_tracer_desc desc = describe(&world, 16, 128);
        desc.bounces = bounces;
        struct path_tracer_progress reached = render(&desc, &image);
        check_near("direct radiance over albedo", mean_of(&image, CHANNEL_DIRECT), 1, 1e-3);
        for (series = 0, power = 0.5; power > pow(0.5, bounces + 0.5); power /= 2)
            series += power;
        check_near("bounces", mean_of(&image, CHANNEL_INDIRECT), series, 1e-3 * series);
        check_near("partial sum of the series", mean_of(&image, CHANNEL_BEAUTY), 0.5 * (1 + series),
                   1e-3);
        /* In all pixels: the spread is the noise, and what the facets leave. */
        check_at_most("spread over the pixels", spread_about(&image, CHANNEL_INDIRECT, series),
                      reached.noise + 1e-3);
        check_at_most("noise", reached.noise, 0.005);
        image_free(&image);
    }
}

/* Irradiance over pi at a point from a polygon of radiance 1, all of it above the horizon:
 * Lambert's formula, 1/(2 pi) sum over the edges of angle x (unit normal of the edge's plane
 * . n). */
static double lambert_formula(const vec3s polygon[4], vec3s point, vec3s normal) {
    double sum = 0;
    for (int i = 0; i < 4; i++) {
        vec3s a = glms_vec3_sub(polygon[i], point), b = glms_vec3_sub(polygon[(i + 1) % 4], point);
        sum += glms_vec3_angle(a, b) * glms_vec3_dot(vec3s_unit_cross(a, b), normal);
    }
    return fabs(sum) / (2 * GLM_PI);
}

/* A directional light of 1 W/m2 across meets only the second rectangle, of albedo 0.5, squarely. */
static const double lit_radiance = 0.5 / GLM_PI;

static const vec3s wall[4] = {{{0, 0, 0}}, {{0, 0, 1}}, {{0, 1, 1}}, {{0, 1, 0}}};
static const vec3s lid[4] = {{{2, 1, 0}}, {{3, 1, 0}}, {{3, 1, 1}}, {{2, 1, 1}}};

static double floor_from_wall(const struct world *world, double x, double z) {
    (void)world;
    vec3s point = {{(float)x, 0, (float)z}}, up = {{0, 1, 0}};
    return lit_radiance * lambert_formula(wall, point, up);
}

static double floor_from_lid(const struct world *world, double x, double z) {
    (void)world;
    vec3s point = {{(float)x, 0, (float)z}}, up = {{0, 1, 0}};
    return lit_radiance * lambert_formula(lid, point, up);
}

static void check_one_bounce(struct world *world, const char *what,
                             double (*expected_at)(const struct world *, double, double)) {
    struct image image;
    struct path_tracer_desc desc = describe(world, 16, 1024);
    desc.bounces = 1;
    double expected = mean_on_floor(world, expected_at);
    double noise = render(&desc, &image).noise;
    /* The noise of a mean over 256 pixels, three times. */
    check_near(what, mean_of(&image, CHANNEL_INDIRECT), expected,
               (1e-3 + 3 * noise / 16) * expected);
    check_at_most("that tolerance, relative", 1e-3 + 3 * noise / 16, 4e-3);
    check_near("the floor has no direct light", mean_of(&image, CHANNEL_DIRECT), 0, 1e-9);
    image_free(&image);
}

TEST(rectangles) {
    OWNED(world) world;
    world_init(&world);
    add_rectangle(&world, 0, (vec3s){{0, 0, 1}}, (vec3s){{1, 0, 0}}, (vec3s){{0, 0, -1}});
    add_rectangle(&world, 0, (vec3s){{0, 0, 1}}, (vec3s){{0, 0, -1}}, (vec3s){{0, 1, 0}});
    world_finish(&world);
    look_down(&world, 0, 0, 1, 3);
    place_light(&world, EMITTER_DIRECTIONAL, glms_vec3_zero(), (vec3s){{-1, 0, 0}}, 1);
    check_one_bounce(&world, "perpendicular rectangles", floor_from_wall);
    world_free(&world);

    world_init(&world);
    add_rectangle(&world, 0, (vec3s){{0, 0, 1}}, (vec3s){{1, 0, 0}}, (vec3s){{0, 0, -1}});
    add_rectangle(&world, 0, (vec3s){{2, 1, 0}}, (vec3s){{1, 0, 0}}, (vec3s){{0, 0, 1}});
    world_finish(&world);
    look_down(&world, 0, 0, 1, 3);
    place_light(&world, EMITTER_DIRECTIONAL, glms_vec3_zero(), (vec3s){{0, 1, 0}}, 1);
    check_one_bounce(&world, "parallel rectangles", floor_from_lid);
}

RUN_TESTS(NULL, NULL)
