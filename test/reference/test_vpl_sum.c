/* The sum over virtual point lights with ray-traced visibility, against closed forms and against
 * the path tracer. */
#include "hand_made.h"

#include "base/halton.h"
#include "reference/scene/emission.h"
#include "reference/vpl_sum.h"

static struct vpl_sum_desc sum_desc(struct world *world, const struct vpl *vpls, int count,
                                    int size) {
    return FILLED(vpl_sum_desc, .scene = &world->scene, .geometry = &world->geometry,
                  .camera = &world->camera, .emitters = {.items = &world->light, .count = 1},
                  .vpls = vpls, .vpl_count = count, .width = size, .height = size);
}

/* VPL i of the world's spot or point light, from the light's first hit. */
static struct vpl trace_vpl(const struct world *world, const struct emission *emission,
                            const struct ray_scene *rays, int i, int count) {
    vec2s sample = {
        {(float)radical_inverse(2, (uint32_t)i), (float)radical_inverse(3, (uint32_t)i)}};
    struct hit hit;
    if (!emission_first_hit(emission, 0, rays, (vec2s){{0, 0}}, sample, &hit))
        return (struct vpl){.flux = {0}};
    const float *p = hit.position.raw, *n = hit.normal.raw;
    vec3s from = {{world->light.position[0], world->light.position[1], world->light.position[2]}};
    vec3s axis = {
        {world->light.direction[0], world->light.direction[1], world->light.direction[2]}};
    vec3s way = vec3s_unit(glms_vec3_sub(hit.position, from));
    float intensity =
        world->light.intensity[0] * emitter_cone(&world->light, glms_vec3_dot(way, axis));
    float flux = hit.brdf.albedo.x * intensity * emission->sources[0].solid_angle / (float)count;
    return FILLED(vpl, .position = {p[0], p[1], p[2]}, .normal = {n[0], n[1], n[2]},
                  .flux = {flux, flux, flux}, .reach = 1);
}

static struct vpl *trace_vpls(struct world *world, int count) {
    struct hit_table table;
    struct ray_scene rays;
    struct vpl *vpls = mem_alloc((size_t)count, sizeof *vpls);
    hit_table_init(&table, &world->scene, &world->geometry, MATERIALS_FULL);
    check_ok("rays", ray_scene_init(&rays, &table));
    struct emission emission;
    emission_init(&emission, &(struct emitters){.items = &world->light, .count = 1},
                  &world->geometry, NULL, 0);
    for (int i = 0; i < count; i++)
        vpls[i] = trace_vpl(world, &emission, &rays, i, count);
    emission_free(&emission);
    ray_scene_free(&rays);
    return vpls;
}

/* Any VPLs whose flux sums to the reflected flux give albedo x direct in every pixel;
 * and nothing inside a sphere hides anything. */
TEST(sphere) {
    OWNED(world) world;
    OWNED(image) image;
    world_in_sphere(&world);
    struct vpl *vpls = trace_vpls(&world, 37);
    struct vpl_sum_desc desc = sum_desc(&world, vpls, 37, 32);
    check_ok("sum", vpl_sum_render(&desc, &image));
    /* Facets lie 3e-4 within the sphere, at both ends of a ray; and turn by 0.025 against it, which
     * counts where pixel and VPL are near. One VPL hidden would be 1/37. */
    check_near("mean", mean_of(&image, CHANNEL_INDIRECT), 0.5, 1e-3);
    check_at_most("spread over the pixels", spread_about(&image, CHANNEL_INDIRECT, 0.5), 5e-3);
    check_near("direct", mean_of(&image, CHANNEL_DIRECT), 1, 1e-3);
    check_near("beauty", mean_of(&image, CHANNEL_BEAUTY), 0.75, 1e-3);
    free(vpls);
}

/* A floor of which the camera sees [0, 1]^2 and a rectangle above that hides the VPL from x < 1/2:
 * the VPL is over x = 1/2, so the shadow's edge is there too. */
