/* The panel by mouse and keyboard: answers come into view, rows take what is typed, Tab reaches all
 * widgets. By real input events. */
#include "view_stage.h"

#define BOX "scenes/cornell-box.glb"

static void begin(const char *arguments) {
    if (!stage.server)
        skip();
    start_viewer(BOX, arguments);
    sync_viewer();
}

/* Whether a label or a line of values begins so. */
static bool is_told(const char *start, char *text, size_t size) {
    char line[300];
    bool found = false;
    const char *path = form("%s/places", stage.folder);
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    while (!found && fgets(line, sizeof line, file)) {
        int at = 0;
        line[strcspn(line, "\n")] = '\0';
        found = sscanf(line, "%*d %*d %*d %*d %n", &at) == 0 && at > 0 &&
                strncmp(line + at, start, strlen(start)) == 0;
        if (found)
            snprintf(text, size, "%s", line + at);
    }
    fclose(file);
    return found;
}

/* The section is folded and two sections below the fold: the click opens it and leaves what is
 * under the mouse. */
TEST(click) {
    char text[200] = "";
    begin("");
    assert_false(is_told("position, m ", text, sizeof text));
    xdo("mousemove 150 640 click 1");
    sync_viewer();
    sync_viewer();
    assert_false(is_told("position, m ", text, sizeof text));
    for (int i = 0; i < 40 && !is_told("lit most by ", text, sizeof text); i++) {
        xdo("mousemove %d 500 click 5", WIDTH + PANEL / 2);
        sync_viewer();
    }
    assert_true(is_told("position, m ", text, sizeof text));
    printf("    %s\n", text);
    assert_true(is_told("lit most by ", text, sizeof text));
    printf("    %s\n", text);
    /* Without the panel a label on the picture tells it. */
    xdo("key " F2);
    sync_viewer();
    assert_true(is_told("lit by ", text, sizeof text));
    printf("    %s\n", text);
    assert_non_null(strchr(text, '%'));
    end_viewer();
}

/* In a window of 400 pixels the chart's place is below the edge until it is asked for. */
TEST(chart_comes_into_view) {
    begin("--size 100x400");
    press("Quality");
    press("Chart speed and accuracy");
    sync_viewer();
    bool shown = false;
    for (int i = 0; i < 200 && !shown; i++) {
        sync_viewer();
        shown = is_on_screen("chart");
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
    char text[64] = "";
    need_viewer();
    xdo("mousemove %d %d keydown ctrl keydown shift click --repeat 4 4 keyup shift keyup ctrl",
        WIDTH / 2, HEIGHT / 2);
    sync_viewer();
    bool told = is_told("244 %", text, sizeof text);
    printf("    four steps of the wheel: %s\n", text);
    assert_true(told);
    xdo("key z");
    sync_viewer();
    assert_false(is_told("244 %", text, sizeof text));
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
