/* Caustics: exact answers of mirrors and slabs, and relations that hold of any picture. */
#include "smooth_stage.h"

#include <cglm/cglm.h>

/* --- exact answers ---------------------------------------------------------------------------- */

static const char *const kinds[] = {CHEAP "caustics.surface=patches caustics.size=256",
                                    CHEAP "caustics.surface=points caustics.size=256"};

/* The light of a mirrored light, tinted. */
TEST(mirror) {
    OWNED(stage) stage;
    open_mirror(&stage, 4, 1);
    for (int k = 0; k < 2; k++) {
        OWNED(image) drawn = draw(&stage, kinds[k]);
        double expected = 1 / (16 * GLM_PI), tolerance = k ? .1 : .01;
        printf("    %s\n", kinds[k]);
        check_near("red over expected", channel_mean(&drawn, "caustic.R") / expected, 1, tolerance);
        check_near("blue over expected", channel_mean(&drawn, "caustic.B") / expected, .6,
                   tolerance);
        check_near("direct", mean_of(&drawn, "direct"), 0, 1e-9);
    }
}

/* On the axis: I (1 - F)^2 / (s + t/n + e)^2. */
TEST(slab) {
    OWNED(stage) stage;
    open_slab(&stage, 1.5F, 1, .5F);
    OWNED(image) drawn = draw(&stage, PATCHES);
    check_near("over expected", mean_of(&drawn, "caustic") * GLM_PI / .246564, 1, .01);
    check_near("direct", mean_of(&drawn, "direct"), 0, 1e-9);
    image_free(&drawn);
    for (int c = 0; c < 3; c++)
        stage.scene.materials[SMOOTH].absorption[c] = 3;
    drawn = draw(&stage, PATCHES);
    check_near("absorbing, over expected",
               mean_of(&drawn, "caustic") * GLM_PI / (.246564 * exp(-.6)), 1, .01);
}

/* All light of a mirror that is that wide lands where the camera sees it: a square of 2 m. */
static void check_energy(double half) {
    OWNED(stage) stage;
    const double height = 2.5;
    open_mirror(&stage, 2 * half, (float)height);
    stage.camera.fov_y = glm_rad(60);
    double solid_angle = 4 * asin(half * half / (half * half + 1));
    double pixel = pow(2 * height * tan(GLM_PI / 6) / SIZE, 2);
    for (int k = 0; k < 2; k++) {
        OWNED(image) drawn = draw(&stage, kinds[k]);
        double landed = channel_mean(&drawn, "caustic.R") * GLM_PI * pixel * SIZE * SIZE;
        printf("    %s\n", kinds[k]);
        check_near("landed over sent", landed / solid_angle, 1, .02);
    }
}

TEST(energy) {
    check_energy(.25);
    check_energy(.005); /* small in the light's wide cone */
}

/* An object that bends nothing: light that was direct is a caustic, airlight a caustic in the
 * medium. It holds for any pictures, cameras and numbers of rays. */
