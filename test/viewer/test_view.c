/* The viewer with real input events; what it shows is checked by picture: against pictures rendered
 * offscreen, bit for bit. Skipped without Xvfb or xdotool. */
#define _XOPEN_SOURCE 700
#include "view_stage.h"

#define SCENE "scenes/cornell-box.glb"

/* How many pixels differ where no overlay lies: messages are below, the mouse in the middle. */
static int count_on_screen(const struct bitmap *expected) {
    OWNED(bitmap) screen = read_screen();
    int different = 0;
    for (int y = 0; y < HEIGHT - 120; y++)
        for (int x = 0; x < WIDTH; x++)
            if (abs(x - WIDTH / 2) + abs(y - HEIGHT / 2) > 30)
                different += memcmp(pixel(expected, x, y), pixel(&screen, x, y), 3) != 0;
    return different;
}

TEST(first_picture) {
    start_viewer(SCENE, "");
    check_same("the window's picture", SCENE);
    /* And so it is on the screen, where no overlay lies. */
    xdo("key " F3 " key " F3);
    sync_viewer();
    OWNED(bitmap) expected = offscreen(SCENE);
    int different = 1;
    for (int i = 0; i < PATIENCE_MS / 100 && different > 0;
         i++) { /* the server draws what it is sent in its own time */
        different = count_on_screen(&expected);
        pause_ms(different ? 100 : 0);
    }
    printf("    %-48s %d pixels differ\n", "on the screen", different);
    assert_int_equal(different, 0);
}

TEST(wipe) {
    need_viewer();
    xdo("key c");
    sync_viewer();
    xdo("mousemove %d %d mousedown 1 mousemove %d %d mouseup 1", WIDTH / 2, 80, WIDTH / 4, 80);
    sync_viewer();
    struct bitmap left = offscreen(SCENE), right = offscreen(SCENE " --technique unshadowed"),
                  screen = read_screen();
    int wrong = 0, told_apart = 0;
    for (int y = 0; y < HEIGHT - 140; y++)
        for (int x = 0; x < WIDTH; x++) {
            if (abs(x - WIDTH / 4) < 24) /* the line and the mouse on it */
                continue;
            const struct bitmap *side = x < WIDTH / 4 ? &left : &right;
            wrong += memcmp(pixel(side, x, y), pixel(&screen, x, y), 3) != 0;
            told_apart += memcmp(pixel(&left, x, y), pixel(&right, x, y), 3) != 0;
        }
    printf("    %-48s %d pixels wrong, %d differ between the two\n", "wipe", wrong, told_apart);
    assert_int_equal(wrong, 0);
    assert_true(told_apart > WIDTH * HEIGHT / 20);
    bitmaps_free(&left, &right, &screen);
    xdo("key c"); /* no reference is loaded: off */
}

/* Esc closes the help and asks once before it ends all; the exposure goes by keys. */
TEST(keys) {
    need_viewer();
    xdo("key " F1 " key Escape key Escape");
    sync_viewer();
    pause_ms(2200); /* after which it asks again */
    xdo("key Escape");
    xdo("key equal key equal key minus");
    check_same("half a stop brighter", SCENE " --set exposure=.5");
    xdo("key ctrl+c key 0"); /* no comparison */
    check_same("exposure 0", SCENE);
}

TEST(panel) {
    need_viewer();
    int x, y;
    find_place("virtual lights", &x, &y);
    /* Ctrl and a click let a slider's value be typed. */
    xdo("mousemove %d %d keydown ctrl click 1 keyup ctrl type --delay 1 96", x, y);
    xdo("key Return");
    check_same("VPLs typed into the panel", SCENE " --set vpls=96");
    press("technique");
    press("unshadowed");
    check_same("technique chosen in the panel", SCENE " --set vpls=96 --technique unshadowed");
    assert_false(is_on_screen("shadow groups")); /* it has none */
    rest_mouse();
    xdo("key ctrl+z");
    check_same("taken back", SCENE " --set vpls=96");
    xdo("key ctrl+z");
    check_same("and back", SCENE);
    xdo("key ctrl+y key ctrl+shift+z");
    check_same("and forth again", SCENE " --set vpls=96 --technique unshadowed");
}

