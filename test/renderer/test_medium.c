/* A participating medium: exact answers, by the rasteriser and by the path tracer; relations that
 * hold of any picture; both against each other; and what is refused. */
#include "render_support.h"

#include "gltf_parts.h"

#include "reference/scene/medium_ball.h"
#include "scene/medium.h"

#include <cglm/cglm.h>

/* --- a ray and a light ------------------------------------------------------------------------ */

/* A camera in the origin that looks along -Z through pixels that all see the same, a wall so far
 * away, and a light of 1 W/sr. The geometry's sphere is the test's own, for the medium alone: the
 * wall lies in it. */
static void open_wall(struct stage *stage, float distance, float radius) {
    static const char nodes[] = "[{mesh: 0, translation: [-20, -20, %g], scale: [40, 40, 1]}]";
    const char *text = form(nodes, (double)-distance);
    *stage = open_stage(write_parts("wall.glb", &PARTS(.nodes = text)));
    stage->camera =
        (struct camera){.right = {1, 0, 0}, .up = {0, 1, 0}, .forward = {0, 0, -1}, .fov_y = 1e-3F};
    memset(stage->geometry.center, 0, sizeof stage->geometry.center);
    stage->geometry.radius = radius;
    emitters_free(&stage->emitters);
    stage->emitters = (struct emitters){.items = mem_alloc(2, sizeof(struct emitter)), .count = 1};
    stage->emitters.items[0] = emitter_new(EMITTER_POINT);
}

/* So far from the eye, at that angle to its ray, degrees. */
static void place_light(struct stage *stage, double distance, double angle) {
    struct emitter *light = &stage->emitters.items[0];
    light->position[0] = (float)(distance * sin(glm_rad((float)angle)));
    light->position[1] = 0;
    light->position[2] = (float)(-distance * cos(glm_rad((float)angle)));
}

static struct image trace_bounces(const struct stage *stage, int size, int samples, int bounces) {
    return TRACE(stage, .width = size, .height = size, .bounces = bounces, .samples = samples,
                 .centers = true, .medium = stage->scene.medium);
}

static struct image trace(const struct stage *stage, int size, int samples) {
    return trace_bounces(stage, size, samples, 0);
}

/* The mean of a layer over all pixels: a medium is seen before nothing, too. */
static double mean_of(const struct image *image, const char *layer) {
    int channels[3];
    double sum = 0;
    assert_true(image_find_layer(image, layer, channels));
    for (int i = 0; i < image->width * image->height; i++)
        for (int c = 0; c < 3; c++)
            sum += (double)image_at(image, i % image->width, i / image->width)[channels[c]];
    return sum / 3 / image->width / image->height;
}

/* Both must give that airlight. */
static void check_airlight(const char *what, const struct stage *stage, double expected,
                           double tolerance) {
    struct image drawn = render_stage(stage, "unshadowed", "vpls=64 rsm-size=16", 32);
    struct image traced = trace(stage, 16, 256);
    printf("    %s\n", what);
    check_near("drawn over expected", mean_of(&drawn, "airlight") / expected, 1, tolerance);
    check_near("traced over expected", mean_of(&traced, "airlight") / expected, 1, tolerance);
    images_free(&drawn, &traced);
}

/* F(u, v) of [Sun et al. 2005], by the midpoint rule. */
static double sun_f(double u, double v) {
    enum { STEPS = 20000 };
    double sum = 0;
    for (int i = 0; i < STEPS; i++)
        sum += exp(-u * tan((i + .5) / STEPS * v));
    return sum * v / STEPS;
}

/* Without shadows, isotropic: a light of 1 W/sr at d under the angle gamma, the wall at D. */
static double closed_form(double d, double gamma, double wall, double scattering,
                          double extinction) {
    double s0 = d * cos(gamma), h = d * sin(gamma), end = GLM_PI_4 + .5 * atan((wall - s0) / h);
    return scattering / (2 * GLM_PI * h) * exp(-extinction * s0) *
           (sun_f(extinction * h, end) - sun_f(extinction * h, gamma / 2));
}

/* The same of any phase function, by even steps along the ray. */
static double by_steps(double d, double gamma, double wall, double scattering, double extinction,
                       double g) {
    enum { STEPS = 2000000 };
    double s0 = d * cos(gamma), h = d * sin(gamma), sum = 0;
    for (int i = 0; i < STEPS; i++) {
        double s = (i + .5) / STEPS * wall, r = hypot(s - s0, h), cosine = (s0 - s) / r;
        double phase = (1 - g * g) / (4 * GLM_PI * pow(1 + g * g - 2 * g * cosine, 1.5));
        sum += phase * exp(-extinction * (s + r)) / (r * r);
    }
    return scattering * sum * wall / STEPS;
}

