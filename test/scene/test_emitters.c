/* Several lights: which of them shine, what each is worth, and that the reference adds them up. */
#include "base/unit.h"
#include "hand_made.h"

#include "base/deal.h"
#include "scene/node.h"
#include "scene/placing.h"

/* --- dealing ---------------------------------------------------------------------------------- */

static void check_deal(const double *weights, int takers, int things, const int *expected) {
    struct dealt *dealt = mem_alloc((size_t)things, sizeof *dealt);
    int counts[4], got[4] = {0};
    deal(weights, takers, dealt, things, counts);
    for (int i = 0; i < things; i++)
        assert_int_equal(dealt[i].number, got[dealt[i].taker]++);
    for (int t = 0; t < takers; t++) {
        check_near("share", counts[t], expected[t], 0);
        assert_int_equal(counts[t], got[t]);
    }
    free(dealt);
}

/* Whole shares, their sum, one at least, none for nothing, and all alike where none weighs. */
TEST(deal_counts) {
    check_deal((double[]){3}, 1, 7, (int[]){7});
    check_deal((double[]){1, 1}, 2, 8, (int[]){4, 4});
    check_deal((double[]){5, 2, 1}, 3, 16, (int[]){10, 4, 2});
    check_deal((double[]){1, 0, 2}, 3, 9, (int[]){3, 0, 6});
    check_deal((double[]){1, 1e-9, 1e-9}, 3, 16, (int[]){14, 1, 1});
    check_deal((double[]){1, 3, 2}, 3, 2, (int[]){0, 1, 1});
    check_deal((double[]){0, 0}, 2, 6, (int[]){3, 3});
    check_deal((double[]){6.4, 1.2, .4}, 3, 8, (int[]){6, 1, 1});
}

/* Any run has each taker's within one of its weight. */
TEST(deal_runs) {
    enum { THINGS = 1024, RUN = 16 };
    static const double weights[] = {.62, .3, .08};
    struct dealt dealt[THINGS];
    deal(weights, 3, dealt, THINGS, NULL);
    double worst = 0;
    for (int first = 0; first + RUN <= THINGS; first++) {
        int got[3] = {0};
        for (int i = first; i < first + RUN; i++)
            got[dealt[i].taker]++;
        for (int t = 0; t < 3; t++)
            worst = fmax(worst, fabs(got[t] - RUN * weights[t]));
    }
    check_at_most("farthest of a run from its weights", worst, 1.5);
}

/* --- shapes ----------------------------------------------------------------------------------- */

/* A ray to a place of the shape comes to that place, and no other that passes it does. */
static void check_meet(const char *what, enum emitter_type type, float width, float height) {
    struct emitter light = emitter_new(type);
    double worst = 0;
    int met = 0, passed = 0;
    glm_vec3_copy((vec3){1, 2, 3}, light.position);
    light.size[0] = width, light.size[1] = height;
    emitter_aim(&light, (float[]){.6F, -.7F, .2F});
    for (int i = 0; i < 256; i++) {
        const float place[2] = {((float)(i % 16) + .5F) / 16, ((float)(i / 16) + .5F) / 16};
        struct emitter piece = emitter_piece(&light, place);
        vec3 origin, direction, beside;
        float at[2], distance;
        glm_vec3_copy(light.position, origin);
        glm_vec3_muladds(light.direction, 5, origin);
        if (emitter_shape(&light) == EMITTER_IS_CAP)
            glm_vec3_negate_to(piece.direction, direction);
        else
            glm_vec3_sub(piece.position, origin, direction);
        vec3_unit(direction);
        bool hit = emitter_meet(&light, origin, direction, at, &distance);
        if (hit) { /* of a sphere, the side that is seen */
            double turned = fabs((double)(at[1] - place[1]));
            worst =
                fmax(worst, emitter_shape(&light) == EMITTER_IS_SPHERE
                                ? 0
                                : fmax(fabs((double)(at[0] - place[0])), fmin(turned, 1 - turned)));
            assert_true(distance > 0 && at[0] >= 0 && at[0] <= 1 && at[1] >= 0 && at[1] <= 1);
        }
        met += hit;
        glm_vec3_add(direction, light.right, beside);
        vec3_unit(beside);
        passed += !emitter_meet(&light, origin, beside, at, &distance);
        assert_false(emitter_meet(&light, origin, light.direction, at, &distance)); /* away */
    }
    printf("    %-16s %d of 256 places met, %d rays beside it pass, off by %.2g\n", what, met,
           passed, worst);
    assert_true(emitter_shape(&light) == EMITTER_IS_SPHERE ? met > 100 : met == 256);
    assert_int_equal(passed, 256);
    assert_true(worst < 1e-3);
    assert_true(emitter_extent(&light) > 0);
}

