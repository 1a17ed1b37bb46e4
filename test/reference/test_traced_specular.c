/* Specular surfaces in the path tracer: closed forms, and beside a path tracer that knows nothing
 * but to follow rays. */
#include "hand_made.h"

#include "reference/path.h"
#include "scene/lights/environment.h"

static void make_metal(struct material *material, vec3s color, float roughness) {
    material->metalness = 1;
    material->roughness = roughness;
    memcpy(material->base_color, color.raw, sizeof color.raw);
}

/* A floor of 2 x 2 m that is white metal, seen from straight above. */
static void make_floor(struct world *world, float roughness) {
    world_init(world);
    make_metal(&world->materials[0], glms_vec3_one(), roughness);
    add_rectangle(world, 0, at(-1, 0, 1), at(2, 0, 0), at(0, 0, -2));
    world_finish(world);
    look_down(world, -.1F, -.1F, .2F, 2);
}

/* --- closed forms ----------------------------------------------------------------------------- */

static void look_tilted(struct world *world, float cosine) {
    float sine = sqrtf(1 - cosine * cosine);
    world->camera =
        FILLED(camera, .orthographic = true, .eye = {2 * sine, 2 * cosine, 0}, .right = {0, 0, -1},
               .up = {-cosine, sine, 0}, .forward = {-sine, -cosine, 0}, .y_extent = .01F);
}

/* Under a sky of 1 a white metal shows its albedo. */
TEST(sky_of_one) {
    static const struct {
        float roughness, cosine;
        double albedo;
    } rows[] = {{1, 1, .306853},     {1, .5F, .450694},    {.5F, 1, .915812},
                {.5F, .5F, .857264}, {.25F, .1F, .896770}, {0, .5F, 1}};
    float texels[2][3] = {{1, 1, 1}, {1, 1, 1}};
    struct environment sky = {.width = 2, .height = 1, .texels = texels, .strength = 1};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        OWNED(world) world;
        OWNED(image) image;
        make_floor(&world, rows[i].roughness);
        look_tilted(&world, rows[i].cosine);
        struct path_tracer_desc desc = describe(&world, 8, 64);
        desc.emitters = (struct emitters){.sky = &sky};
        render(&desc, &image);
        printf("    roughness %.2f, cosine %.1f:", (double)rows[i].roughness,
               (double)rows[i].cosine);
        check_near("specular", mean_of(&image, CHANNEL_PATH_TRACER_END + SPECULAR_DIRECT),
                   rows[i].albedo, 3e-3);
        check_near("all", mean_of(&image, CHANNEL_BEAUTY),
                   mean_of(&image, CHANNEL_PATH_TRACER_END + SPECULAR_ALL), 1e-6);
    }
}

/* Straight above the floor, of radiance 2. */
static void place_lamp(struct world *world, enum emitter_shape shape) {
    static const struct {
        enum emitter_type type;
        float size[2];
    } lamps[] = {
        [EMITTER_IS_RECTANGLE] = {EMITTER_AREA, {2, 3}},
        [EMITTER_IS_DISK] = {EMITTER_AREA, {2, 0}},
        [EMITTER_IS_SPHERE] = {EMITTER_POINT, {2, 0}},
        [EMITTER_IS_CAP] = {EMITTER_DIRECTIONAL, {.6F, 0}},
    };
    struct emitter *light = &world->light;
    place_light(world, lamps[shape].type, at(0, 5, 0), at(0, -1, 0), 0);
    memcpy(light->size, lamps[shape].size, sizeof light->size);
    emitter_aim(light, (float[]){0, -1, 0});
    double radius = .5 * (double)light->size[0];
    double area = shape == EMITTER_IS_CAP      ? GLM_PI * pow(sin(radius), 2)
                  : shape == EMITTER_IS_SPHERE ? GLM_PI * radius * radius
                                               : emitter_extent(light);
    for (int c = 0; c < 3; c++)
        light->intensity[c] = (float)(2 * area);
}

