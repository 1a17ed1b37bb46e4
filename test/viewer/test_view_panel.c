/* The panel by mouse and keyboard: answers come into view, rows take what is typed, Tab reaches all
 * widgets. By real input events. */
#include "view_stage.h"

#define BOX "scenes/cornell-box.glb"

static void begin(const char *arguments) {
    need_server();
    start_viewer(BOX, arguments);
    sync_viewer();
}

/* Whether a label or a line of values begins so. */
static bool is_told(const char *begin) {
    const char *text = find_text(begin);
    if (*text)
        printf("    %s\n", text);
    return *text;
}

/* The section is folded and two sections below the fold: the click opens it and leaves what is
 * under the mouse. */
TEST(click) {
    begin("");
    assert_false(is_told("position, m "));
    xdo("mousemove 150 640 click 1");
    sync_viewer();
    sync_viewer();
    assert_false(is_told("position, m "));
    for (int i = 0; i < 40 && !is_told("lit most by "); i++) {
        xdo("mousemove %d 500 click 5", WIDTH + PANEL / 2);
        sync_viewer();
    }
    assert_true(is_told("position, m ") && is_told("lit most by "));
    /* Without the panel a label on the picture tells it. */
    xdo("key " F2);
    sync_viewer();
    assert_true(is_told("lit by ") && strchr(find_text("lit by "), '%'));
    end_viewer();
}

/* In a window of 400 pixels the table's rows are below the edge until it is asked for. */
TEST(table_comes_into_view) {
    begin("--size 100x400");
    press("Quality");
    press("Measure speed and accuracy");
    sync_viewer();
    bool shown = false;
    for (int i = 0; i < 200 && !shown; i++) {
        sync_viewer();
        shown = is_on_screen("Draft##row");
    }
    assert_true(shown);
    end_viewer();
}

TEST(keyboard) {
    char value[64], text[64];
    begin("");
    xdo("key Tab"); /* the first heading */
    sync_viewer();
    xdo("key space"); /* folds */
    sync_viewer();
    assert_false(is_on_screen("open"));
    assert_true(is_on_screen("Draft"));
    xdo("key Tab"); /* Quality */
    sync_viewer();
    xdo("key Tab"); /* its presets */
    sync_viewer();
    xdo("key space 3"); /* presses; 3 is not the picture's */
    sync_viewer();
    xdo("key Escape");
    sync_viewer();
    save_settings();
    read_setting("lights.vpls", value, sizeof value);
    read_setting("layer", text, sizeof text);
    printf("    by Tab and Space: %s virtual lights, layer %s\n", value, text);
    assert_string_equal(value, "256");
    assert_string_equal(text, "full");
    /* Afterwards keys are the picture's again. */
    rest_mouse();
    xdo("key 3");
    save_settings();
    read_setting("layer", text, sizeof text);
    assert_string_equal(text, "direct");
    end_viewer();
}

TEST(two_clicks_type) {
    char value[64];
    int x, y;
    begin("");
    find_place("virtual lights", &x, &y);
    xdo("mousemove %d %d click --repeat 2 --delay 40 1", x, y);
    sync_viewer();
    xdo("key ctrl+a");
    sync_viewer();
    xdo("type --delay 1 100");
    xdo("key Return");
    rest_mouse();
    save_settings();
    read_setting("lights.vpls", value, sizeof value);
    printf("    typed after two clicks: %s\n", value);
    assert_string_equal(value, "100");
}

/* By a chord that no window manager takes. */
TEST(enlarge) {
    need_viewer();
    xdo("mousemove %d %d keydown ctrl keydown shift click --repeat 4 4 keyup shift keyup ctrl",
        WIDTH / 2, HEIGHT / 2);
    sync_viewer();
    assert_true(is_told("244 %")); /* four steps of the wheel */
    xdo("key z");
    sync_viewer();
    assert_false(is_told("244 %"));
    end_viewer();
}

TEST(filter) {
    begin("");
    press("Scene");
    press("Reference");
    press("Picture");
    press("Advanced");
    press("find");
    sync_viewer();
    assert_false(is_on_screen("blur radius"));
    xdo("type --delay 1 BLUR");
    sync_viewer();
    assert_true(is_on_screen("blur radius"));
    assert_false(is_on_screen("paths of bounces"));
    xdo("key Return"); /* lets the field go */
    rest_mouse();
    end_viewer();
}

/* Compare unfolds while one compares, and has the ways to lie. */
TEST(compare_unfolds) {
    begin("");
    press("Scene");
    press("Quality");
    rest_mouse();
    assert_false(is_on_screen("heat map"));
    xdo("key c");
    sync_viewer();
    sync_viewer();
    assert_true(is_on_screen("heat map"));
    assert_true(is_on_screen("side by side"));
    end_viewer();
}

/* The method of direct light is a row, and the command line has it. */
TEST(direct) {
    char value[64];
    begin("");
    press("Scene");
    press("direct light");
    press("pcss");
    save_settings();
    read_setting("direct", value, sizeof value);
    assert_string_equal(value, "pcss");
    check_same("pcss by its row", BOX " --direct pcss");
    xdo("key ctrl+z");
    save_settings();
    read_setting("direct", value, sizeof value);
    printf("    taken back: '%s'\n", value);
    assert_string_equal(value, "");
    end_viewer();
}

RUN_TESTS(open_view_stage, close_view_stage)
