/* manylight info. */
#include "gltf_parts.h"

#include <stdio.h>
#include <string.h>

static char output[8192];

static int info(const char *arguments) {
    char command[512];
    snprintf(command, sizeof command, "%s info %s", binary_path(), arguments);
    return run_command(command, output, sizeof output);
}

static void check_says(const char *text) {
    if (!strstr(output, text))
        fail_msg("'%s' is not in:\n%s", text, output);
}

static void test_gl(void **state) {
    (void)state;
    if (info("") != 0) {
        printf("    skipped: %s\n", output);
        skip();
    }
    check_says("context   ");
    check_says("renderer  ");
    check_says("uniform block bytes");
}

static void test_scene(void **state) {
    (void)state;
    assert_int_equal(info("scenes/cornell-box.glb"), 0);
    check_says("72 vertices, 36 triangles (36 without alpha mask)");
    check_says("(-2.78, 0, -2.796) to (2.78, 5.488, 2.796) m");
    check_says(
        "  0  white                base colour (0.725, 0.71, 0.68), metalness 0, roughness 1");
    check_says("lights     1\n");
    check_says("spot (500, 500, 500) W/sr at (1.1, 2.3, 1.9)");
    check_says("cameras    1\n");
    check_says("perspective, 39.31 degrees high, at (0, 2.73, 10.8) towards (0, 0, -1)");
    assert_null(strstr(output, "renderer"));
}

static void test_point_light(void **state) {
    (void)state;
    assert_int_equal(info("scenes/sphere.glb"), 0);
    check_says("point (3.142, 3.142, 3.142) W/sr at (0, 0, 0)\n");
}

/* Names are those of nodes, as in messages; of what a node without a name carries. */
static void test_names(void **state) {
    (void)state;
    char arguments[1024];
    const char *path = write_parts(
        "names.glb",
        &(struct gltf_parts){
            .nodes = "[{\"mesh\": 0}, {\"name\": \"Eye node\", \"camera\": 0}, {\"camera\": 0},"
                     " {\"name\": \"Lamp node\", \"extensions\": {\"KHR_lights_punctual\":"
                     " {\"light\": 0}}}, {\"extensions\": {\"KHR_lights_punctual\":"
                     " {\"light\": 0}}}]",
            .more = "\"cameras\": [{\"name\": \"Eye data\", \"type\": \"perspective\","
                    " \"perspective\": {\"yfov\": 1, \"znear\": 1}}], \"extensions\":"
                    " {\"KHR_lights_punctual\": {\"lights\": [{\"name\": \"Lamp data\","
                    " \"type\": \"point\"}]}},"});
    assert_int_equal(info(path), 0);
    check_says("  0  Eye node             perspective");
    check_says("  1  Eye data             perspective");
    check_says("  0  Lamp node            point");
    check_says("  1  Lamp data            point");
    snprintf(arguments, sizeof arguments, "%s reference %s -o %s --camera none", binary_path(),
             path, scratch("none.exr"));
    assert_int_equal(run_command(arguments, output, sizeof output), 1);
    check_says("(there is: 0=Eye node 1=Eye data)");
    snprintf(arguments, sizeof arguments, "%s reference %s -o %s --light none", binary_path(), path,
             scratch("none.exr"));
    assert_int_equal(run_command(arguments, output, sizeof output), 1);
    check_says("(there is: 0=Lamp node 1=Lamp data)");
}

static void test_refusals(void **state) {
    (void)state;
    assert_int_equal(info("no-such-scene.glb"), 1);
    assert_string_equal(
        output, "manylight info: cannot open no-such-scene.glb: No such file or directory\n");
    assert_int_equal(info("one.glb two.glb"), 2);
    assert_int_equal(info("--context glx"), 2);
    check_says("one of auto, egl, osmesa");
    assert_int_equal(info("--context osmesa --device 0"), 1);
    check_says("no EGL device 0 (there are 0, counted from 0)");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_gl),          cmocka_unit_test(test_scene),
        cmocka_unit_test(test_point_light), cmocka_unit_test(test_names),
        cmocka_unit_test(test_refusals),
    };
    return cmocka_run_group_tests_name("info", tests, NULL, NULL);
}