TEST(airlight) {
    static const struct {
        double d, angle, wall, expected;
    } rows[] = {{2, 30, 5, .01631943}, {1, 80, 3, 0}, {4, 5, 6, 0}, {2, 150, 5, 0}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        OWNED(stage) stage;
        double gamma = rows[i].angle * GLM_PI / 180;
        double expected = closed_form(rows[i].d, gamma, rows[i].wall, .3, .4);
        if (rows[i].expected > 0)
            check_near("closed form", expected, rows[i].expected, 1e-8);
        open_wall(&stage, (float)rows[i].wall, 50);
        set_medium(&stage, .3F, .1F, 0);
        place_light(&stage, rows[i].d, rows[i].angle);
        check_airlight("closed form of Sun et al.", &stage, expected, 2e-3);
    }
}

/* So thin that nothing is lost. */
TEST(thin) {
    OWNED(stage) stage;
    open_wall(&stage, 5, 50);
    set_medium(&stage, .3e-5F, 0, 0);
    place_light(&stage, 2, 30);
    for (int c = 0; c < 3; c++)
        stage.emitters.items[0].intensity[c] = 1e5F;
    check_airlight("without extinction", &stage, .05541074, 1e-3);
}

/* Below the top of so large a sphere that it is a half space. */
TEST(directional) {
    OWNED(stage) stage;
    const float deep = 1.5F, large = 2e3F;
    open_wall(&stage, 4, large);
    stage.geometry.center[1] = deep - large;
    stage.emitters.items[0] = emitter_new(EMITTER_DIRECTIONAL);
    set_medium(&stage, .3F, .1F, 0);
    check_airlight("a sun across the view", &stage, .02614171, 3e-3);
}

TEST(phase) {
    static const float all[] = {-.99F, -.5F, 0, .3F, .9F, .99F};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        enum { STEPS = 1000000 };
        double sum = 0, cosines = 0;
        for (int k = 0; k < STEPS; k++) {
            double angle = (k + .5) / STEPS * GLM_PI, cosine = cos(angle);
            double part = 2 * GLM_PI * sin(angle) * GLM_PI / STEPS *
                          (double)medium_phase(all[i], (float)cosine);
            sum += part;
            cosines += part * cosine;
        }
        printf("    g = %g\n", (double)all[i]);
        check_near("integral", sum, 1, 2e-4);
        check_near("mean cosine", cosines, (double)all[i], 3e-4);
    }
    static const struct {
        float g;
        double angle;
    } rows[] = {{.5F, 30}, {-.5F, 30}, {.99F, 3}, {-.99F, 150}, {.99F, 60}, {-.99F, 30}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        OWNED(stage) stage;
        const char *what = form("g = %g, %g degrees", (double)rows[i].g, rows[i].angle);
        open_wall(&stage, 5, 50);
        set_medium(&stage, .3F, .1F, rows[i].g);
        place_light(&stage, 2, rows[i].angle);
        check_airlight(what, &stage,
                       by_steps(2, rows[i].angle * GLM_PI / 180, 5, .3, .4, (double)rows[i].g),
                       3e-3);
    }
}

/* --- relations -------------------------------------------------------------------------------- */

enum { SIZE = 64 };

#define CHEAP "vpls=64 vals=4 map.size=32 rsm-size=64 "

/* Irradiance from the middle of a sphere that a medium fills: I exp(-sigma R) / R^2. */
TEST(filled_sphere) {
    OWNED(stage) stage = open_stage("scenes/sphere.glb");
    set_medium(&stage, .5F, .3F, .2F);
    OWNED(image) drawn = render_stage(&stage, "unshadowed", CHEAP, SIZE);
    OWNED(image) traced = trace(&stage, SIZE, 4);
    check_near("drawn", layer_mean(&drawn, "direct"), exp(-.8), 1e-3);
    check_near("traced", layer_mean(&traced, "direct"), exp(-.8), 1e-3);
}

