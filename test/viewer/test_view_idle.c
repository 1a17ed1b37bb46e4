/* The viewer at rest does nothing, and says so before it is busy. */
#define _XOPEN_SOURCE 700
#include "view_stage.h"

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

RUN_TESTS(open_view_stage, close_view_stage)