/* Smooth metal shows lights as they are, though no surface is there. */
TEST(lamps_in_mirror) {
    static const char *const names[] = {"", "rectangle", "disk", "sphere", "sun"};
    for (int shape = EMITTER_IS_RECTANGLE; shape <= EMITTER_IS_CAP; shape++) {
        OWNED(world) world;
        OWNED(image) image;
        make_floor(&world, 0);
        place_lamp(&world, (enum emitter_shape)shape);
        struct path_tracer_desc desc = describe(&world, 8, 64);
        render(&desc, &image);
        check_near(names[shape], mean_of(&image, CHANNEL_PATH_TRACER_END + SPECULAR_DIRECT), 2,
                   .01);
    }
}

/* A light without a size: the BRDF itself. */
TEST(point_light) {
    OWNED(world) world;
    OWNED(image) image;
    make_floor(&world, .4F);
    place_light(&world, EMITTER_POINT, at(1.5F, 2, 0), at(0, -1, 0), 3);
    world.camera.y_extent = 1e-4F;
    struct path_tracer_desc desc = describe(&world, 4, 4);
    render(&desc, &image);
    vec3s to_light = vec3s_unit(at(1.5F, 2, 0));
    struct reflectance at_hit = material_reflectance(&world.materials[0]);
    struct brdf brdf = brdf_of(&world.materials[0], glms_vec3_one(), &at_hit);
    double expected =
        (double)(brdf_eval(&brdf, at(0, 1, 0), at(0, 1, 0), to_light).specular.x * to_light.y) * 3 /
        6.25;
    check_near("specular", mean_of(&image, CHANNEL_PATH_TRACER_END + SPECULAR_DIRECT), expected,
               1e-3 * expected);
}

/* --- normal maps ------------------------------------------------------------------------------ */

static vec3s normal_seen(const struct world *world, const struct hit_table *table, vec3s from) {
    struct triangle_point point = {0, .25F, .5F};
    struct hit hit;
    (void)world;
    hit_at(table, &point, glms_vec3_negate(from), &hit);
    return hit.normal;
}

static void check_direction(const char *what, vec3s seen, vec3s expected) {
    printf("    %s: %.3f %.3f %.3f\n", what, (double)seen.x, (double)seen.y, (double)seen.z);
    check_near("apart", glms_vec3_distance(seen, vec3s_unit(expected)), 0, 5e-3);
}

/* X follows u, Y goes against v, wherever these lie; the back's is the other way round. */
TEST(normal_map) {
    unsigned char texel[4] = {218, 166, 218, 255}; /* .71, .30, .71 */
    struct scene_texture texture = {.bitmap = {.width = 1, .height = 1, .rgba = texel},
                                    .linear = true};
    OWNED(world) world;
    struct hit_table table;
    world_init(&world);
    world.scene.textures = &texture;
    world.materials[0].normal_texture = 0;
    world.materials[0].normal_scale = 1;
    world.materials[0].double_sided = true;
    add_rectangle(&world, 0, at(0, 0, 0), at(3, 0, 0), at(0, 0, -1)); /* v runs to -z */
    world_finish(&world);
    hit_table_init(&table, &world.scene, &world.geometry, MATERIALS_FULL);
    check_direction("above", normal_seen(&world, &table, at(0, 1, 0)), at(.71F, .71F, .30F));
    check_direction("below", normal_seen(&world, &table, at(0, -1, 0)), at(-.71F, -.71F, -.30F));
    for (uint32_t i = 0; i < world.geometry.vertex_count; i++)
        world.geometry.uv[0][i][0] *= -1;
    check_direction("mirrored", normal_seen(&world, &table, at(0, 1, 0)), at(-.71F, .71F, .30F));
    world.materials[0].normal_scale = .5F;
    check_direction("half", normal_seen(&world, &table, at(0, 1, 0)), at(-.355F, .71F, .15F));
    table.materials = MATERIALS_DIFFUSE;
    check_direction("unread", normal_seen(&world, &table, at(0, 1, 0)), at(0, 1, 0));
}

/* --- beside a plain path tracer --------------------------------------------------------------- */

enum { SKY_WIDTH = 16, SKY_HEIGHT = 8 };