TEST(no_refraction) {
    static const struct {
        float g, field, roll; /* radians */
        int rays, size;
    } rows[] = {{0, 2.27F, 0, 256, SIZE},      {.6F, 2.27F, 0, 256, SIZE},
                {-.6F, 2.27F, 0, 256, SIZE},   {0, 2.1F, .7F, 256, SIZE},
                {0, 2.27F, 0, 512, SIZE},      {0, 2.27F, .3F, 256, 2 * SIZE},
                {.6F, 2.1F, -2, 128, SIZE / 2}};
    OWNED(stage) with, without;
    open_slab(&with, 1, 1, .75F);
    open_nodes(&without, FLOOR_NODE, .75F);
    for (int c = 0; c < 3; c++) /* as much as the medium takes, which is not in glass */
        with.scene.materials[SMOOTH].absorption[c] = .17F;
    for (size_t i = 0; i < (is_long_run() ? sizeof rows / sizeof *rows : 3); i++) {
        struct camera *camera = &with.camera;
        camera->fov_y = rows[i].field;
        memcpy(camera->right, (float[]){cosf(rows[i].roll), sinf(rows[i].roll), 0},
               sizeof camera->right);
        memcpy(camera->up, (float[]){-sinf(rows[i].roll), cosf(rows[i].roll), 0},
               sizeof camera->up);
        without.camera = *camera;
        set_medium(&with, .15F, .02F, rows[i].g);
        set_medium(&without, .15F, .02F, rows[i].g);
        const char *settings =
            form(CHEAP
                 "caustics.surface=patches caustics.medium=lines caustics.size=%d medium.steps=128",
                 rows[i].rays);
        OWNED(image) a = render_stage(&with, "unshadowed", settings, rows[i].size);
        struct image b =
            render_stage(&without, "unshadowed", CHEAP "medium.steps=128", rows[i].size);
        printf("    g = %g, field of view %g, turned by %g, %d rays a side, %d pixels\n",
               (double)rows[i].g, (double)rows[i].field, (double)rows[i].roll, rows[i].rays,
               rows[i].size);
        check_near("caustic's share", mean_of(&a, "caustic") / mean_of(&b, "direct"), .5, .45);
        check_near("light on surfaces, with over without",
                   (mean_of(&a, "direct") + mean_of(&a, "caustic")) / mean_of(&b, "direct"), 1,
                   .015);
        check_near("volume's share", mean_of(&a, "volume") / mean_of(&b, "airlight"), .5, .45);
        check_near("light in the medium, with over without",
                   (mean_of(&a, "airlight") + mean_of(&a, "volume")) / mean_of(&b, "airlight"), 1,
                   .03);
        image_free(&b);
    }
}

/* Light goes up from a mirror to a ceiling, down to a plate, and up again; ceiling and plate
 * scatter or are mirrors. The camera looks at x from there to there, between them. */
struct between {
    bool mirror_ceiling, mirror_plate;
    float from, to;
    float intensity[3]; /* none: 1 W/sr */
    float range;        /* of the light, metres; 0: none */
};

static struct image draw_between(const struct between *between) {
    float from = between->from, to = between->to;
    static const float down[] = {1, 0, -1};
    OWNED(stage) stage;
    const char *nodes =
        form(FLOOR_NODE ", " UP_NODE
                        ", {mesh: %d, translation: [-4, 4, 3], rotation: [1, 0, 0, 0], scale: "
                        "[8, 8, 1]}, {mesh: %d, translation: [4, -2, 1], scale: [4, 4, 1]}",
             -2., -2., 1., 4., 4., between->mirror_ceiling, between->mirror_plate);
    open_nodes(&stage, nodes, 0);
    make_mirror(&stage);
    set_medium(&stage, .15F, .02F, .3F);
    struct emitter *light = &stage.emitters.items[0];
    light->cos_outer = cosf(.1F);
    light->cos_inner = cosf(.05F);
    light->range = between->range > 0 ? between->range : light->range;
    if (between->intensity[0] > 0)
        memcpy(light->intensity, between->intensity, sizeof light->intensity);
    emitter_aim(light, down);
    stage.camera =
        FILLED(camera, .eye = {(from + to) / 2, -8, 2}, .right = {1, 0, 0}, .up = {0, 0, 1},
               .forward = {0, 1, 0}, .fov_y = 2 * atanf((to - from) / 16));
    struct image drawn =
        draw(&stage, CHEAP "caustics.surface=patches caustics.medium=lines caustics.size=256");
    return drawn;
}

static void check_same_volume(const char *what, struct image *drawn, struct image *expected,
                              double tolerance, double noise) {
    printf("    %s\n", what);
    for (int c = 0; c < 3; c++) {
        const char name[] = {'v', 'o', 'l', 'u', 'm', 'e', '.', "RGB"[c], 0};
        check_near("over expected", channel_mean(drawn, name) / channel_mean(expected, name), 1,
                   tolerance);
    }
    check_at_most("relative RMSE", relative_rmse(drawn, expected, "volume"), noise);
    images_free(drawn, expected);
}

/* Light from one mirror to another is seen as light from a mirror to a surface that scatters. Rays
 * differ, because the light's view is fitted to mirrors. Of two such segments a ray draws one by
 * chance, for both. */
