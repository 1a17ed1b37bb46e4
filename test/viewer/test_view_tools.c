/* What the viewer is asked to do, by real input events: play, show layers, open what is dropped,
 * save and load, and live on after what fails. Checked by picture. */
#define _XOPEN_SOURCE 700
#include "view_stage.h"

#define MOVING "scenes/metaballs.glb"
#define BOX "scenes/cornell-box.glb"

/* Two pictures of the same view apart. */
static void check_apart(const char *what, const char *one, const char *other) {
    OWNED(bitmap) a = offscreen(one), b = offscreen(other);
    int apart = count_differences(&a, &b);
    printf("    %-48s %d pixels differ\n", what, apart);
    assert_true(apart > WIDTH * HEIGHT / 50);
}

TEST(play) {
    start_viewer(MOVING, "--time 1.5");
    check_same("at a time", MOVING " --time 1.5");
    xdo("key space sleep 2 key space");
    char time[64];
    press_in_settings("Save");
    read_setting("time", time, sizeof time);
    printf("    paused at %s s\n", time);
    assert_true(atof(time) > 1.6 || atof(time) < 1.4);
    const char *arguments = form(MOVING " --time %s", time);
    check_same("paused", arguments);
    check_apart("and what moved", arguments, MOVING " --time 1.5");
}

TEST(layers) {
    need_viewer();
    char time[64], arguments[200];
    read_setting("time", time, sizeof time);
    xdo("key 2");
    snprintf(arguments, sizeof arguments, MOVING " --layer indirect --time %s", time);
    check_same("indirect light", arguments);
    xdo("key 3");
    snprintf(arguments, sizeof arguments, MOVING " --layer direct --time %s", time);
    check_same("direct light", arguments);
}

/* Settings that were saved come back, in a viewer that has others. */
TEST(load) {
    need_viewer();
    write_in_stage("manylight.settings", "layer = indirect\ntime = 2.25\ntechnique = unshadowed\n"
                                         "light = 0 position=0.5,3,0.5\nvpls = 64\nvals = 4\n"
                                         "map-size = 32\nrsm-size = 64\nshadow-size = 256\n"
                                         "interleave = 4\nexposure = 1\n");
    press_in_settings("Load");
    check_same("loaded settings", MOVING " --layer indirect --time 2.25 --technique unshadowed "
                                         "--light '0 position=0.5,3,0.5' --set exposure=1");
    write_in_stage("manylight.settings", "vpls = many\n");
    press_in_settings("Load");
    check_same("after a bad line", MOVING " --layer indirect --time 2.25 --technique unshadowed "
                                          "--light '0 position=0.5,3,0.5' --set exposure=1");
}

TEST(drop) {
    need_viewer();
    drop("scenes/sphere.glb");
    wait_for_scene("sphere.glb");
    check_same("a scene that was dropped",
               "scenes/sphere.glb --layer indirect --technique unshadowed --set exposure=1");
    write_in_stage("broken.glb", "glTF and then nothing");
    drop(in_stage("broken.glb"));
    check_same("after a broken one",
               "scenes/sphere.glb --layer indirect --technique unshadowed --set exposure=1");
}

/* The command line that was copied renders the very same picture: another camera, light, layer. */
TEST(copy) {
    need_viewer();
    xdo("mousemove 60 300 mousedown 1 mousemove 90 310 mousemove 100 315 mouseup 1");
    const char *command = copy_command();
    assert_int_equal(strncmp(command, stage.binary, strlen(stage.binary)), 0); /* not on the path */
    check_command(command);
}

TEST(end) {
    need_viewer();
    end_viewer();
}

/* Left the technique, right what was rendered before, read from its EXR and toned alike. */
TEST(reference) {
    need_server();
    const char *arguments = form("--technique unshadowed --reference %s",
                                 render_file("reference.exr", WIDTH, HEIGHT, BOX));
    start_viewer(BOX, arguments);
    struct bitmap left = offscreen(BOX " --technique unshadowed"), right = offscreen(BOX),
                  shown = screenshot();
    int wrong = 0, apart = 0;
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const unsigned char *expected = pixel(x < WIDTH / 2 ? &left : &right, x, y),
                                *got = pixel(&shown, x, y);
            /* Half floats in the file. */
            for (int c = 0; c < 3; c++)
                wrong += abs(expected[c] - got[c]) > (x < WIDTH / 2 ? 0 : 1);
            apart += memcmp(pixel(&left, x, y), pixel(&right, x, y), 3) != 0;
        }
    printf("    wipe against a reference: %d values wrong, %d pixels differ between the two\n",
           wrong, apart);
    assert_int_equal(wrong, 0);
    assert_true(apart > WIDTH * HEIGHT / 20);
    bitmaps_free(&left, &right, &shown);
    end_viewer();
}

RUN_TESTS(open_view_stage, close_view_stage)