/* A corner: a floor of plastic, walls of gold and of diffuse red, a panel of rough metal aslant. */
static void make_corner(struct world *world) {
    world_init(world);
    world->materials[0].roughness = .35F;
    world->materials[0].base_color[0] = .8F;
    make_metal(&world->materials[1], at(1, .7F, .3F), .25F);
    world->materials[2].base_color[1] = .1F;
    make_metal(&world->materials[3], at(.9F, .9F, .9F), .7F);
    for (int m = 0; m < 4; m++)
        world->materials[m].double_sided = true;
    add_rectangle(world, 0, at(0, 0, 2), at(2, 0, 0), at(0, 0, -2));
    add_rectangle(world, 1, at(0, 0, 0), at(2, 0, 0), at(0, 2, 0));
    add_rectangle(world, 2, at(0, 0, 2), at(0, 0, -2), at(0, 2, 0));
    add_rectangle(world, 3, at(1, .5F, .5F), at(.8F, .3F, 0), at(0, .5F, .7F));
    world_finish(world);
    look_down(world, 0, 0, 2, 4);
}

static void paint_sky(float texels[][3]) {
    for (int i = 0; i < SKY_WIDTH * SKY_HEIGHT; i++)
        for (int c = 0; c < 3; c++)
            texels[i][c] = i == 40 ? 30 : .2F + .1F * (float)c;
}

/* Radiance of what a ray that meets no surface before `end` comes to. */
static vec3s light_along(const struct path_tracer_desc *desc, vec3s from, vec3s direction,
                         const struct hit *end) {
    vec3s sum = glms_vec3_zero();
    if (!end && desc->emitters.sky)
        environment_radiance(desc->emitters.sky, direction.raw, sum.raw);
    for (int n = 0; n < desc->emitters.count; n++) {
        const struct emitter *light = &desc->emitters.items[n];
        float place[2], distance;
        if (emitter_meet(light, from.raw, direction.raw, place, &distance) &&
            (!end || glms_vec3_distance(from, end->position) > distance))
            sum = glms_vec3_adds(sum, light->intensity[0] / (float)emitter_extent(light));
    }
    return sum;
}

static vec3s follow(const struct path_tracer_desc *desc, const struct ray_scene *rays,
                    struct hit hit, struct sampler *sampler) {
    vec3s sum = glms_vec3_zero(), share = glms_vec3_one();
    for (int i = 0; i <= desc->bounces; i++) {
        vec3s direction = brdf_sample(&hit.brdf, hit.normal, hit.towards, sampler_next(sampler));
        float cosine = glms_vec3_dot(hit.normal, direction);
        if (cosine <= 0 || glms_vec3_dot(hit.geometric_normal, direction) <= 0)
            break;
        struct brdf_value value = brdf_eval(&hit.brdf, hit.normal, hit.towards, direction);
        float density = brdf_density(&hit.brdf, hit.normal, hit.towards, direction);
        vec3s reflected =
            glms_vec3_muladds(hit.brdf.albedo, value.diffuse * GLM_1_PIf, value.specular);
        share = glms_vec3_scale(glms_vec3_mul(share, reflected), cosine / density);
        struct hit next;
        bool hits = ray_scene_hit(rays, ray_scene_departure(rays, &hit), direction, &next);
        vec3s light = light_along(desc, hit.position, direction, hits ? &next : NULL);
        sum = glms_vec3_add(sum, glms_vec3_mul(share, light));
        if (!hits)
            break;
        hit = next;
    }
    return sum;
}

/* The mean of each half of a picture, left and right, and its standard error. */
struct halves {
    double mean[2][3], error[2][3];
};