TEST(between_mirrors) {
    struct between between = {.mirror_ceiling = true, .from = 1.2F, .to = 2.8F}, lands = between;
    lands.mirror_ceiling = false;
    struct image one = draw_between(&between), expected = draw_between(&lands);
    check_same_volume("one segment", &one, &expected, .003, .06);
    between.to = lands.to = 3.8F;
    between.mirror_plate = lands.mirror_ceiling = true;
    struct image two = draw_between(&between);
    expected = draw_between(&lands);
    check_same_volume("two segments", &two, &expected, .01, .15);
}

/* Channels of little light are right as well: shares of all light are rounded by chance. */
TEST(between_colours) {
    struct between between = {
        .mirror_ceiling = true, .from = 1.2F, .to = 2.8F, .intensity = {1, 1e-4F, 1e-3F}};
    struct image drawn = draw_between(&between);
    between.mirror_ceiling = false;
    struct image expected = draw_between(&between);
    check_same_volume("red light", &drawn, &expected, .03, .15);
}

/* Light of a range of 4 m comes 4.2 m to the ceiling: in the medium it fades with its way, the
 * square root of two times x, as the light of no range does not. */
TEST(range) {
    for (int mirror = 0; mirror < 2; mirror++) {
        struct between between = {.mirror_ceiling = mirror, .from = 1.2F, .to = 2.8F};
        OWNED(image) all = draw_between(&between);
        between.range = 4;
        OWNED(image) drawn = draw_between(&between);
        int red = image_find_channel(&all, "volume.R");
        double expected = 0;
        for (int i = 0; i < SIZE * SIZE; i++) {
            double x = 1.2 + (i % SIZE + .5) / SIZE * 1.6, part2 = 2 * x * x / 16;
            expected += (double)image_at(&all, i % SIZE, i / SIZE)[red] * (1 - part2 * part2);
        }
        printf("    ceiling %s\n", mirror ? "a mirror" : "scatters");
        check_near("over expected", channel_mean(&drawn, "volume.R") * SIZE * SIZE / expected, 1,
                   .015);
    }
}

/* Numbers by which a ray goes on do not choose its line: light behind dark glass is the same for
 * the first light as for one whose number no surface has. */
TEST(chance) {
    enum { LIGHTS = 40 };
    double means[2];
    for (int last = 0; last < 2; last++) {
        OWNED(stage) stage;
        open_slab(&stage, 1.5F, 1, .5F);
        for (int c = 0; c < 3; c++)
            stage.scene.materials[SMOOTH].absorption[c] = 17;
        set_medium(&stage, .15F, .02F, .3F);
        struct emitter light = stage.emitters.items[0];
        light.cos_outer = cosf(.3F); /* within the slab */
        light.cos_inner = cosf(.25F);
        emitters_free(&stage.emitters);
        stage.emitters =
            (struct emitters){.items = mem_alloc(LIGHTS, sizeof light), .count = LIGHTS};
        for (int i = 0; i < LIGHTS; i++) {
            stage.emitters.items[i] = light;
            stage.emitters.items[i].number = i;
            if (i != last * (LIGHTS - 1))
                memset(stage.emitters.items[i].intensity, 0, sizeof light.intensity);
        }
        stage.camera = FILLED(camera, .eye = {0, -6, .4F}, .right = {1, 0, 0}, .up = {0, 0, 1},
                              .forward = {0, 1, 0}, .fov_y = .12F);
        OWNED(image) drawn = draw(
            &stage, CHEAP
            "caustics.surface=patches caustics.medium=lines caustics.size=256 caustics.chains=1");
        means[last] = mean_of(&drawn, "volume");
    }
    check_near("first light over the last one", means[0] / means[1], 1, .1);
}

/* Published lines all have one weight. Across the view it is the square root of two times the right
 * one, at the depth of the glass; steps and kernel keep the mean. */
TEST(published) {
    static const char *const settings[] = {"paper", "paper caustics.step=.02",
                                           "paper caustics.step=.02 caustics.kernel=.25",
                                           "paper caustics.kernel=2 caustics.step=.02"};
    static const char lines[] = CHEAP "caustics.size=256 medium.steps=8 caustics.medium=";
    OWNED(stage) stage;
    open_slab(&stage, 1, .1F, .75F);
    set_medium(&stage, .15F, .02F, .3F);
    stage.camera = FILLED(camera, .eye = {0, -6, .5F}, .right = {1, 0, 0}, .up = {0, 0, 1},
                          .forward = {0, 1, 0}, .fov_y = .1F);
    OWNED(image) right = draw(&stage, form("%slines", lines));
    for (size_t i = 0; i < sizeof settings / sizeof *settings; i++) {
        OWNED(image) drawn = draw(&stage, form("%s%s", lines, settings[i]));
        printf("    %s\n", settings[i]);
        check_near("published over lines", mean_of(&drawn, "volume") / mean_of(&right, "volume"),
                   sqrt(2), .04);
    }
}