/* What absorbs alone takes its share and adds nothing. */
TEST(absorption) {
    OWNED(stage) stage;
    open_wall(&stage, 5, 50);
    place_light(&stage, 2, 30);
    OWNED(image) clear = render_stage(&stage, "unshadowed", CHEAP, SIZE);
    OWNED(image) clear_traced = trace(&stage, SIZE, 4);
    set_medium(&stage, 0, .2F, 0);
    OWNED(image) drawn = render_stage(&stage, "unshadowed", CHEAP, SIZE);
    OWNED(image) traced = trace(&stage, SIZE, 4);
    vec3 to_light = {0, 0, -5};
    glm_vec3_sub(to_light, stage.emitters.items[0].position, to_light);
    double passes = exp(-.2 * (double)glm_vec3_norm(to_light)), seen = exp(-.2 * 5);
    check_near("airlight", mean_of(&drawn, "airlight") + mean_of(&traced, "airlight"), 0, 0);
    check_near("direct drawn", layer_mean(&drawn, "direct") / layer_mean(&clear, "direct"), passes,
               1e-3);
    check_near("direct traced", layer_mean(&traced, "direct") / layer_mean(&clear_traced, "direct"),
               passes, 1e-3);
    check_near("seen drawn", layer_mean(&drawn, "") / layer_mean(&clear, ""), passes * seen, 1e-3);
    check_near("seen traced", layer_mean(&traced, "") / layer_mean(&clear_traced, ""),
               passes * seen, 1e-3);
}

static double difference(const struct image *a, const struct image *b, const char *layer) {
    int of_a[3], of_b[3];
    double sum = 0, mean = 0;
    assert_true(image_find_layer(a, layer, of_a) && image_find_layer(b, layer, of_b));
    for (int i = 0; i < a->width * a->height; i++)
        for (int c = 0; c < 3; c++) {
            double x = (double)image_at(a, i % a->width, i / a->width)[of_a[c]];
            double y = (double)image_at(b, i % b->width, i / b->width)[of_b[c]];
            sum += (x - y) * (x - y);
            mean += y;
        }
    double values = 3. * a->width * a->height;
    return sqrt(sum / values) / (mean / values);
}

/* Half as large, twice as dense, with a quarter of the light: the same picture. */
TEST(scale) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    float radius = stage.geometry.radius;
    set_medium(&stage, .3F / radius, .1F / radius, .4F);
    OWNED(image) before = render_stage(&stage, "clustered", CHEAP, SIZE);
    OWNED(image) traced = trace(&stage, SIZE, 4);
    scale_scene(&stage.scene, .5F);
    pose_stage(&stage);
    set_medium(&stage, .6F / radius, .2F / radius, .4F);
    OWNED(image) after = render_stage(&stage, "clustered", CHEAP, SIZE);
    OWNED(image) traced_after = trace(&stage, SIZE, 4);
    check_at_most("drawn airlight", difference(&after, &before, "airlight"), 2e-3);
    check_at_most("drawn beauty", difference(&after, &before, ""), 2e-3);
    check_at_most("traced airlight", difference(&traced_after, &traced, "airlight"), 2e-3);
}

/* A scene's first light, and two half as bright in its place. */
TEST(halves) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    set_medium(&stage, .3F, 0, .4F);
    struct renderer_desc desc = desc_of(&stage, "unshadowed", CHEAP, SIZE, SIZE);
    OWNED(image) one, two;
    render_halves(&stage, desc, &one, &two);
    check_at_most("two halves", difference(&two, &one, "airlight"), 2e-3);
}

/* Settings stand for a medium of the file; the file's may be left out; none is no other bit. */
TEST(settings) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    OWNED(image) clear = render_stage(&stage, "clustered", CHEAP, SIZE);
    struct image given =
        render_stage(&stage, "clustered", CHEAP "medium.scatter=.3 absorb=.1 medium.g=.4", SIZE);
    float radius = stage.geometry.radius;
    set_medium(&stage, .3F / radius, .1F / radius, .4F);
    OWNED(image) own = render_stage(&stage, "clustered", CHEAP, SIZE);
    OWNED(image) hidden = render_stage(&stage, "clustered", CHEAP "medium.scene=off", SIZE);
    assert_true(same_pixels(&given, &own));
    assert_true(same_pixels(&hidden, &clear));
    assert_int_equal(image_find_channel(&clear, "airlight.R"), -1);
    assert_false(same_pixels(&given, &clear));
    image_free(&given);
}

TEST(without_light) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    set_medium(&stage, .3F, .1F, 0);
    memset(stage.emitters.items[0].intensity, 0, sizeof stage.emitters.items[0].intensity);
    OWNED(image) drawn = render_stage(&stage, "clustered", CHEAP, SIZE);
    OWNED(image) traced = trace(&stage, SIZE, 4);
    check_finite("drawn", &drawn);
    check_finite("traced", &traced);
    check_near("airlight", mean_of(&drawn, "airlight") + mean_of(&traced, "airlight"), 0, 0);
}

