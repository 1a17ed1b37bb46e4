/* The viewer at rest does nothing, and says so before it is busy. */
#define _XOPEN_SOURCE 700
#include "view_stage.h"

#include <unistd.h>

#define BOX "scenes/cornell-box.glb"

static void check_idle(const char *what) {
    const double seconds = 5;
    double before = used_seconds();
    pause_ms((long)(1000 * seconds));
    double share = (used_seconds() - before) / seconds;
    printf("    %-48s %.2f %% of a core, at most 2 %%\n", what, 100 * share);
    assert_true(share <= .02);
}

TEST(idle) {
    start_viewer(BOX, "");
    sync_viewer();
    xdo("mousemove %d %d sleep 9", WIDTH / 2, HEIGHT / 2); /* messages go */
    check_idle("a picture at rest");
    /* It wakes up for what happens, and messages end by themselves. */
    check_same("after a rest", BOX);
    xdo("key c");
    sync_viewer();
    pause_ms(9000);
    check_idle("a comparison at rest");
    xdo("key c");
}

/* A script's places have the sign in the frame before what takes long. */
static bool saw(const char *text) {
    char output[64];
    const char *command = form("grep -q %s %s/places", text, stage.folder);
    for (int i = 0; i < PATIENCE_MS / 10; i++) {
        if (run_command(command, output, sizeof output) == 0)
            return true;
        pause_ms(10);
    }
    return false;
}

TEST(sign) {
    need_viewer();
    press("technique");
    int x, y;
    find_place("instant-radiosity", &x, &y);
    xdo("mousemove %d %d click 1", x, y);
    bool seen = saw("compiling");
    printf("    a sign before shaders are compiled: %s\n", seen ? "seen" : "none");
    assert_true(seen);
    check_same("and then", BOX " --technique instant-radiosity");
    assert_false(is_on_screen("compiling shaders \xe2\x80\xa6"));
    end_viewer();
}

/* Ctrl S saves, and moves nothing however long it is held. */
TEST(save_key) {
    const char *path = form("%s/manylight.settings", stage.folder);
    char camera[600];
    start_empty_viewer("--size 100x740");
    open_by_panel(BOX);
    wait_for_scene("cornell-box.glb");
    xdo("keydown ctrl keydown s sleep .5 keyup s keyup ctrl");
    xdo("keydown alt keydown w sleep .5 keyup w keyup alt");
    sync_viewer();
    remove(path);
    xdo("key ctrl+s");
    for (int i = 0; i < PATIENCE_MS / 50 && access(path, R_OK) != 0; i++)
        pause_ms(50);
    read_setting("camera", camera, sizeof camera);
    assert_string_equal(camera, "0");
    end_viewer();
}

/* Measured at rest, and then with a caret: a twentieth of a core for some 100 thousand pixels. */
TEST(caret) {
    start_viewer(BOX, "");
    press("open");
    rest_mouse();
    pause_ms(9000); /* messages go */
    double before = used_seconds();
    pause_ms(5000);
    double share = (used_seconds() - before) / 5;
    printf("    a caret: %.1f %% of a core, at most 5 %%\n", 100 * share);
    assert_true(share <= .05);
    xdo("key Escape");
    end_viewer();
}

RUN_TESTS(open_view_stage, close_view_stage)
