/* Caustics: what is hard for light rays, and what is noted or refused. */
#include "smooth_stage.h"

#include "command_support.h"

#include <cglm/cglm.h>

static void set_absorption(struct stage *stage) {
    for (int m = 0; m < stage->scene.material_count; m++)
        for (int c = 0; c < 3; c++)
            stage->scene.materials[m].absorption[c] = 1e6F;
}

static void set_light_inside(struct stage *stage) {
    memcpy(stage->emitters.items[0].position, (float[]){0, .9F, 0}, 3 * sizeof(float));
}

static void set_camera_inside(struct stage *stage) {
    memcpy(stage->camera.eye, (float[]){0, .9F, 0}, 3 * sizeof(float));
}

static void set_dense(struct stage *stage) {
    for (int m = 0; m < stage->scene.material_count; m++)
        if (stage->scene.materials[m].transmission > 0)
            stage->scene.materials[m].index_of_refraction = 50;
}

/* Light from within leaves only within a degree of the normal. */
static void set_trapped(struct stage *stage) {
    set_light_inside(stage);
    set_dense(stage);
}

static void set_thin(struct stage *stage) {
    for (int m = 0; m < stage->scene.material_count; m++)
        stage->scene.materials[m].thin_walled = true;
}

static void set_dark(struct stage *stage) {
    memset(stage->emitters.items[0].intensity, 0, sizeof stage->emitters.items[0].intensity);
}

static void set_sun(struct stage *stage) {
    stage->emitters.items[0] = emitter_new(EMITTER_DIRECTIONAL);
}

static void set_orthographic(struct stage *stage) {
    stage->camera.orthographic = true;
    stage->camera.y_extent = 2;
}

/* A number in each pixel. */
TEST(hard) {
    static const struct {
        const char *what, *settings;
        void (*set)(struct stage *stage);
    } rows[] = {
        {"absorption of 1e6", "", set_absorption},
        {"light inside", "", set_light_inside},
        {"camera inside", "", set_camera_inside},
        {"index of refraction of 50", "caustics.chains=8", set_dense},
        {"total reflection everywhere", "", set_trapped},
        {"thin walls", "", set_thin},
        {"no light", "", set_dark},
        {"sun", "", set_sun},
        {"orthographic camera", "", set_orthographic},
        {"g = .99", "medium.scatter=.6 medium.g=.99", NULL},
        {"g = -.99", "medium.scatter=.6 medium.g=-.99", NULL},
        {"few rays", "caustics.size=8", NULL},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        OWNED(stage) stage = open_stage("scenes/gem.glb");
        if (rows[i].set)
            rows[i].set(&stage);
        const char *settings = form(PATCHES "caustics.medium=lines %s", rows[i].settings);
        OWNED(image) drawn = draw(&stage, settings);
        printf("    %s: caustic %.3g, volume %.3g\n", rows[i].what, mean_of(&drawn, "caustic"),
               mean_of(&drawn, "volume"));
        check_finite(rows[i].what, &drawn);
    }
}

/* A slab within a slab: each interface has air on its other side, so that index is over index
 * twice. Reflections between the four interfaces add a percent. */
TEST(nested) {
    static const float indices[] = {1, 1.5F};
    for (int i = 0; i < 2; i++) {
        OWNED(stage) stage;
        static const struct square squares[] = {
            {UP_NODE, 1.1, 1}, {UP_NODE, 1, 1}, {DOWN_NODE, .8, 1}, {DOWN_NODE, .7, 1}};
        open_squares(&stage, squares, 4, .5F);
        make_glass(&stage, indices[i]);
        stage.camera.fov_y = .3F; /* hundreds of cells: chance tears some */
        double n = (double)indices[i], passes = 1 - pow((n - 1) / (n + 1), 2);
        double way = .9 + .1 / n + .2 / (n * n) + .1 / n + .7;
        OWNED(image) drawn = draw(&stage, CHEAP "caustics.surface=patches caustics.size=256");
        printf("    index %g\n", n);
        check_near("over expected",
                   mean_of(&drawn, "caustic") * GLM_PI / (pow(passes, 4) / (way * way)), 1, .02);
    }
}

/* One side of a slab: a ray enters and never leaves. */
TEST(open) {
    OWNED(stage) stage;
    open_squares(&stage, &(struct square){UP_NODE, 1, 1}, 1, .5F);
    make_glass(&stage, 1.5F);
    OWNED(image) drawn = draw(&stage, PATCHES);
    double open = mean_of(&drawn, "caustic") * GLM_PI;
    check_near("one interface, over .96 / (1 + 1 / 1.5)^2", open * pow(1 + 1 / 1.5, 2) / .96, 1,
               .01);
    check_finite("open", &drawn);
}

/* Solid glass that caustics do not refract is told, and no other. */
TEST(note) {
    static const char *const scenes[] = {"scenes/gem.glb", "scenes/cornell-box.glb"};
    for (int i = 0; i < 2; i++) {
        char output[4096];
        for (int shown = 0; shown < 2; shown++) {
            const char *command =
                form("%s render %s --size 16x16 --technique unshadowed --set vpls=64,rsm-size=64%s"
                     " -o %s 2>&1",
                     binary_path(), scenes[i], shown ? ",caustics.surface=patches" : "",
                     scratch("note.png"));
            check_ok(command, run_command(command, output, sizeof output) == 0);
            printf("    %s", output);
            assert_int_equal(strstr(output, "shown without: refraction") != NULL, i == 0 && !shown);
        }
    }
}

TEST(refused) {
    struct settings settings;
    renderer_settings_init(&settings);
    check_refused(settings_assign(&settings, "caustics.size=0"), "from 8 to 2048");
    check_refused(settings_assign(&settings, "caustics.size=100000"), "from 8 to 2048");
    check_refused(settings_assign(&settings, "caustics.chains=0"), "from 1 to 8");
    check_refused(settings_assign(&settings, "caustics.surface=bright"), "patches");
}

RUN_TESTS(open_group_context, close_group_context)