TEST(meet) {
    check_meet("rectangle", EMITTER_AREA, .5F, .25F);
    check_meet("disk", EMITTER_AREA, .5F, 0);
    check_meet("spot's disk", EMITTER_SPOT, .5F, 0);
    check_meet("sphere", EMITTER_POINT, .5F, 0);
    check_meet("sun", EMITTER_DIRECTIONAL, .2F, 0);
    struct emitter point = emitter_new(EMITTER_POINT);
    float at[2], distance;
    assert_false(emitter_meet(&point, (float[]){0, 1, 0}, (float[]){0, -1, 0}, at, &distance));
    assert_true(emitter_extent(&point) == 0);
}

/* --- which shine ------------------------------------------------------------------------------ */

static void check_picked(const struct scene *scene, const char *text, const char *expected) {
    OWNED(emitters) emitters = {0};
    check_ok(text ? text : "all", emitters_from_text(&emitters, scene, text, 0));
    char *got = emitters_to_text(&emitters, scene, 0);
    printf("    %-48s %s\n", text ? text : "all", got);
    assert_string_equal(got, expected);
    /* What was written names the very same lights. */
    OWNED(emitters) again = {0};
    check_ok(got, emitters_from_text(&again, scene, got, 0));
    assert_int_equal(again.count, emitters.count);
    assert_memory_equal(again.items, emitters.items, (size_t)again.count * sizeof *emitters.items);
    free(got);
}

TEST(texts) {
    OWNED(scene) scene;
    check_ok("scene", scene_load(&scene, "scenes/three-lights.glb"));
    check_picked(&scene, NULL, "0,1,2");
    check_picked(&scene, "", "0,1,2");
    check_picked(&scene, "blue", "1");
    check_picked(&scene, "lamp,0", "0,2");
    check_picked(&scene, "2, red, 2", "0,2");
    check_picked(&scene, "lamp position=0,2,0 intensity=5,5,5; 1",
                 "1; 2 position=0,2,0 intensity=5,5,5");
    check_picked(&scene, "lamp size=0.25,0; red size=2,1", "0 size=2,1; 2 size=0.25,0");
    check_picked(&scene, "red,blue intensity=1,2,3", "0 intensity=1,2,3; 1 intensity=1,2,3");
    check_picked(&scene, "intensity=7,7,7; lamp intensity=1,1,1",
                 "0 intensity=7,7,7; 1 intensity=7,7,7; 2 intensity=1,1,1");
    check_picked(&scene, "lamp type=area size=1,2; red cone=0.9,0.5",
                 "0 cone=0.899999976,0.5; 2 size=1,2 type=area");
    check_picked(&scene, "+point position=1,2,3 size=.5,0; blue; +directional",
                 "1; +point position=1,2,3 size=0.5,0; +directional");
    check_picked(&scene, "+area type=spot", "+spot");
}

static void rename_node(struct scene *scene, enum node_kind kind, int n, const char *name) {
    snprintf(scene->nodes[node_carrying(scene, kind, n)].name, SCENE_NAME_SIZE, "%s", name);
}

/* Names with what parts lists: alone by the whole name, else by number. */
TEST(names_with_signs) {
    static const char *const names[] = {"Sun, warm", "key; w=1,2,3", "a=b"};
    OWNED(scene) scene;
    struct camera camera;
    int n;
    check_ok("scene", scene_load(&scene, "scenes/three-lights.glb"));
    for (int i = 0; i < 3; i++) {
        char number[2] = {(char)('0' + i), 0};
        rename_node(&scene, NODE_LIGHT, i, names[i]);
        check_picked(&scene, names[i], number);
    }
    check_picked(&scene, "0,2", "0,2");
    check_picked(&scene, "1 size=1,0", "1 size=1,0");
    for (int i = 0; i < 3; i++) {
        rename_node(&scene, NODE_CAMERA, 0, names[i]);
        n = -1;
        check_ok(names[i], camera_from_text(&camera, &scene, names[i], 0, &n));
        assert_int_equal(n, 0);
    }
    rename_node(&scene, NODE_CAMERA, 0, "");
    rename_node(&scene, NODE_LIGHT, 2, "");
    snprintf(scene.lights[2].name, SCENE_NAME_SIZE, "of the light");
    snprintf(scene.cameras[0].name, SCENE_NAME_SIZE, "of the camera");
    struct emitters emitters = {0};
    assert_false(emitters_from_text(&emitters, &scene, "none", 0));
    assert_string_equal(error_get(),
                        "no light 'none' (there is: 0=Sun, warm 1=key; w=1,2,3 2=of the light)");
    assert_false(camera_from_text(&camera, &scene, "none", 0, NULL));
    assert_string_equal(error_get(), "no camera 'none' (there is: 0=of the camera)");
}

