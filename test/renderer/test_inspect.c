/* What there is to look at: the list of outputs, their pictures, and the pixel that is clicked on.
 */
#include "render_support.h"

#include "base/error.h"
#include "gl/glsl.h"
#include "inspect/inspect.h"
#include "inspect/probe.h"
#include "inspect/voxel_light.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char small[] = "vpls=64 vals=6 map-size=32 rsm-size=64 shadow-size=128 interleave=4";

static void open_frame(struct stage *stage, struct renderer *renderer, const char *technique,
                       const char *settings) {
    char all[256];
    snprintf(all, sizeof all, "%s %s", small, settings);
    open_stage(stage, "scenes/cornell-box.glb");
    struct renderer_desc desc = desc_of(stage, technique, all, 48, 32);
    open_renderer(renderer, &desc);
}

static void close_frame(struct stage *stage, struct renderer *renderer) {
    renderer_free(renderer);
    stage_free(stage);
}

static struct inspect_choice choice_of(const char *output) {
    return (struct inspect_choice){
        .output = output, .layer = -1, .chosen = -1, .width = 96, .height = 64, .scale = 1};
}

/* --- outputs ---------------------------------------------------------------------------------- */

static int count_shades(const struct texture *canvas) {
    struct bitmap picture;
    bool seen[256] = {false};
    int count = 0;
    texture_read_bitmap(canvas, &picture);
    for (int i = 0; i < picture.width * picture.height; i++) {
        count += !seen[picture.rgba[4 * i + 1]];
        seen[picture.rgba[4 * i + 1]] = true;
    }
    bitmap_free(&picture);
    return count;
}

/* Each output that a technique lists is a picture, as a whole and of its last layer. */
static void check_pictures(const char *technique, const char *settings) {
    struct stage stage;
    struct renderer renderer;
    struct inspect inspect;
    struct output_list outputs;
    open_frame(&stage, &renderer, technique, settings);
    check_ok("inspect", inspect_init(&inspect));
    renderer_outputs(&renderer, &outputs);
    for (int i = 0; i < outputs.count; i++) {
        const char *name = outputs.items[i].name;
        struct inspect_choice choice = choice_of(name);
        int layers = inspect_layers(&renderer, name);
        check_ok(name, inspect_draw(&inspect, &renderer, &choice));
        printf("    %-18s %-12s %d layers, %dx%d, %d shades\n", technique, name, layers,
               inspect.canvas.desc.width, inspect.canvas.desc.height,
               count_shades(&inspect.canvas));
        /* Irradiance may be the same everywhere: one shade and the background's. */
        int least = outputs.items[i].kind == OUTPUT_IRRADIANCE ? 2 : 3;
        if (count_shades(&inspect.canvas) < least)
            fail_msg("output '%s' of %s is drawn in too few shades: has its kind a row in mode_of "
                     "and a case in texture_of (src/inspect/inspect.c), and one in "
                     "glsl/inspect/inspect.frag?",
                     name, technique);
        choice.layer = layers - 1;
        check_ok(name, inspect_draw(&inspect, &renderer, &choice));
        assert_int_equal(strspn(name, "abcdefghijklmnopqrstuvwxyz-"), strlen(name));
    }
    inspect_free(&inspect);
    close_frame(&stage, &renderer);
}

static void test_pictures(void **state) {
    (void)state;
    check_pictures("clustered", "visibility=cssm");
    for (const struct technique *const *t = techniques; *t; t++)
        check_pictures((*t)->name, "");
}

static void test_missing(void **state) {
    (void)state;
    struct stage stage;
    struct renderer renderer;
    struct inspect inspect;
    struct inspect_choice choice = choice_of("visibility");
    open_frame(&stage, &renderer, "unshadowed", "");
    check_ok("inspect", inspect_init(&inspect));
    assert_int_equal(inspect_layers(&renderer, "visibility"), 0);
    assert_null(inspect_find(&renderer, OUTPUT_VALS));
    assert_string_equal(inspect_find(&renderer, OUTPUT_VPLS), "vpl");
    assert_false(inspect_draw(&inspect, &renderer, &choice));
    assert_string_equal(error_get(), "technique 'unshadowed' has no output 'visibility'");
    inspect_free(&inspect);
    close_frame(&stage, &renderer);
}

/* A view that is drawn again reads no shader; one of another lookup does. */
static void test_shaders_kept(void **state) {
    (void)state;
    struct stage stage;
    struct renderer renderer;
    struct inspect inspect;
    struct inspect_choice choice = choice_of("visibility");
    open_frame(&stage, &renderer, "clustered", "");
    check_ok("inspect", inspect_init(&inspect));
    check_ok("first", inspect_draw(&inspect, &renderer, &choice));
    glsl_set_folder("/nowhere");
    bool again = inspect_draw(&inspect, &renderer, &choice);
    glsl_set_folder(NULL);
    check_ok("again", again);
    struct renderer_desc other = renderer.desc;
    check_ok("setting", settings_assign(&other.settings, "visibility=hard"));
    check_ok("change", renderer_follow(&renderer, &other));
    renderer_render(&renderer);
    glsl_set_folder("/nowhere");
    bool changed = inspect_draw(&inspect, &renderer, &choice);
    glsl_set_folder(NULL);
    assert_false(changed);
    check_ok("after all", inspect_draw(&inspect, &renderer, &choice));
    inspect_free(&inspect);
    close_frame(&stage, &renderer);
}

