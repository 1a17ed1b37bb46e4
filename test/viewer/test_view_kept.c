/* What outlives the window, by real input events: settings saved by a key, and how a scene was
 * left. A caret costs little. */
#define _XOPEN_SOURCE 700
#include "view_stage.h"

#include <unistd.h>

/* No option says how the scene is to look. */
#define NOTHING "--size 100x740"

static void open_box(void) {
    start_empty_viewer(NOTHING);
    open_by_panel("scenes/cornell-box.glb");
    wait_for_scene("cornell-box.glb");
}

/* By Ctrl S. */
static void read_camera(char camera[600]) {
    const char *path = form("%s/manylight.settings", stage.folder);
    sync_viewer();
    remove(path);
    xdo("key ctrl+s");
    for (int i = 0; i < PATIENCE_MS / 50 && access(path, R_OK) != 0; i++)
        pause_ms(50);
    read_setting("camera", camera, 600);
    printf("    camera %.60s\n", camera);
}

static int count_states(void) {
    char output[64];
    const char *command =
        form("echo $(ls %s/manylight/scenes/*.settings 2>/dev/null | wc -l)", stage.folder);
    assert_int_equal(run_command(command, output, sizeof output), 0);
    return atoi(output);
}

/* A scene that nobody changed is not kept. Ctrl S saves, and moves nothing however long it
 * is held. */
TEST(save_key) {
    char first[600], second[600];
    open_box();
    read_camera(first);
    assert_string_equal(first, "0");
    xdo("keydown ctrl keydown s sleep .5 keyup s keyup ctrl");
    xdo("keydown alt keydown w sleep .5 keyup w keyup alt");
    read_camera(second);
    assert_string_equal(second, first);
    end_viewer();
    assert_int_equal(count_states(), 0);
}

TEST(as_it_was_left) {
    char left[600], again[600];
    open_box();
    assert_false(is_on_screen("Afresh"));
    xdo("keydown w sleep .3 keyup w");
    read_camera(left);
    assert_string_not_equal(left, "0");
    end_viewer();
    assert_int_equal(count_states(), 1);
    open_box();
    assert_true(is_on_screen("Afresh"));
    read_camera(again);
    assert_string_equal(again, left);
    press("Afresh");
    rest_mouse();
    assert_false(is_on_screen("Afresh"));
    read_camera(again);
    assert_string_equal(again, "0");
    end_viewer();
    assert_int_equal(count_states(), 0);
}

/* Options that say how it is to look are meant. */
TEST(options_win) {
    open_box();
    xdo("keydown w sleep .3 keyup w");
    sync_viewer();
    end_viewer();
    assert_int_equal(count_states(), 1);
    start_viewer("scenes/cornell-box.glb", "");
    check_same("as the options have it", "scenes/cornell-box.glb");
    assert_false(is_on_screen("Afresh"));
    end_viewer();
    assert_int_equal(count_states(), 1);
}

/* Measured at rest, and then with a caret: a twentieth of a core for some 100 thousand pixels. */
TEST(caret) {
    start_viewer("scenes/cornell-box.glb", "");
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