TEST(one_vpl) {
    OWNED(world) world;
    world_init(&world);
    add_rectangle(&world, 0, (vec3s){{-2, 0, 3}}, (vec3s){{5, 0, 0}}, (vec3s){{0, 0, -5}});
    add_rectangle(&world, 0, (vec3s){{-2, 0.25f, 3}}, (vec3s){{2.5f, 0, 0}}, (vec3s){{0, 0, -5}});
    world_finish(&world);
    look_down(&world, 0, 0, 1, 0.2f); /* from below the rectangle */
    struct vpl vpl = {.position = {0.5f, 0.5f, 0.5f},
                      .normal = {0, -1, 0},
                      .area = 0.3f,
                      .flux = {2, 1, 0},
                      .reach = 1};
    struct vpl_sum_desc desc = sum_desc(&world, &vpl, 1, 4);
    desc.emitters.count = 0;
    /* At the pixel whose centre is (5/8, 5/8); cos = height / d at both ends. */
    const double height = 0.5, distance2 = 2.0 / 64 + height * height;
    const double cosines = height * height / distance2, unit = 2 / (GLM_PI * GLM_PI);
    const double values[] = {cosines / distance2, 2, cosines / (distance2 + 0.3 / GLM_PI)};
    static const char *const names[] = {"unbounded", "clamped", "disk"};
    desc.term.clamp_value = 2;
    for (int bound = GEOMETRY_UNBOUNDED; bound <= GEOMETRY_DISK; bound++) {
        OWNED(image) image;
        desc.term.bound = (enum geometry_bound)bound;
        desc.unshadowed = false;
        check_ok("sum", vpl_sum_render(&desc, &image));
        check_near(names[bound], image_at(&image, 2, 2)[CHANNEL_INDIRECT], unit * values[bound],
                   1e-5);
        check_near("green", image_at(&image, 2, 2)[CHANNEL_INDIRECT + 1], unit / 2 * values[bound],
                   1e-5);
        check_near("in the shadow", image_at(&image, 1, 2)[CHANNEL_INDIRECT], 0, 0);
        check_near("no light, no direct light", mean_of(&image, CHANNEL_DIRECT), 0, 0);
        image_free(&image);
        desc.unshadowed = true;
        check_ok("sum", vpl_sum_render(&desc, &image));
        check_near("unshadowed", image_at(&image, 1, 2)[CHANNEL_INDIRECT], unit * values[bound],
                   1e-5);
    }
    vpl.reach = 0;
    OWNED(image) image;
    check_ok("sum", vpl_sum_render(&desc, &image));
    check_near("a sample that met nothing", mean_of(&image, CHANNEL_INDIRECT), 0, 0);
}

/* Two implementations of one integral: a spot lights part of a wall, a screen stands between wall
 * and floor. */
TEST(against_path_tracer) {
    OWNED(world) world;
    OWNED(image) sum, traced;
    world_init(&world);
    add_rectangle(&world, 0, (vec3s){{0, 0, 1}}, (vec3s){{1, 0, 0}}, (vec3s){{0, 0, -1}});
    add_rectangle(&world, 0, (vec3s){{0, 0, 1}}, (vec3s){{0, 0, -1}}, (vec3s){{0, 1.5f, 0}});
    add_rectangle(&world, 0, (vec3s){{0.2f, 0, 0.8f}}, (vec3s){{0, 0.3f, 0}},
                  (vec3s){{0, 0, -0.5f}});
    world_finish(&world);
    look_down(&world, 0, 0, 1, 3);
    place_light(&world, EMITTER_SPOT, (vec3s){{0.9f, 0.9f, 0.5f}}, (vec3s){{-1, 0.1f, 0}}, 5);
    world.light.cos_inner = cosf(0.2f);
    world.light.cos_outer = cosf(0.4f);
    struct path_tracer_desc path_desc = describe(&world, 24, 128);
    path_desc.bounces = 1;
    double noise = render(&path_desc, &traced).noise;
    struct vpl *vpls = trace_vpls(&world, 4096);
    struct vpl_sum_desc desc = sum_desc(&world, vpls, 4096, 24);
    check_ok("sum", vpl_sum_render(&desc, &sum));
    double mean = mean_of(&traced, CHANNEL_INDIRECT), squares = 0;
    for (int y = 0; y < 24; y++)
        for (int x = 0; x < 24; x++)
            squares += pow(image_at(&sum, x, y)[CHANNEL_INDIRECT] -
                               image_at(&traced, x, y)[CHANNEL_INDIRECT],
                           2);
    /* The VPLs' own error is about 1 / sqrt 4096 of a small variance; edges of the screen's shadow
     * fall within pixels of which the sum sees the centres alone. */
    check_near("mean", mean_of(&sum, CHANNEL_INDIRECT), mean, 0.01 * mean);
    check_at_most("relative RMSE", sqrt(squares / 24 / 24) / mean, noise + 0.03);
    free(vpls);
}

RUN_TESTS(NULL, NULL)