/* All area lights by one word, which without any is a name like others. */
TEST(emitters_text) {
    OWNED(scene) scene;
    struct emitters emitters = {0};
    check_ok("scene", scene_load(&scene, "scenes/table.glb"));
    check_picked(&scene, "emitters", "0");
    check_picked(&scene, "emitters size=2,1", "0 size=2,1");
    scene_free(&scene);
    check_ok("scene", scene_load(&scene, "scenes/three-lights.glb"));
    assert_false(emitters_from_text(&emitters, &scene, "emitters", 0));
    assert_string_equal(error_get(), "no light 'emitters' (there is: 0=red 1=blue 2=lamp)");
}

TEST(text_refusals) {
    static const struct {
        const char *text, *error;
    } rows[] = {
        {"green", "no light 'green' (there is: 0=red 1=blue 2=lamp)"},
        {"red,3", "no light '3' (there is: 0=red 1=blue 2=lamp)"},
        {"red; 7 intensity=1,1,1", "no light '7' (there is: 0=red 1=blue 2=lamp)"},
        {"red intensity=1,2", "light: 'intensity=1,2' wants 3 numbers, as in intensity=0,1,0"},
        {"red colour=1", "light: 'colour=1' is not understood"},
        {",", "light: ',' names none"},
        {"red size=1", "light: 'size=1' wants 2 numbers, as in size=1,0"},
        {"red size=1,-1", "light: size=1,-1: less than none"},
        {"red cone=.5,.9", "light: cone=0.5,0.9: cosines, and the first is the greater one"},
        {"red type=lamp", "light: 'type=lamp': there is spot, point, directional, area"},
        {"red; +lamp", "light: '+lamp' is no type of light"},
        {"red intensity=1,2,nan",
         "light: 'intensity=1,2,nan' wants 3 numbers, as in intensity=0,1,0"},
        {"red intensity=1;2,3", "light: 'intensity=1' wants 3 numbers, as in intensity=0,1,0"},
        {"red size", "no light 'red size' (there is: 0=red 1=blue 2=lamp)"},
        {"red size=1,0 type", "light: 'type': there is spot, point, directional, area"},
        {"red size=-1,0", "light: size=-1,0: less than none"},
        {"red cone=2,0", "light: cone=2,0: cosines, and the first is the greater one"},
        {"red cone=0,-2", "light: cone=0,-2: cosines, and the first is the greater one"},
        {"red intensity=1,2,1e38", "light: intensity=1,2,1e+38: it is negative or above 1e+12"},
        {"red intensity=1,-2,3", "light: intensity=1,-2,3: it is negative or above 1e+12"},
    };
    OWNED(scene) scene;
    OWNED(emitters) emitters = {0};
    check_ok("scene", scene_load(&scene, "scenes/three-lights.glb"));
    check_ok("blue", emitters_from_text(&emitters, &scene, "blue", 0));
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        assert_false(emitters_from_text(&emitters, &scene, rows[i].text, 0));
        assert_string_equal(error_get(), rows[i].error);
        assert_int_equal(emitters.count, 1);
        assert_int_equal(emitters.items[0].number, 1);
    }
}