/* Light from beside a wide mirror, just above it: the reflected light of directions that its
 * corners do not bound. */
TEST(low_light) {
    OWNED(stage) stage;
    open_nodes(&stage,
               form(FLOOR_NODE ", {mesh: 0, translation: [-20, 20, 3], rotation: [1, 0, 0, 0], "
                               "scale: [40, 40, 1]}, %s",
                    square_node(UP_NODE, 1, 4)),
               1);
    make_mirror(&stage);
    struct emitter *light = &stage.emitters.items[0];
    *light = emitter_new(EMITTER_POINT);
    memcpy(light->position, (float[]){1.5F, 0, 1.3F}, sizeof light->position);
    stage.camera.eye[0] = 4;
    stage.camera.eye[2] = 2;
    stage.camera.up[1] = -1;
    stage.camera.forward[2] = 1;
    OWNED(image) drawn = draw(&stage, kinds[0]);
    double square = 2.5 * 2.5 + 2.3 * 2.3, expected = 2.3 / pow(square, 1.5) / GLM_PI;
    check_near("over expected", channel_mean(&drawn, "caustic.R") / expected, 1, .02);
}

/* A mirror of one side is black from behind, as the reference has it. */
TEST(behind) {
    OWNED(stage) stage;
    open_squares(&stage, &(struct square){UP_NODE, 3, 4}, 1, 1);
    make_mirror(&stage);
    emitter_aim(&stage.emitters.items[0], (float[]){0, 0, 1});
    OWNED(image) drawn = draw(&stage, PATCHES);
    check_near("one side", mean_of(&drawn, "caustic"), 0, 0);
    image_free(&drawn);
    stage.scene.materials[SMOOTH].double_sided = true;
    drawn = draw(&stage, PATCHES);
    check_near("two sides, red over expected", channel_mean(&drawn, "caustic.R") * (16 * GLM_PI), 1,
               .01);
}

/* A light that lies on a surface, as those of lamps do: the surface does not keep its light. */
TEST(lamp) {
    static const double turns[] = {.3, .5, .7, .9};
    const double side = .02;
    for (size_t i = 0; i < sizeof turns / sizeof *turns; i++) {
        double means[2], c = cos(turns[i]), s = sin(turns[i]);
        float place[3] = {(float)(.3 + side / 2), (float)(.1 + c * side / 2),
                          (float)(2 + s * side / 2)};
        for (int has_lamp = 0; has_lamp < 2; has_lamp++) {
            OWNED(stage) stage;
            const char *nodes = form(FLOOR_NODE ", %s", square_node(DOWN_NODE, 3, 4));
            if (has_lamp)
                nodes = form("%s, {mesh: 0, translation: [0.3, 0.1, 2], rotation: [%.9g, 0, 0, "
                             "%.9g], scale: [%g, %g, 1]}",
                             nodes, sin(turns[i] / 2), cos(turns[i] / 2), side, side);
            open_nodes(&stage, nodes, 1);
            make_mirror(&stage);
            stage.camera.fov_y = glm_rad(60);
            memcpy(stage.emitters.items[0].position, place, sizeof place);
            emitter_aim(&stage.emitters.items[0], (float[]){0, (float)-s, (float)c});
            OWNED(image) drawn = draw(&stage, PATCHES);
            means[has_lamp] = mean_of(&drawn, "caustic");
        }
        check_near("with over without a lamp", means[1] / means[0], 1, .02);
    }
}

/* Caustics carry all that a mirror reflects, so no technique has it light the floor as well. */
TEST(no_indirect) {
    OWNED(stage) stage;
    open_mirror(&stage, 4, 1);
    for (int i = 0; techniques[i]; i++) {
        const char *name = techniques[i]->name;
        OWNED(image) off = render_stage(&stage, name, CHEAP, SIZE),
                     on = render_stage(&stage, name, PATCHES, SIZE);
        printf("    %s: indirect %g without caustics\n", name, mean_of(&off, "indirect"));
        check_near("indirect", mean_of(&on, "indirect"), 0, 1e-6);
    }
}