/* --- a pixel ---------------------------------------------------------------------------------- */

/* What is told of a place is what the layers have there. */
static void test_pick(void **state) {
    (void)state;
    struct stage stage;
    struct renderer renderer;
    struct probe probe = {0};
    struct image layers;
    open_frame(&stage, &renderer, "clustered", "");
    check_ok("layers", renderer_read_layers(&renderer, &layers));
    static const char *const names[] = {"R", "direct.R", "indirect.R", "albedo.R", "normal.X"};
    int lit = 0;
    for (int i = 0; i < 6; i++) {
        int x = 4 + 8 * i, y = 3 + 5 * i;
        struct pick pick;
        check_ok("pick", probe_pick(&probe, &renderer, ((float)x + .5F) / 48, ((float)y + .5F) / 32,
                                    &pick));
        const float *told[] = {pick.radiance, pick.direct, pick.indirect, pick.albedo, pick.normal};
        const float *pixel = image_at(&layers, x, y);
        for (int k = 0; k < 5; k++)
            assert_memory_equal(told[k], pixel + image_find_channel(&layers, names[k]),
                                3 * sizeof(float));
        float position[3], away = 0;
        pixel_position(&renderer, &layers, x, y, position);
        for (int c = 0; c < 3; c++)
            away = fmaxf(away, fabsf(position[c] - pick.position[c]));
        check_at_most("position, metres", (double)away, 1e-5);
        float shares = 0;
        for (int k = 0; k < pick.val_count; k++)
            shares += pick.vals[k].share;
        if (pick.val_count)
            check_near("shares of all VALs", (double)shares, 1, 1e-4);
        lit += pick.val_count > 0;
    }
    assert_true(lit > 2);
    image_free(&layers);
    probe_free(&probe);
    close_frame(&stage, &renderer);
}

/* --- light at a voxel ------------------------------------------------------------------------- */

/* Its coefficients are by the integrals of harmonics over the sphere. */
static double polynomial(const float d[3]) {
    double x = (double)d[0], y = (double)d[1], z = (double)d[2];
    return 1 + 2 * y - z + 3 * x + x * y - 2 * y * z + z * z - x * z + x * x - y * y;
}

/* The ball shows the sum of coefficients times harmonics. */
static void test_ball(void **state) {
    (void)state;
    const double first = sqrt(4 * GLM_PI), second = sqrt(4 * GLM_PI / 3),
                 mixed = sqrt(4 * GLM_PI / 15), third = sqrt(16 * GLM_PI / 45);
    const double exact[] = {4 * first / 3, 2 * second, -second, 3 * second, mixed,
                            -2 * mixed,    third,      -mixed,  2 * mixed};
    struct voxel_light light = {.order = 3};
    double worst = 0;
    for (int i = 0; i < VOXEL_LIGHT_COEFFICIENTS; i++)
        for (int c = 0; c < 3; c++)
            light.coefficients[i][c] = (float)((c + 1) * exact[i]);
    for (int i = 0; i < 200; i++) {
        double z = 1 - (2 * i + 1) / 200., r = sqrt(1 - z * z), turn = 2.4 * i;
        float d[3] = {(float)(r * cos(turn)), (float)(r * sin(turn)), (float)z}, rgb[3];
        voxel_light_radiance(&light, d, rgb);
        for (int c = 0; c < 3; c++)
            worst = fmax(worst, fabs((double)rgb[c] / (c + 1) - polynomial(d)));
    }
    check_at_most("radiance, less the polynomial's", worst, 1e-5);
}

/* Over pi: what a white surface of that normal has of the ball's radiance. */
static void light_white(const struct voxel_light *light, const float normal[3], double rgb[3]) {
    enum { COUNT = 20000 };
    memset(rgb, 0, 3 * sizeof *rgb);
    for (int i = 0; i < COUNT; i++) {
        double z = 1 - (2 * i + 1) / (double)COUNT, r = sqrt(1 - z * z), turn = 2.39996323 * i;
        float d[3] = {(float)(r * cos(turn)), (float)(r * sin(turn)), (float)z}, one[3];
        float cosine = fmaxf(glm_vec3_dot(d, (float *)normal), 0);
        voxel_light_radiance(light, d, one);
        for (int c = 0; c < 3; c++)
            rgb[c] += 4. / COUNT * (double)(cosine * one[c]);
    }
}

