/* The first minute, by real input events: scenes to click, files to choose, a picture
 * that is exposed by itself. */
#define _XOPEN_SOURCE 700
#include "view_stage.h"

#include "desktop.h"
#include "gltf_parts.h"

#define SIZE "--size 240x740 "

TEST(own_scenes) {
    start_empty_viewer(SIZE CHEAP_LIGHTS);
    press("cornell-box");
    wait_for_scene("cornell-box.glb");
    for (int i = 0; i < 200 && is_on_screen("Open a file ..."); i++)
        ;
    assert_false(is_on_screen("Open a file ..."));
}

/* It is neither of exposure 0 nor clamped, and its command line says so and makes the same. */
TEST(exposure) {
    need_viewer();
    const char *command = copy_command();
    assert_non_null(strstr(command, "picture.tone-map=filmic"));
    const char *exposure = strstr(command, "picture.exposure=");
    assert_non_null(exposure);
    assert_true(atof(exposure + strlen("picture.exposure=")) != 0);
    check_command(command);
    xdo("key equal key equal key 0");
    check_command(command);
}

/* Behind the door that is shut at 0 s nothing is seen but what leaks past it. */
TEST(darkness) {
    need_viewer();
    drop("scenes/door.glb");
    wait_for_scene("door.glb");
    const char *command = copy_command();
    assert_non_null(strstr(command, "--time 5"));
    const char *exposure = strstr(command, "picture.exposure="); /* 0 is left out */
    assert_true(!exposure || atof(exposure + strlen("picture.exposure=")) < 8);
    end_viewer();
}

/* The letters of a name are drawn, where a font has them: two names of one letter each look
 * different. */
TEST(letters) {
    if (shell("cd /usr/share/fonts && test -n \"$(ls */*/NotoSansCJK-Regular.ttc "
              "*/*/wqy-microhei.ttc */*/DroidSansFallbackFull.ttf 2>/dev/null)\"") != 0)
        skip();
    static const char *const names[] = {"\xe6\x9d\xb1", "\xe4\xba\xac"};
    int x, y[2], different = 0;
    start_viewer(
        write_parts("names.glb",
                    &PARTS(.materials = "[{name: '\xe6\x9d\xb1'}, {name: '\xe4\xba\xac'}]",
                           .meshes = "[{primitives: [{attributes: {POSITION: 0}, material: 0}, "
                                     "{attributes: {POSITION: 0}, material: 1}]}]")),
        "");
    press("What it holds");
    rest_mouse();
    for (int i = 0; i < 2; i++)
        find_place(names[i], &x, &y[i]);
    sync_viewer(); /* their letters come a frame later */
    struct bitmap screen = read_screen();
    for (int row = -7; row < 7; row++)
        for (int column = x - 100; column < x + 20; column++)
            different += memcmp(pixel(&screen, column, y[0] + row),
                                pixel(&screen, column, y[1] + row), 3) != 0;
    printf("    %d pixels differ between two letters\n", different);
    assert_true(different > 20);
    bitmap_free(&screen);
    end_viewer();
}

/* The desktop's own, where there is one. */
TEST(desktop_dialog) {
    need_server();
    assert_int_equal(shell("cp %s/scenes/sphere.glb %s/here.glb", stage.here, stage.folder), 0);
    assert_int_equal(shell("mkdir -p %s/bin && printf '#!/bin/sh\\nsleep .5; echo %s/here.glb\\n' "
                           "> %s/bin/zenity && "
                           "chmod +x %s/bin/zenity",
                           stage.folder, stage.folder, stage.folder, stage.folder),
                     0);
    const char *path = form("%s/bin:%s", stage.folder, getenv("PATH"));
    setenv("PATH", path, 1);
    start_empty_viewer(SIZE CHEAP_LIGHTS);
    press("Open a file ...");
    wait_for_scene("here.glb");
    end_viewer();
}

/* What was saved is there again, at twice the size of widgets. */
TEST(options) {
    need_server();
    write_in_stage("told.settings",
                   "layer = indirect\nvpls = 64\nvals = 4\nmap-size = 32\nrsm-size = 64\n"
                   "shadow-size = 256\ninterleave = 4\nexposure = 1\n");
    start_viewer("scenes/sphere.glb", "--settings told.settings --scale 1.25");
    check_same("by --settings", "scenes/sphere.glb --layer indirect --set exposure=1");
    int x, y, larger;
    find_place("Draft", &x, &y);
    assert_true(y > 150); /* 139 at scale 1 */
    xdo("key ctrl+equal key ctrl+equal key ctrl+minus");
    find_place("Draft", &x, &larger);
    xdo("key ctrl+0");
    int again = 0;
    for (int i = 0; i < 200 && again != y; i++) /* widgets come to their places in a frame or two */
        find_place("Draft", &x, &again);
    printf("    Draft at %d, larger at %d, again at %d\n", y, larger, again);
    assert_true(larger > y + 8 && again == y);
    check_same("at another scale", "scenes/sphere.glb --layer indirect --set exposure=1");
    end_viewer();
}

/* A field of the panel holds a text with these words in it. The server learns later than we that
 * there is one. */
static void expect_field(const char *name, const char *words) {
    char text[1000] = "";
    press(name);
    xdo("key ctrl+a key ctrl+c key Escape");
    rest_mouse();
    sync_viewer();
    for (int i = 0; i < PATIENCE_MS / 10 && !strstr(text, words); i++)
        desktop_read_clipboard(text, sizeof text);
    printf("    %s: %s\n", name, text);
    assert_non_null(strstr(text, words));
}

/* The panel's fields have what the command line gave; a scene's materials are listed. */
TEST(fields) {
    need_server();
    const char *path = render_file("reference.exr", WIDTH, HEIGHT, "scenes/sphere.glb");
    const char *arguments = form("--reference %s", path);
    start_viewer("scenes/sphere.glb", arguments);
    expect_field("open", "/scenes/sphere.glb");
    press("What it holds");
    assert_true(is_on_screen("half"));
    press("What it holds");
    press("Quality");
    press("Reference");
    press("Picture"); /* Compare is open: a reference is compared with */
    expect_field("file", path);
    end_viewer();
}

/* A window of its own: a least size; the picture alone until F2. */
TEST(window) {
    need_server();
    char output[64];
    int width, height, x, y;
    start_viewer("scenes/sphere.glb", "--no-panel");
    assert_int_equal(run_command("xdotool search --name manylight", output, sizeof output), 0);
    unsigned long window = strtoul(output, NULL, 10);
    assert_true(desktop_read_hints(window, &width, &height));
    printf("    at least %d x %d\n", width, height);
    assert_true(width == WIDTH && height == 240);
    assert_false(is_on_screen("Scene"));
    check_same("without a panel", "scenes/sphere.glb");
    xdo("key " F2);
    find_place("Scene", &x, &y);
    end_viewer();
}

RUN_TESTS(open_view_stage, close_view_stage)