/* --- relations -------------------------------------------------------------------------------- */

/* More rays: the same light with less noise. */
TEST(more_rays) {
    static const char *const scenes[] = {"scenes/ring.glb", "scenes/gem.glb"};
    for (int s = 0; s < 2; s++) {
        OWNED(stage) stage = open_stage(scenes[s]);
        OWNED(image) few = draw(&stage, CHEAP
                                "caustics.surface=patches caustics.medium=lines caustics.size=128"),
                     many =
                         draw(&stage, CHEAP
                              "caustics.surface=patches caustics.medium=lines caustics.size=256");
        printf("    %s\n", scenes[s]);
        check_near("surfaces, few over many", mean_of(&few, "caustic") / mean_of(&many, "caustic"),
                   1, .04);
        if (s == 1)
            check_near("medium, few over many", mean_of(&few, "volume") / mean_of(&many, "volume"),
                       1, .04);
        check_finite("few", &few);
    }
}

TEST(halves) {
    OWNED(stage) stage = open_stage("scenes/ring.glb");
    struct renderer_desc desc = desc_of(&stage, "unshadowed", PATCHES, SIZE, SIZE);
    OWNED(image) one, two;
    render_halves(&stage, desc, &one, &two);
    check_at_most("two halves", relative_rmse(&two, &one, "caustic"), 1e-3);
}

/* A light that does not reach the ring, a scene without glass, and lines without a medium: not a
 * bit is other. */
TEST(out_of_view) {
    OWNED(stage) stage = open_stage("scenes/ring.glb");
    emitter_aim(&stage.emitters.items[0], (float[]){-1, 0, 0});
    struct image drawn = draw(&stage, PATCHES);
    check_near("caustic", mean_of(&drawn, "caustic"), 0, 0);
    check_finite("drawn", &drawn);
    image_free(&drawn);
    stage_free(&stage);
    stage = open_stage("scenes/cornell-box.glb");
    OWNED(image) off = draw(&stage, CHEAP), on = draw(&stage, PATCHES "caustics.medium=lines");
    assert_true(same_pixels(&off, &on));
    assert_int_equal(image_find_channel(&on, "caustic.R"), -1);
    images_free(&off, &on);
    stage_free(&stage);
    stage = open_stage("scenes/ring.glb"); /* without a medium */
    off = draw(&stage, CHEAP);
    on = draw(&stage, CHEAP "caustics.medium=lines");
    assert_true(same_pixels(&off, &on));
}

/* One renderer that goes from setting to setting: the pictures of renderers of their own. */
TEST(follow) {
    static const char *const all[] = {CHEAP,
                                      PATCHES,
                                      PATCHES "caustics.medium=lines",
                                      PATCHES "caustics.chains=1 lights.bounces=2",
                                      CHEAP,
                                      CHEAP "caustics.medium=lines caustics.size=64"};
    OWNED(stage) stage = open_stage("scenes/gem.glb");
    OWNED(renderer) renderer = {0};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        struct renderer_desc desc = desc_of(&stage, "clustered", all[i], SIZE, SIZE);
        OWNED(image) own = render_layers(&desc), followed = follow_layers(&renderer, &desc);
        printf("    %s\n", all[i]);
        assert_true(same_pixels(&own, &followed));
    }
}

/* The mean over passes is that of one frame, for rays move within their texels. */
TEST(passes) {
    OWNED(stage) stage = open_stage("scenes/gem.glb");
    struct renderer_desc desc =
        desc_of(&stage, "clustered", PATCHES "caustics.medium=lines", SIZE, SIZE);
    OWNED(image) one = render_layers(&desc), mean = render_mean(&desc, 0, 6);
    check_near("caustic, mean over one", mean_of(&mean, "caustic") / mean_of(&one, "caustic"), 1,
               .1);
    check_near("volume, mean over one", mean_of(&mean, "volume") / mean_of(&one, "volume"), 1, .1);
}

RUN_TESTS(open_group_context, close_group_context)