/* A light in the camera: airlight without a bound, but a number. */
TEST(light_in_camera) {
    OWNED(stage) stage;
    open_wall(&stage, 5, 10);
    place_light(&stage, 0, 0);
    set_medium(&stage, .1F, 0, 0);
    OWNED(image) drawn = render_stage(&stage, "unshadowed", CHEAP, SIZE);
    OWNED(image) traced = trace(&stage, SIZE, 4);
    check_finite("drawn", &drawn);
    check_finite("traced", &traced);
    check_at_most("100 over the airlight", 100 / mean_of(&drawn, "airlight"), 1);
}

/* Passes add up: their mean has the airlight of one frame, with less noise. */
TEST(passes) {
    OWNED(stage) stage = open_stage("scenes/cornell-box.glb");
    struct renderer_desc desc = desc_of(&stage, "clustered", CHEAP "medium.scatter=.3", SIZE, SIZE);
    OWNED(image) one = render_layers(&desc), mean = render_mean(&desc, 0, 8);
    check_near("mean of passes over one frame's",
               mean_of(&mean, "airlight") / mean_of(&one, "airlight"), 1, .05);
    check_finite("passes", &mean);
}

/* One renderer that goes from medium to medium, and back from passes: the pictures of renderers of
 * their own. */
TEST(follow) {
    static const char *const all[] = {CHEAP "medium.scatter=.1", CHEAP "medium.scatter=.6", CHEAP,
                                      CHEAP "medium.scatter=.6 medium.g=.5",
                                      CHEAP "medium.scatter=.6 medium.g=.5 medium.steps=8"};
    OWNED(stage) stage = open_stage("scenes/table.glb");
    OWNED(renderer) renderer = {0};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        if (!is_tried_here(i, 2))
            continue;
        struct renderer_desc desc =
            desc_of(&stage, "clustered", all[i], SIZE + (int)i % 3, SIZE + (int)i % 3);
        OWNED(image) own = render_layers(&desc);
        desc.progressive = desc.keep_lights = true;
        OWNED(image) followed = follow_layers(&renderer, &desc);
        for (int pass = 0; pass < 3; pass++)
            renderer_add_pass(&renderer, pass);
        OWNED(image) again = follow_layers(&renderer, &desc);
        printf("    %s\n", all[i]);
        assert_true(same_pixels(&own, &followed));
        assert_true(same_pixels(&own, &again));
    }
}

/* --- against each other ----------------------------------------------------------------------- */

/* Mean of the airlight within 2 %, that of direct light, too; both by the same lights. */
static void check_scene(const char *path, const char *settings, int samples) {
    OWNED(stage) stage = open_stage(path);
    struct renderer_desc desc = desc_of(&stage, "unshadowed", settings, SIZE, SIZE);
    OWNED(image) drawn = render_layers(&desc);
    stage.scene.medium = medium_of(&stage.scene, &desc.settings, stage.geometry.radius);
    OWNED(image) traced = trace(&stage, SIZE, samples);
    printf("    %s, %s\n", path, settings);
    check_near("airlight", mean_of(&drawn, "airlight") / mean_of(&traced, "airlight"), 1, .02);
    check_near("direct", layer_mean(&drawn, "direct") / layer_mean(&traced, "direct"), 1, .03);
}

TEST(scenes) {
    check_scene("scenes/cornell-box.glb", "medium.scatter=.3", 64);
    check_scene("scenes/cornell-box.glb", "medium.scatter=.5 medium.g=.7", 64);
    check_scene("scenes/atrium.glb", "medium.scatter=.4 absorb=.2 medium.g=-.3", 64);
    check_scene("scenes/three-lights.glb", "medium.scatter=.3", 64);
    check_scene("scenes/table.glb", "medium.scatter=.3", 64);
    check_scene("scenes/hall.glb", "", 64);
    if (shared_path()) {
        const char *path = form("%s/scenes/sponza-98k.glb", shared_path());
        check_scene(path, "medium.scatter=.5", 64);
    }
}

/* The mean of a layer as drawn, over that as traced. */
static double drawn_over_traced(struct stage *stage, const char *technique, const char *settings,
                                const char *layer, int bounces) {
    struct renderer_desc desc = desc_of(stage, technique, settings, SIZE, SIZE);
    struct image drawn = render_layers(&desc);
    stage->scene.medium = medium_of(&stage->scene, &desc.settings, stage->geometry.radius);
    struct image traced = trace_bounces(stage, SIZE, 64, bounces);
    double ratio = layer_mean(&drawn, layer) / layer_mean(&traced, layer);
    stage->scene.medium = (struct medium){0};
    images_free(&drawn, &traced);
    return ratio;
}

/* Indirect light passes the medium, too: of VPLs, of the near field, of rays and of indirect
 * bounces. It errs as without one. */