/* Beside flat walls all eight voxels that light a pixel have nearly the light of one. */
static void test_voxel_light(void **state) {
    (void)state;
    static const char *const orders[] = {"volume.order=2", "volume.order=3"};
    for (int order = 2; order <= 3; order++) {
        struct stage stage;
        struct renderer renderer;
        struct probe probe = {0};
        struct pick pick;
        struct voxel_light light;
        double rgb[3];
        open_frame(&stage, &renderer, "imperfect-volume", orders[order - 2]);
        check_ok("pick", probe_pick(&probe, &renderer, .5F, .2F, &pick));
        assert_true(pick.present);
        voxel_light_read(&light, &renderer, pick.position, pick.normal);
        assert_int_equal(light.order, order);
        light_white(&light, pick.normal, rgb);
        for (int c = 0; c < 3; c++)
            check_near(orders[order - 2], rgb[c] / (double)pick.indirect[c], 1, .1);
        voxel_light_read(&light, &renderer, (const float[3]){1e6F, 0, 0}, pick.normal);
        assert_int_equal(light.order, 0);
        probe_free(&probe);
        close_frame(&stage, &renderer);
    }
}

/* The bin's place is where its partner lies: faces of the cross lead along x and z, and up. */
static int count_misplaced(const struct element_view *view) {
    static const int axes[ELEMENT_FACES][2] = {
        [ELEMENT_LEFT] = {0, -1}, [ELEMENT_FRONT] = {2, 1}, [ELEMENT_RIGHT] = {0, 1},
        [ELEMENT_REAR] = {2, -1}, [ELEMENT_ABOVE] = {1, 1}, [ELEMENT_BELOW] = {1, -1}};
    int misplaced = 0;
    for (int i = 0; i < ELEMENT_FACES * view->side * view->side; i++) {
        const struct element_bin *bin = &view->bins[i];
        const int *axis = axes[i / (view->side * view->side)];
        const int row = i / view->side % view->side, column = i % view->side;
        float path[3];
        if (bin->kind != ELEMENT_BIN_LINKED)
            continue;
        glm_vec3_sub((float *)bin->partner, (float *)view->position, path);
        bool along = (float)axis[1] * path[axis[0]] >= .999F * glm_vec3_max(path) &&
                     (float)axis[1] * path[axis[0]] >= -.999F * glm_vec3_min(path);
        bool right = (path[0] > 0) == (2 * column >= view->side);
        bool rear = (path[2] < 0) == (2 * row < view->side);
        int face = i / (view->side * view->side);
        misplaced += !along || ((face == ELEMENT_FRONT || face == ELEMENT_ABOVE) && !right) ||
                     (face == ELEMENT_ABOVE && !rear);
    }
    return misplaced;
}

/* The light of an element's bins is its irradiance, by each way to make links. */
static void test_element(void **state) {
    (void)state;
    static const char *const settings[] = {
        "elements=800 radiosity.bins=8 bounces=2 radiosity.cover=center radiosity.turned=off",
        "elements=800 radiosity.bins=8 bounces=2 radiosity.links=pairs",
        "elements=800 radiosity.bins=8 bounces=2"};
    for (int way = 0; way < 3; way++) {
        struct stage stage;
        struct renderer renderer;
        struct probe probe = {0};
        struct pick pick;
        struct element_view view = {0};
        double cosines = 0, sum = 0;
        int levels = 0;
        open_frame(&stage, &renderer, "implicit-visibility", settings[way]);
        check_ok("pick", probe_pick(&probe, &renderer, .5F, .93F, &pick));
        assert_true(pick.present && pick.normal[1] > .99F);
        renderer_read_element(&renderer, pick.position, pick.normal, &view);
        assert_int_equal(view.side, 8);
        for (int i = 0; i < ELEMENT_FACES * 8 * 8; i++) {
            cosines += (double)view.bins[i].cosine;
            sum += (double)(view.bins[i].cosine * view.bins[i].radiance[0]);
            levels = view.bins[i].level > levels ? view.bins[i].level : levels;
        }
        check_near("light of bins over irradiance",
                   sum * GLM_PI / cosines / (double)view.irradiance[0], 1, 1e-4);
        check_at_most("a partner's level, at least", 1, levels);
        check_at_most("distance from the click, m",
                      (double)glm_vec3_distance(view.position, pick.position),
                      .15 * (double)stage.geometry.radius);
        if (way == 0) /* bins of the world, of the partners' middles */
            assert_int_equal(count_misplaced(&view), 0);
        element_view_free(&view);
        renderer_read_element(&renderer, pick.position, (const float[3]){0, 0, 0}, &view);
        assert_int_equal(view.side, 0);
        probe_free(&probe);
        close_frame(&stage, &renderer);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pictures),     cmocka_unit_test(test_missing),
        cmocka_unit_test(test_shaders_kept), cmocka_unit_test(test_pick),
        cmocka_unit_test(test_ball),         cmocka_unit_test(test_voxel_light),
        cmocka_unit_test(test_element),
    };
    return cmocka_run_group_tests_name("inspect", tests, open_group_context, close_group_context);
}