/* A camera by words: by its name, moved, turned, tilted; and words that mean nothing. */
TEST(camera_text) {
    static const char *const bad[][2] = {
        {"nobody eye=0,0,0", "no camera 'nobody' (there is:"},
        {"eye=0,0", "camera: 'eye=0,0' wants 3 numbers"},
        {"fov=wide", "camera: 'fov=wide' wants 1 number, as in fov=1"},
        {"eye", "no camera 'eye'"},
        {"forward=.2,0,-1 right=1,0,0 up=0,1,0",
         "camera: right, up and forward are not at right angles to each other"},
        {"forward=0,0,-1 right=1,.3,0 up=0,1,0",
         "camera: right, up and forward are not at right angles to each other"},
        {"forward=0,0,-2 right=1,0,0 up=0,1,0",
         "camera: forward has the length 2, not 1, beside right"},
        {"forward=0,0,-1 right=-1,0,0 up=0,1,0",
         "camera: right points to the left of forward and up"},
        {"forward=0,1,0 up=0,2,0", "camera: up is along forward"},
        {"fov=60", "camera: fov: 60 is not between 0 and pi radians"},
        {"eye=1,2,3 zoom=5", "camera: 'zoom=5' is not understood"},
    };
    OWNED(scene) scene;
    struct camera camera;
    int n = -1;
    check_ok("scene", scene_load(&scene, "scenes/three-lights.glb"));
    check_ok("none", camera_from_text(&camera, &scene, NULL, 0, NULL));
    check_ok("its number", camera_from_text(&camera, &scene, "0 forward=0,0,-2", 0, &n));
    assert_int_equal(n, 0);
    check_near("up", (double)camera.up[1], 1, 1e-6);
    check_near("forward", (double)camera.forward[2], -1, 1e-6);
    check_ok("tilted", camera_from_text(&camera, &scene, "forward=0,0,-1 up=1,0,0", 0, &n));
    check_near("up", (double)camera.up[0], 1, 1e-6);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        check_refused(camera_from_text(&camera, &scene, bad[i][0], 0, &n), bad[i][1]);
    }
}

/* --- flux ------------------------------------------------------------------------------------- */

/* The integral of intensity x falloff over the sphere, by the midpoint rule in the cosine. */
static double flux_by_rule(const struct emitter *light) {
    enum { STEPS = 2000000 };
    double sum = 0;
    for (int i = 0; i < STEPS; i++)
        sum += (double)emitter_cone(light, (float)(-1 + 2 * (i + .5) / STEPS));
    return sum * 2 / STEPS * 2 * GLM_PI * (double)light->intensity[0];
}

TEST(flux) {
    static const struct {
        const char *what;
        enum emitter_type type;
        float inner, outer;
    } cases[] = {{"point light's flux", EMITTER_POINT, 0, 0},
                 {"soft spot's", EMITTER_SPOT, .2f, .7f},
                 {"hard spot's", EMITTER_SPOT, .5f, .5f},
                 {"wide spot's", EMITTER_SPOT, 0, 1.5f},
                 {"needle's", EMITTER_SPOT, .02f, .03f}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct world world;
        place_light(&world, cases[i].type, glms_vec3_zero(), (vec3s){{0, 0, -1}}, 3);
        world.light.cos_inner = cosf(cases[i].inner);
        world.light.cos_outer = cosf(cases[i].outer);
        double expected = flux_by_rule(&world.light);
        check_near(cases[i].what, emitter_flux(&world.light, 1), expected, 2e-3 * expected);
    }
    struct emitter sun = {.type = EMITTER_DIRECTIONAL, .intensity = {1, 2, 3}};
    check_near("sun's through a disk of radius 2", emitter_flux(&sun, 2), 2 * GLM_PI * 4, 1e-5);
}

/* --- the path tracer -------------------------------------------------------------------------- */

/* A floor and a wall with a screen between, in [0, 1]^2. */
static void start_corner(struct world *world) {
    world_init(world);
    add_rectangle(world, 0, (vec3s){{0, 0, 1}}, (vec3s){{1, 0, 0}}, (vec3s){{0, 0, -1}});
    add_rectangle(world, 0, (vec3s){{0, 0, 1}}, (vec3s){{0, 0, -1}}, (vec3s){{0, 1.5f, 0}});
    add_rectangle(world, 0, (vec3s){{.2f, 0, .8f}}, (vec3s){{0, .3f, 0}}, (vec3s){{0, 0, -.5f}});
    world_finish(world);
    look_down(world, 0, 0, 1, 3);
}

