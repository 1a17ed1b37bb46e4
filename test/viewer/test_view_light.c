/* The viewer's lights, by real input events: what is added, changed and removed there is what a
 * command line says, and the picture is the same, bit for bit. */
#define _XOPEN_SOURCE 700
#include "view_stage.h"

#include "scene/placing.h"

#define BOX "scenes/cornell-box.glb"

/* What is saved of the lights, as text and as lights. */
static struct emitters saved_lights(char *text, size_t size) {
    OWNED(scene) scene;
    struct emitters emitters = {0};
    save_settings();
    read_setting("light", text, size);
    printf("    %s\n", text);
    check_ok(BOX, scene_load(&scene, BOX));
    check_ok(text, emitters_from_text(&emitters, &scene, text, 0));
    return emitters;
}

static void check_picture(const char *what, const char *lights) {
    const char *arguments = form(BOX " --light \"%s\"", lights);
    check_same(what, arguments);
}

TEST(add) {
    char text[600];
    start_viewer(BOX, "");
    check_picture("the scene's light", "0");
    press("Light");
    press("+ area");
    sync_viewer();
    press("Light");
    OWNED(emitters) lights = saved_lights(text, sizeof text);
    assert_int_equal(lights.count, 2);
    assert_int_equal(lights.items[1].type, EMITTER_AREA);
    assert_true(lights.items[1].size[0] > 0 && lights.items[1].size[1] > 0);
    check_picture("a light that was added", text);
}

/* Where the handle of the width is: as far from the shape as viewer/scene/light_tool.c has it. */
static void find_handle(const struct emitter *light, float at[2]) {
    struct scene scene;
    struct camera camera;
    float middle[2], edge[2], point[3];
    check_ok(BOX, scene_load(&scene, BOX));
    camera_place(&camera, &scene, 0, 0);
    scene_free(&scene);
    for (int i = 0; i < 3; i++)
        point[i] = light->position[i] + light->right[i] * light->size[0] / 2;
    const float aspect = (float)WIDTH / HEIGHT;
    assert_true(camera_project(&camera, light->position, aspect, middle));
    assert_true(camera_project(&camera, point, aspect, edge));
    float along[2] = {(edge[0] - middle[0]) * WIDTH, (edge[1] - middle[1]) * HEIGHT};
    float length = hypotf(along[0], along[1]);
    at[0] = edge[0] * WIDTH + 26 * along[0] / length;
    at[1] = edge[1] * HEIGHT + 26 * along[1] / length;
}

LONG_TEST(size) {
    char text[600];
    float at[2];
    need_viewer();
    OWNED(emitters) before = saved_lights(text, sizeof text);
    find_handle(&before.items[1], at);
    printf("    the handle of the width: %.0f %.0f\n", (double)at[0], (double)at[1]);
    xdo("mousemove %.0f %.0f mousedown 1 mousemove %.0f %.0f mouseup 1", (double)at[0],
        (double)at[1], (double)at[0] - 24, (double)at[1]);
    OWNED(emitters) after = saved_lights(text, sizeof text);
    printf("    %.4g m wide, then %.4g m\n", (double)before.items[1].size[0],
           (double)after.items[1].size[0]);
    assert_true(after.items[1].size[0] < .85F * before.items[1].size[0]);
    assert_true(after.items[1].size[1] == before.items[1].size[1]);
    assert_memory_equal(after.items[1].position, before.items[1].position, 12);
    check_picture("a light that was made narrower", text);
}

/* The chosen light's watts, and its colour, of which the green is what lies in the row's middle:
 * its power stays. */
LONG_TEST(power_and_color) {
    char text[600];
    need_viewer();
    press("Light");
    type_into("power, W", "7.5");
    type_into("colour", "0");
    press("Light");
    OWNED(emitters) lights = saved_lights(text, sizeof text);
    const struct emitter *light = &lights.items[1];
    double power = emitter_flux(light, 1);
    printf("    %.6g W, of %g %g %g\n", power, (double)light->intensity[0],
           (double)light->intensity[1], (double)light->intensity[2]);
    assert_true(fabs(power / 7.5 - 1) < 1e-5);
    assert_true(light->intensity[1] == 0 && light->intensity[0] > 0 && light->intensity[2] > 0);
    check_picture("a light of other watts and colour", text);
}

/* The type of the chosen light, which is the one that was added; its power stays. */
TEST(type) {
    char text[600];
    need_viewer();
    OWNED(emitters) before = saved_lights(text, sizeof text);
    press("Light");
    press("type");
    press("point");
    sync_viewer();
    press("Light");
    OWNED(emitters) after = saved_lights(text, sizeof text);
    assert_int_equal(after.items[1].type, EMITTER_POINT);
    double power[2] = {emitter_flux(&before.items[1], 1), emitter_flux(&after.items[1], 1)};
    printf("    %.6g W, then %.6g W\n", power[0], power[1]);
    assert_true(fabs(power[1] / power[0] - 1) < 1e-5);
    check_picture("a light of another type", text);
}

LONG_TEST(cone) {
    char text[600];
    need_viewer();
    press("Light");
    press("type");
    press("spot");
    sync_viewer();
    type_into("outer angle, \xc2\xb0", "40");
    type_into("inner angle, \xc2\xb0", "30");
    press("Light");
    OWNED(emitters) lights = saved_lights(text, sizeof text);
    const struct emitter *light = &lights.items[1];
    assert_int_equal(light->type, EMITTER_SPOT);
    double inner = acos((double)light->cos_inner), outer = acos((double)light->cos_outer);
    printf("    %.6g to %.6g degrees\n", inner * 180 / M_PI, outer * 180 / M_PI);
    assert_true(fabs(inner * 6 / M_PI - 1) < 1e-4 && fabs(outer * 4.5 / M_PI - 1) < 1e-4);
    check_picture("a spot of another cone", text);
}

/* Where the chosen light's light ends; undone, and there again. */
LONG_TEST(range) {
    char text[600], ranged[600];
    need_viewer();
    press("Light");
    type_into("range, m", "4");
    press("Light");
    OWNED(emitters) lights = saved_lights(ranged, sizeof ranged);
    printf("    the light ends after %g m\n", (double)lights.items[1].range);
    assert_true(lights.items[1].range == 4);
    assert_non_null(strstr(ranged, "range=4"));
    check_picture("a light that ends", ranged);
    emitters_free(&lights);
    xdo("key ctrl+z");
    lights = saved_lights(text, sizeof text);
    assert_true(lights.items[1].range == 0);
    check_picture("taken back", text);
    emitters_free(&lights);
    xdo("key ctrl+y");
    check_picture("and again", ranged);
    press("Light");
    press("light"); /* the scene's is chosen */
    press("added 1");
    type_into("range, m", "0");
    press("Light");
    lights = saved_lights(text, sizeof text);
    assert_true(lights.items[1].range == 0);
}

TEST(remove) {
    char text[600];
    need_viewer();
    press("Light");
    press("Remove this light");
    sync_viewer();
    press("Light");
    struct emitters lights = saved_lights(text, sizeof text);
    assert_int_equal(lights.count, 1);
    assert_string_equal(text, "0");
    check_picture("without it", text);
    emitters_free(&lights);
    end_viewer();
}

RUN_TESTS(open_view_stage, close_view_stage)
