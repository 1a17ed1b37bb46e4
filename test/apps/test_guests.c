/* A technique and a direct method that only tests have go through every subcommand: nothing in the
 * program knows VPLs, maps or a blur to be there. */
#include "command_support.h"

/* Runs the guests' program and looks for the words in what it says. */
static void expect_words(int status, const char *words, const char *format, const char *argument) {
    const char *build = getenv("MANYLIGHT_BUILD");
    const char *arguments = form(format, argument);
    const char *command = form("%s/test/guests/manylight %s", build ? build : "build", arguments);
    int actual = run_command(command, output, sizeof output);
    if (actual != status || !strstr(output, words))
        fail_msg("%s: status %d, expected %d with '%s':\n%s", arguments, actual, status, words,
                 output);
}

TEST(render) {
    const char *path = scratch("guests.exr");
    expect_words(
        0, "ambient  ",
        "render scenes/cornell-box.glb -o %s --size 64x48 --technique ambient --direct headlamp "
        "--set level=.5 --stats --gl-debug",
        path);
    assert_null(strstr(output, "VPLs"));
    OWNED(image) image;
    check_ok("read", image_read(&image, path));
    int alpha = image_find_channel(&image, "A"),
        indirect = image_find_channel(&image, "indirect.R"),
        direct = image_find_channel(&image, "direct.G");
    float level = 0, nearest = 0;
    for (int y = 0; y < image.height; y++)
        for (int x = 0; x < image.width; x++) {
            const float *pixel = image_at(&image, x, y);
            if (pixel[alpha] < 1)
                continue;
            level = level > 0 ? level : pixel[indirect];
            assert_true(fabsf(pixel[indirect] - level) <= 1e-6F * level);
            nearest = fmaxf(nearest, pixel[direct]);
        }
    printf("    indirect %g everywhere, direct at most %g\n", (double)level, (double)nearest);
    assert_true(level > 0);
    check_near("a surface that faces the lamp, times pi", (double)nearest * 3.14159265, 1, .02);
}

TEST(lists) {
    expect_words(0, "ambient.level", "render --help --technique %s", "ambient");
    expect_text("headlamp");
    assert_null(strstr(output, "clustered.vals"));
    expect_words(0, "clustered.vals", "render --help%s", "");
    assert_null(strstr(output, "ambient.level"));
    expect_words(2, "level: '-1' is not a number from 0 to 100",
                 "render a.glb -o a.png --technique ambient --set %s", "level=-1");
}

/* What it makes can be had as a layer; what it lacks is refused by name. */
TEST(outputs) {
    const char *path = scratch("guests-aov.exr");
    static const char *const lacking[] = {"val", "vpl", "visibility", "gathered", "val-depth"};
    const char *arguments =
        form("render scenes/cornell-box.glb -o %s --size 32x24 --technique ambient --aov", path);
    for (size_t i = 0; i < sizeof lacking / sizeof *lacking; i++) {
        char all[700];
        snprintf(all, sizeof all, "%s %s", arguments, lacking[i]);
        const char *words = form("technique 'ambient' has no layer '%s'", lacking[i]);
        expect_words(1, words, "%s", all);
    }
    char all[700];
    snprintf(all, sizeof all, "%s irradiance", arguments);
    expect_words(0, "", "%s", all);
}

/* In a window, against a technique that has all, stepping through what there is. */
TEST(view) {
    char command[900];
    need_command("command -v xvfb-run");
    snprintf(command, sizeof command, "%s view --help", binary_path());
    need_command(command);
    const char *build = getenv("MANYLIGHT_BUILD"), *picture = scratch("guests-view.png");
    /* What the driver loses when GLFW unloads it is not ours to find. */
    snprintf(command, sizeof command,
             "ASAN_OPTIONS=detect_leaks=0 timeout -k 5 60 xvfb-run -a %s/test/guests/manylight "
             "view scenes/cornell-box.glb "
             "--technique ambient --direct headlamp --size 120x100 --frames 2 --screenshot %s "
             "</dev/null",
             build ? build : "build", picture);
    int status = run_command(command, output, sizeof output);
    if (status != 0)
        fail_msg("view: status %d:\n%s", status, output);
    OWNED(image) image;
    check_ok("screenshot", image_read(&image, picture));
    assert_true(image.width == 120 && image.height == 100);
}

TEST(compare) {
    const char *other = form("%s", scratch("guests-other.exr"));
    expect_words(
        0, "",
        "render scenes/cornell-box.glb -o %s --size 64x48 --technique ambient --direct headlamp "
        "--set ambient.level=1 --quiet",
        other);
    const char *arguments = form("compare %s %s -l indirect", scratch("guests.exr"), other);
    expect_words(0, "relative-bias", "%s", arguments);
    const char *bias = strstr(output, "relative-bias");
    check_near("half the level: relative bias", atof(bias + 13), -.5, 1e-4);
}

TEST(bench) {
    const char *csv = scratch("guests.csv");
    static const char small[] = "--size 32x24 --frames 2 --variant ambient -q --csv";
    char arguments[512];
    snprintf(arguments, sizeof arguments, "bench times scenes/cornell-box.glb %s %%s", small);
    expect_words(0, "  frame/ambient ", arguments, csv);
    assert_null(strstr(output, "and VPL "));
    snprintf(arguments, sizeof arguments,
             "bench sweep scenes/cornell-box.glb --vary level=.5,1 --reference vpls %s %%s", small);
    expect_words(0, "level=.5 ", arguments, csv);
    snprintf(arguments, sizeof arguments, "bench temporal scenes/moving-spot.glb %s %%s", small);
    expect_words(0, "  ambient ", arguments, csv);
}

RUN_TESTS(NULL, NULL)