TEST(orbit) {
    need_viewer();
    struct bitmap before = screenshot();
    xdo("mousemove 60 300 mousedown 1 mousemove 90 310 mousemove 100 315 mouseup 1 click 4");
    struct bitmap after = screenshot();
    assert_true(count_differences(&before, &after) > WIDTH * HEIGHT / 4);
    bitmaps_free(&before, &after);

    save_settings();
    char camera[400];
    read_setting("camera", camera, sizeof camera);
    printf("    %s\n", camera);
    assert_non_null(strstr(camera, "eye="));
    const char *arguments =
        form(SCENE " --set vpls=96 --technique unshadowed --camera \"%s\"", camera);
    check_same("an orbit, rendered by the saved camera", arguments);
}

/* By the path typed into the panel. */
TEST(open) {
    need_viewer();
    open_by_panel("scenes/no-such-file.glb"); /* an error, and the window lives on */
    open_by_panel("scenes/sphere.glb");
    wait_for_scene("sphere.glb");
    check_same("another scene", "scenes/sphere.glb --set vpls=96 --technique unshadowed");
}

/* At rest it goes on to the mean of some passes; another picture begins with a frame. */
TEST(passes) {
    need_viewer();
    end_viewer();
    start_viewer(SCENE, "--passes 3");
    sync_viewer();
    check_same("three passes at rest", SCENE " --passes 3");
    open_by_panel("scenes/sphere.glb");
    wait_for_scene("sphere.glb");
    sync_viewer();
    check_same("three passes of another scene", "scenes/sphere.glb --passes 3");
}

TEST(end) {
    need_viewer();
    end_viewer();
}

/* A budget that nothing meets takes the least of all settings but those that are given. */
TEST(frame_budget) {
    char value[64];
    start_viewer(SCENE, CHEAP " --budget .001ms");
    need_viewer();
    save_settings();
    read_setting("picture.samples", value, sizeof value);
    assert_string_equal(value, "1");
    read_setting("clustered.vals", value, sizeof value);
    assert_string_equal(value, "4");
    end_viewer();
}

/* A preset sets all but how the picture is exposed; a number beside its slider is typed after a
 * click. */
TEST(presets) {
#define DRAFT                                                                                      \
    SCENE " --set path=draft --set rsm-size=512 --set vals=30 --set map-size=256 "                 \
          "--set shadow-size=2048 --set interleave=8 --set exposure=.5 "
    start_viewer(SCENE, "--set exposure=.5");
    press("Draft");
    rest_mouse();
    check_same("a preset", DRAFT "--set vpls=256");
    int x, y;
    find_place("virtual lights", &x, &y);
    click(WIDTH + PANEL - 80, y);
    xdo("type --delay 1 100");
    xdo("key Return");
    check_same("a number typed", DRAFT "--set vpls=100");
    press("Advanced");
    assert_true(is_on_screen("light map texels"));
    assert_false(is_on_screen("Fourier terms")); /* of another visibility */
    end_viewer();
}

TEST(script) {
    need_server();
    const char *path = form("%s/script.png", stage.folder);
    /* GLFW unloads the driver at the end, and with it the names of what the driver loses;
     * test_view_leaks looks for ours. */
    assert_int_equal(shell("ASAN_OPTIONS=detect_leaks=0 %s view " SCENE " --size %dx%d " CHEAP
                           " --frames 3 --screenshot %s",
                           stage.binary, WIDTH, HEIGHT, path),
                     0);
    struct bitmap got = read_bitmap(path), expected = offscreen(SCENE);
    assert_int_equal(count_differences(&got, &expected), 0);
    bitmaps_free(&got, &expected);
    assert_int_equal(shell("%s view no-such-file.glb --frames 1 2>/dev/null", stage.binary), 1);
    assert_int_equal(shell("%s view " SCENE " --reference no-such-file.exr --frames 1 2>/dev/null",
                           stage.binary),
                     1);
}

RUN_TESTS(open_view_stage, close_view_stage)