static struct halves follow_rays(const struct path_tracer_desc *desc, int count) {
    struct halves halves = {0};
    struct hit_table table;
    struct ray_scene rays;
    hit_table_init(&table, desc->scene, desc->geometry, MATERIALS_FULL);
    check_ok("rays", ray_scene_init(&rays, &table));
    for (int side = 0; side < 2; side++) {
        double sum[3] = {0}, squares[3] = {0};
        for (int i = 0; i < count; i++) {
            struct sampler sampler = {.seed = sampler_hash(9, (uint32_t)i), .index = (uint32_t)i};
            vec2s place = sampler_next(&sampler);
            struct hit hit;
            vec3s light = glms_vec3_zero();
            if (ray_scene_camera_hit(&rays, at(place.x + (float)side, 4, 2 * place.y), at(0, -1, 0),
                                     (float[]){0, INFINITY}, 0, &hit))
                light = follow(desc, &rays, hit, &sampler);
            for (int c = 0; c < 3; c++) {
                sum[c] += (double)light.raw[c];
                squares[c] += (double)(light.raw[c] * light.raw[c]);
            }
        }
        for (int c = 0; c < 3; c++) {
            double mean = sum[c] / count;
            halves.mean[side][c] = mean;
            halves.error[side][c] = sqrt((squares[c] / count - mean * mean) / count);
        }
    }
    ray_scene_free(&rays);
    return halves;
}

static double mean_of_half(const struct image *image, int side, int channel) {
    double sum = 0;
    int half = image->width / 2;
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < half; x++)
            sum += (double)image_at(image, x + side * half, y)[channel];
    return sum / half / image->height;
}

static void check_beside(const char *what, struct path_tracer_desc *desc) {
    static const char *const sides[] = {"left", "right"};
    OWNED(image) image;
    desc->bounces = 3;
    struct halves expected = follow_rays(desc, 400000);
    render(desc, &image);
    for (int side = 0; side < 2; side++)
        for (int c = 0; c < 3; c++) {
            double mean = expected.mean[side][c], error = expected.error[side][c];
            printf("    %s, %s, %d: error %.4f\n", what, sides[side], c, error);
            check_near("mean", mean_of_half(&image, side, CHANNEL_BEAUTY + c), mean,
                       3.5 * error + 2e-3 * mean);
        }
}

TEST(under_sky) {
    float texels[SKY_WIDTH * SKY_HEIGHT][3];
    struct environment sky = {
        .width = SKY_WIDTH, .height = SKY_HEIGHT, .texels = texels, .strength = 1};
    OWNED(world) world;
    paint_sky(texels);
    make_corner(&world);
    struct path_tracer_desc desc = describe(&world, 16, 256);
    desc.emitters = (struct emitters){.sky = &sky};
    check_beside("sky", &desc);
}

TEST(under_lamp) {
    OWNED(world) world;
    make_corner(&world);
    place_lamp(&world, EMITTER_IS_RECTANGLE);
    world.light.position[0] = world.light.position[2] = 1.5F;
    world.light.position[1] = 3;
    struct path_tracer_desc desc = describe(&world, 16, 256);
    check_beside("lamp", &desc);
}

/* --- noise, and the other setting ------------------------------------------------------------- */

/* Between seeds pictures differ by as much as each says of itself. */
TEST(noise) {
    enum { SEEDS = 24, SIZE = 12 };
    double estimated = 0, spread = 0, sums[SIZE * SIZE] = {0}, squares[SIZE * SIZE] = {0};
    OWNED(world) world;
    make_corner(&world);
    place_lamp(&world, EMITTER_IS_RECTANGLE);
    for (uint32_t seed = 0; seed < SEEDS; seed++) {
        struct path_tracer_desc desc = describe(&world, SIZE, 16);
        OWNED(image) image;
        desc.bounces = 2;
        desc.seed = seed;
        render(&desc, &image);
        for (int i = 0; i < SIZE * SIZE; i++) {
            const float *specular = image_at(&image, i % SIZE, i / SIZE) + CHANNEL_PATH_TRACER_END;
            estimated += pow((double)specular[SPECULAR_STANDARD_ERROR], 2) / SEEDS;
            sums[i] += (double)specular[SPECULAR_ALL];
            squares[i] += pow((double)specular[SPECULAR_ALL], 2);
        }
    }
    for (int i = 0; i < SIZE * SIZE; i++)
        spread += (squares[i] - sums[i] * sums[i] / SEEDS) / (SEEDS - 1);
    check_near("estimated over seen variance", estimated / spread, 1, .25);
}

