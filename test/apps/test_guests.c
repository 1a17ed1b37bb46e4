/* A technique and a direct method that only tests have go through every subcommand: nothing in the
 * program knows VPLs, maps or a blur to be there. */
#include "command_support.h"

#define GUESTS BUILD "/test/guests/manylight "
#define BOX "scenes/cornell-box.glb "

TEST(render) {
    expect(0, GUESTS "render " BOX "-o @/guests.exr --size 64x48 --technique ambient "
                     "--direct headlamp --set level=.5 --stats --gl-debug");
    expect_text("ambient  ");
    assert_null(strstr(output, "VPLs"));
    OWNED(image) image;
    check_ok("read", image_read(&image, scratch("guests.exr")));
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
    expect(0, GUESTS "render --help --technique ambient");
    expect_text("ambient.level");
    expect_text("headlamp");
    assert_null(strstr(output, "clustered.vals"));
    expect(0, GUESTS "render --help");
    expect_text("clustered.vals");
    assert_null(strstr(output, "ambient.level"));
    expect(2, GUESTS "render a.glb -o a.png --technique ambient --set level=-1");
    expect_text("level: '-1' is not a number from 0 to 100");
}

/* What it makes can be had as a layer; what it lacks is refused by name. */
TEST(outputs) {
#define RENDER GUESTS "render " BOX "-o @/aov.exr --size 32x24 --technique ambient --aov "
    static const char *const lacking[] = {"val", "vpl", "visibility", "gathered", "val-depth"};
    for (size_t i = 0; i < sizeof lacking / sizeof *lacking; i++) {
        expect(1, form(RENDER "%s", lacking[i]));
        expect_text(form("technique 'ambient' has no layer '%s'", lacking[i]));
    }
    expect(0, RENDER "irradiance");
}

/* In a window, against a technique that has all, stepping through what there is. */
TEST(view) {
    need_command("command -v xvfb-run");
    need_command(form("%s view --help", binary_path()));
    /* What the driver loses when GLFW unloads it is not ours to find. */
    expect(0, "ASAN_OPTIONS=detect_leaks=0 timeout -k 5 60 xvfb-run -a " GUESTS "view " BOX
              "--technique ambient --direct headlamp --size 120x100 --frames 2 "
              "--screenshot @/view.png </dev/null");
    OWNED(image) image;
    check_ok("screenshot", image_read(&image, scratch("view.png")));
    assert_true(image.width == 120 && image.height == 100);
}

TEST(compare) {
    expect(0, GUESTS "render " BOX "-o @/other.exr --size 64x48 --technique ambient "
                     "--direct headlamp --set ambient.level=1 --quiet");
    expect(0, GUESTS "compare @/guests.exr @/other.exr -l indirect");
    expect_text("relative-bias");
    const char *bias = strstr(output, "relative-bias");
    check_near("half the level: relative bias", atof(bias + 13), -.5, 1e-4);
}

TEST(bench) {
#define SMALL " --size 32x24 --frames 2 --variant ambient -q --csv @/guests.csv"
    expect(0, GUESTS "bench times " BOX SMALL);
    expect_text("  frame/ambient ");
    assert_null(strstr(output, "and VPL "));
    expect(0, GUESTS "bench sweep " BOX "--vary level=.5,1 --reference vpls" SMALL);
    expect_text("level=.5 ");
    expect(0, GUESTS "bench temporal scenes/moving-spot.glb" SMALL);
    expect_text("  ambient ");
}

RUN_TESTS(NULL, NULL)