/* A red spot on the wall, a point above the floor, a green sun. */
static void make_lights(struct emitter lights[3]) {
    struct world world;
    place_light(&world, EMITTER_SPOT, (vec3s){{.9f, .9f, .5f}}, (vec3s){{-1, .1f, 0}}, 5);
    world.light.cos_inner = cosf(.2f);
    world.light.cos_outer = cosf(.4f);
    world.light.intensity[1] = world.light.intensity[2] = .5f;
    lights[0] = world.light;
    place_light(&world, EMITTER_POINT, (vec3s){{.7f, .8f, .3f}}, (vec3s){{0, 0, -1}}, .4f);
    lights[1] = world.light;
    place_light(&world, EMITTER_DIRECTIONAL, glms_vec3_zero(), (vec3s){{-1, -.8f, .3f}}, 2);
    world.light.intensity[0] = world.light.intensity[2] = .3f;
    lights[2] = world.light;
}

enum { SIZE = 16 };

static struct image trace(struct world *world, struct emitter *lights, int count) {
    struct image image;
    struct path_tracer_desc desc = describe(world, SIZE, 1024);
    desc.emitters = (struct emitters){.items = lights, .count = count};
    desc.bounces = 2;
    render(&desc, &image);
    return image;
}

/* Over the pixels and RGB: the RMS of the difference between one picture's indirect light and the
 * sum of others', over what their standard errors let expect. Pictures of one seed have much of
 * their error in common, which takes it below 1. */
static double deviation(const struct image *whole, const struct image *parts, int count) {
    double squares = 0, expected = 0;
    for (int i = 0; i < SIZE * SIZE; i++)
        for (int c = 0; c < 3; c++) {
            const float *at = image_at(whole, i % SIZE, i / SIZE) + c;
            double difference = at[CHANNEL_INDIRECT];
            expected += pow(at[CHANNEL_STANDARD_ERROR], 2);
            for (int p = 0; p < count; p++) {
                const float *part = image_at(&parts[p], i % SIZE, i / SIZE) + c;
                difference -= part[CHANNEL_INDIRECT];
                expected += pow(part[CHANNEL_STANDARD_ERROR], 2);
            }
            squares += difference * difference;
        }
    return sqrt(squares / expected);
}

static double worst_direct(const struct image *whole, const struct image *parts, int count) {
    double worst = 0;
    for (int i = 0; i < SIZE * SIZE; i++)
        for (int c = 0; c < 3; c++) {
            double sum = 0;
            for (int p = 0; p < count; p++)
                sum += image_at(&parts[p], i % SIZE, i / SIZE)[CHANNEL_DIRECT + c];
            double value = image_at(whole, i % SIZE, i / SIZE)[CHANNEL_DIRECT + c];
            worst = fmax(worst, fabs(value - sum) / fmax(sum, 1e-3));
        }
    return worst;
}

/* Light adds up: three lights are one and one and one. */
TEST(sum) {
    OWNED(world) world;
    struct emitter lights[3];
    struct image parts[3];
    start_corner(&world);
    make_lights(lights);
    struct image whole = trace(&world, lights, 3);
    for (int i = 0; i < 3; i++)
        parts[i] = trace(&world, &lights[i], 1);
    check_at_most("direct light, worst relative error", worst_direct(&whole, parts, 3), 1e-5);
    for (int c = 0; c < 3; c++) {
        double sum = 0, mean = mean_of(&whole, CHANNEL_INDIRECT + c);
        for (int i = 0; i < 3; i++)
            sum += mean_of(&parts[i], CHANNEL_INDIRECT + c);
        check_near("indirect light, mean", mean, sum, .003 * sum);
    }
    check_at_most("indirect light, deviation over noise", deviation(&whole, parts, 3), 1.15);
    image_free(&whole);
    for (int i = 0; i < 3; i++)
        image_free(&parts[i]);
}

/* A light in two halves at one place is the one. */
TEST(split) {
    OWNED(world) world;
    struct emitter lights[3], halves[2];
    start_corner(&world);
    make_lights(lights);
    halves[0] = halves[1] = lights[0];
    for (int c = 0; c < 3; c++)
        halves[0].intensity[c] = halves[1].intensity[c] = lights[0].intensity[c] / 2;
    OWNED(image) whole = trace(&world, lights, 1), split = trace(&world, halves, 2);
    check_at_most("direct light, worst relative error", worst_direct(&whole, &split, 1), 1e-6);
    double mean = mean_of(&whole, CHANNEL_INDIRECT);
    check_near("indirect light, mean", mean_of(&split, CHANNEL_INDIRECT), mean, .003 * mean);
    check_at_most("indirect light, deviation over noise", deviation(&whole, &split, 1), 1.15);
}