TEST(indirect) {
    static const struct {
        const char *path, *technique, *settings, *layer;
        int bounces;
    } rows[] = {
        {"scenes/cornell-box.glb", "clustered", "", "indirect", 1},
        {"scenes/cornell-box.glb", "lightcuts", "", "indirect", 1},
        {"scenes/cornell-box.glb", "cluster-lights", "", "indirect", 1},
        {"scenes/cornell-box.glb", "clustered", "lights.bounces=3 paths=2048", "indirect", 3},
        {"scenes/gloss.glb", "clustered", "", "indirect.specular", 1},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        if (!is_tried_here(i, 4))
            continue;
        struct stage stage = open_stage(rows[i].path);
        const char *settings = form("medium.scatter=.6 absorb=.2 %s", rows[i].settings);
        double clear = drawn_over_traced(&stage, rows[i].technique, rows[i].settings, rows[i].layer,
                                         rows[i].bounces);
        double ratio =
            drawn_over_traced(&stage, rows[i].technique, settings, rows[i].layer, rows[i].bounces);
        printf("    %s, %s %s: %.4f of the traced, %.4f without medium\n", rows[i].path,
               rows[i].technique, rows[i].settings, ratio, clear);
        check_near(rows[i].layer, ratio / clear, 1, .03);
        stage_free(&stage);
    }
}

/* Sharp shafts beside their source: as dense and as pointed as settings allow, nothing overflows */
TEST(extremes) {
    static const char *const all[] = {
        "medium.scatter=1000", "medium.scatter=1000 medium.g=.99",
        "absorb=1000",         "medium.scatter=.3 medium.g=-.99",
        "medium.scatter=1e-6", "medium.scatter=.3 steps=1",
    };
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        OWNED(stage) stage = open_stage("scenes/three-lights.glb");
        const char *settings = form(CHEAP "%s", all[i]);
        struct renderer_desc desc = desc_of(&stage, "clustered", settings, SIZE, SIZE);
        OWNED(image) drawn = render_layers(&desc);
        stage.scene.medium = medium_of(&stage.scene, &desc.settings, stage.geometry.radius);
        OWNED(image) traced = trace(&stage, SIZE, 4);
        check_finite(all[i], &drawn);
        check_finite(all[i], &traced);
    }
}

/* A million per metre: nothing is seen. */
TEST(opaque) {
    OWNED(stage) stage = open_stage("scenes/hall.glb");
    set_medium(&stage, 0, 1e6F, 0);
    OWNED(image) drawn = render_stage(&stage, "clustered", CHEAP, SIZE);
    OWNED(image) traced = trace(&stage, SIZE, 4);
    check_finite("drawn", &drawn);
    check_near("beauty", mean_of(&drawn, "") + mean_of(&traced, ""), 0, 0);
}

/* --- files ------------------------------------------------------------------------------------ */

TEST(files) {
    static const char *const refused[][2] = {
        {"{sigma_s: -0.1}", "extras: medium: sigma_s: it is no number from 0 to 1e+09"},
        {"{sigma_a: [0, -1, 0]}", "extras: medium: sigma_a: it is no number"},
        {"{sigma_s: [1, 1]}", "extras: medium: sigma_s: it is no number"},
        {"{sigma_s: thick}", "extras: medium: sigma_s: it is no number"},
        {"{sigma_s: 1e300}", "extras: medium: sigma_s: it is no number"},
        {"{sigma_s: 1, g: 1}", "extras: medium: g: it is no number between -1 and 1"},
        {"{sigma_s: 1, g: -1.5}", "extras: medium: g: it is no number"},
        {"[1, 2]", "extras: medium: it is no object"},
    };
    OWNED(scene) scene;
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
        const char *more = form("scenes: [{nodes: [0], extras: {medium: %s}}], ", refused[i][0]);
        bool loaded = load_parts(&scene, "refused.glb", &PARTS(.more = more));
        check_refused(loaded, refused[i][1]);
        assert_non_null(strstr(error_get(), "refused.glb"));
    }
    const char *asset =
        "{version: '2.0', extras: {medium: {sigma_s: [0.1, 0.2, 0.3], sigma_a: 0.5, g: -0.25}}}";
    check_ok("load", load_parts(&scene, "medium.glb", &PARTS(.asset = asset)));
    check_vector("scattering", scene.medium.scattering, .1, .2, .3, 1e-7);
    check_vector("absorption", scene.medium.absorption, .5, .5, .5, 0);
    check_near("g", (double)scene.medium.g, -.25, 0);
}

RUN_TESTS(open_group_context, close_group_context)
