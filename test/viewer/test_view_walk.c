/* The first time, with mouse and keys: start without arguments, click a scene, hold it against the
 * reference, find the cheapest setting below 5 % error, copy a command line; in at most ten
 * clicks. */
#define _XOPEN_SOURCE 700
#include "view_stage.h"

static int click_count;

/* Waits for what may take minutes on a busy machine. */
static void wait_for(const char *name) {
    for (int i = 0; i < 1200 && !is_on_screen(name); i++)
        pause_ms(100);
}

/* Until more is seen of the wall than a word on a ground. */
static void wait_for_picture(void) {
    for (int i = 0; i < 3000; i++) {
        struct bitmap screen = read_screen();
        int changes = 0;
        for (int x = 1; x < WIDTH; x++)
            changes += memcmp(pixel(&screen, x, 240), pixel(&screen, x - 1, 240), 3) != 0;
        bitmap_free(&screen);
        if (changes > WIDTH / 4)
            return;
        pause_ms(100);
    }
    fail_msg("no picture came");
}

static void click_on(const char *name) {
    press(name);
    click_count++;
}

TEST(start) {
    const char *arguments = form("--size %dx%d", WIDTH, HEIGHT);
    start_empty_viewer(arguments);
    click_on("cornell-box");
    wait_for_scene("cornell-box.glb");
    wait_for("Measure speed and accuracy");
    wait_for_picture();
}

TEST(reference) {
    need_viewer();
    click_on("Measure speed and accuracy");
    wait_for("Take the cheapest below 5 %");
    int y = HEIGHT / 2;
    xdo("mousemove %d %d mousedown 1 mousemove %d %d mouseup 1", WIDTH / 2, y, WIDTH * 3 / 4, y);
    click_count++;
}

TEST(cheapest) {
    need_viewer();
    click_on("Take the cheapest below 5 %");
}

/* The picture by the command that was copied is the one left of the wipe. */
TEST(copy) {
    need_viewer();
    const char *command = copy_command();
    click_count += 2; /* Settings, Copy command line */
    rest_mouse();
    sync_viewer();
    struct bitmap shown = screenshot();
    assert_int_equal(shell("cd %s && %s >render.log", stage.folder, command), 0);
    const char *path = form("%s/picture.png", stage.folder);
    struct bitmap made = read_bitmap(path);
    int different = 0;
    for (int py = 0; py < HEIGHT; py++)
        for (int px = 0; px < WIDTH / 2 - 20; px++)
            different += memcmp(pixel(&made, px, py), pixel(&shown, px, py), 3) != 0;
    printf("    %d clicks; the copied command's picture: %d pixels differ\n", click_count,
           different);
    assert_int_equal(different, 0);
    assert_true(click_count <= 10);
    bitmaps_free(&made, &shown);
    end_viewer();
}

RUN_TESTS(open_view_stage, close_view_stage)