/* Lights that give nothing take no rays from the one that does. */
TEST(dark_lights) {
    OWNED(world) world;
    struct emitter lights[3], many[20];
    start_corner(&world);
    make_lights(lights);
    for (int i = 0; i < 20; i++) {
        many[i] = lights[1];
        for (int c = 0; c < 3; c++)
            many[i].intensity[c] = i == 7 ? lights[1].intensity[c] : 0;
    }
    OWNED(image) one = trace(&world, &lights[1], 1), among = trace(&world, many, 20);
    double mean = mean_of(&one, CHANNEL_INDIRECT);
    check_at_most("direct light, worst relative error", worst_direct(&one, &among, 1), 0);
    check_near("indirect light, mean", mean_of(&among, CHANNEL_INDIRECT), mean, .003 * mean);
    check_at_most("indirect light, deviation over noise", deviation(&one, &among, 1), 1.15);
}

/* In a sphere of albedo 1/2 what one bounce gives is the flux alone, whatever shines from where:
 * rho Phi / (4 pi R^2) as irradiance. Light rays start from all of the light, and weights fit. */
TEST(sizes) {
    static const struct {
        const char *what;
        enum emitter_type type;
        float size[2];
        double flux; /* of an intensity of pi */
    } cases[] = {{"rectangle", EMITTER_AREA, {.8f, .5f}, GLM_PI * GLM_PI},
                 {"disk", EMITTER_AREA, {.7f, 0}, GLM_PI * GLM_PI},
                 {"sphere", EMITTER_POINT, {.6f, 0}, 4 * GLM_PI * GLM_PI},
                 {"hemispherical spot with sides", EMITTER_SPOT, {.3f, .6f}, 2 * GLM_PI * GLM_PI}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        OWNED(world) world;
        OWNED(image) image;
        world_in_sphere(&world);
        place_light(&world, cases[i].type, (vec3s){{.1f, .2f, 0}}, (vec3s){{.3f, -.5f, -1}},
                    GLM_PIf);
        emitter_aim(&world.light, world.light.direction);
        memcpy(world.light.size, cases[i].size, sizeof world.light.size);
        world.light.cos_outer = 0, world.light.cos_inner = .001f;
        struct path_tracer_desc desc = describe(&world, SIZE, 256);
        desc.bounces = 1;
        double noise = render(&desc, &image).noise;
        double expected = .5 * emitter_flux(&world.light, 1) / (4 * GLM_PI) / GLM_PI;
        check_near(cases[i].what, emitter_flux(&world.light, 1), cases[i].flux,
                   2e-3 * cases[i].flux);
        check_near("indirect light, mean", mean_of(&image, CHANNEL_INDIRECT), expected,
                   4e-3 * expected);
        check_at_most("its spread over its noise",
                      spread_about(&image, CHANNEL_INDIRECT, expected) / noise, 1.3);
    }
}

/* Where nothing but the direct light of a lamp has noise, that is the estimate. */
TEST(direct_noise) {
    OWNED(world) world;
    OWNED(image) reference, quick;
    start_corner(&world);
    place_light(&world, EMITTER_AREA, (vec3s){{.6f, 1.2f, .4f}}, (vec3s){{0, -1, 0}}, 1);
    emitter_aim(&world.light, world.light.direction);
    world.light.size[0] = world.light.size[1] = .5f;
    struct path_tracer_desc desc = describe(&world, SIZE, 4096);
    desc.seed = 7;
    double least = render(&desc, &reference).noise;
    desc.seed = 0;
    desc.samples = 16;
    double estimated = render(&desc, &quick).noise, squares = 0;
    for (int i = 0; i < SIZE * SIZE; i++)
        squares += pow((double)(image_at(&quick, i % SIZE, i / SIZE)[CHANNEL_DIRECT] -
                                image_at(&reference, i % SIZE, i / SIZE)[CHANNEL_DIRECT]),
                       2);
    double error = sqrt(squares) / SIZE / mean_of(&reference, CHANNEL_DIRECT);
    check_at_most("noise of many samples", least, estimated / 4);
    check_near("estimated noise over the error", estimated / error, 1, .3);
}

RUN_TESTS(NULL, NULL)