/* The other setting shows specular scenes as diffuse ones of the same colours, bit for bit. */
TEST(diffuse) {
    OWNED(world) world;
    OWNED(image) specular, diffuse;
    make_corner(&world);
    place_lamp(&world, EMITTER_IS_RECTANGLE);
    struct path_tracer_desc desc = describe(&world, 16, 4);
    desc.bounces = 2;
    desc.materials = MATERIALS_DIFFUSE;
    render(&desc, &specular);
    desc.materials = MATERIALS_FULL;
    for (int m = 0; m < MAX_MATERIALS; m++) {
        world.materials[m].metalness = 0;
        world.materials[m].roughness = 1;
    }
    render(&desc, &diffuse);
    assert_int_equal(specular.channel_count, diffuse.channel_count);
    assert_memory_equal(specular.pixels, diffuse.pixels,
                        sizeof(float) * 16 * 16 * (size_t)diffuse.channel_count);
}

/* The eye sees its colour, and light nothing. */
TEST(unlit) {
    OWNED(world) world;
    OWNED(image) image;
    make_corner(&world);
    place_lamp(&world, EMITTER_IS_RECTANGLE);
    for (int m = 0; m < MAX_MATERIALS; m++)
        world.materials[m].unlit = true;
    struct path_tracer_desc desc = describe(&world, 8, 4);
    desc.bounces = 1;
    render(&desc, &image);
    check_near("beauty", image_at(&image, 1, 5)[CHANNEL_BEAUTY], .8, 1e-6);
    check_near("emitted", image_at(&image, 1, 5)[CHANNEL_EMITTED], .8, 1e-6);
    check_near("albedo", image_at(&image, 1, 5)[CHANNEL_ALBEDO], 0, 0);
}

/* --- rounding --------------------------------------------------------------------------------- */

/* A place above the horizon, as long as the way there is not scaled to length 1. */
static vec3s place_on_horizon(vec3s normal) {
    for (float x = 1; x < 2; x += 1e-3F) {
        vec3s place = at(x, -normal.x * x / normal.y, .3F);
        if (glms_vec3_dot(normal, place) > 0 && glms_vec3_dot(normal, vec3s_unit(place)) <= 0)
            return place;
    }
    fail_msg("no such place");
    return normal;
}

/* A light vertex there sends nothing: a facet of a gem had a pixel that was not a number. */
TEST(light_on_horizon) {
    OWNED(world) world;
    make_floor(&world, 0);
    struct path_tracer_desc desc = describe(&world, 1, 1);
    struct hit_table table;
    struct ray_scene rays;
    struct emission emission;
    hit_table_init(&table, &world.scene, &world.geometry, MATERIALS_FULL);
    check_ok("rays", ray_scene_init(&rays, &table));
    emission_init(&emission, &desc.emitters, &world.geometry, &table, 0);
    struct hit x;
    assert_true(ray_scene_hit(&rays, at(.1F, 1, .2F), at(0, -1, 0), &x));
    x.normal = x.geometric_normal = x.towards = vec3s_unit(at(-.3F, .9F, 0));
    struct light_vertices lights = {.items = mem_alloc(LIGHT_VERTEX_COUNT, sizeof *lights.items)};
    for (int i = 0; i < LIGHT_VERTEX_COUNT; i++)
        lights.items[i] =
            FILLED(light_vertex, .position = glms_vec3_add(x.position, place_on_horizon(x.normal)),
                   .normal = glms_vec3_negate(x.normal), .radiance = glms_vec3_one(), .density = 1,
                   .diffuse = true);
    struct path_scene scene = {&rays, &emission, 1};
    struct sampler sampler = {0};
    struct reflected light = path_indirect(&scene, &lights, &x, &sampler);
    check_near("specular", light.specular.x, 0, 1e-6);
    mem_free(lights.items);
    emission_free(&emission);
    ray_scene_free(&rays);
}

RUN_TESTS(NULL, NULL)
