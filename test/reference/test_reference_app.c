/* manylight reference: the command, and its pictures against those of an independent path tracer */
#include "command_support.h"

#include "base/image.h"

#include <unistd.h>

enum { SIZE = 80 };

TEST(usage) {
    static const char *const wrong[][2] = {
        {"", "arguments are missing"},
        {"scenes/sphere.glb", "-o FILE.exr is missing"},
        {"scenes/sphere.glb -o x.png", "x.png: only EXR"},
        {"scenes/sphere.glb -o x.exr --noise -1%", "'-1%' is not a number from 0 to 1"},
        {"scenes/sphere.glb -o x.exr --noise 1% --spp 4", "exclude each other"},
        {"scenes/sphere.glb -o x.exr --technique vpl-raytraced --denoise", "--denoise is for"},
        {"scenes/sphere.glb -o x.exr --ao 0", "ao: '0' is not a number from 1e-06 to"},
        {"scenes/sphere.glb -o x.exr --ao -1m", "ao: '-1m' is not a number"},
        {"scenes/sphere.glb -o x.exr --ao nan", "ao: 'nan' is not a number"},
        {"scenes/sphere.glb -o x.exr --ao near", "ao: 'near' is not a number"},
        {"scenes/sphere.glb -o x.exr --ao 1 --technique vpl-raytraced",
         "--ao is for --technique path"},
        {"scenes/sphere.glb -o x.exr --light-paths 0", "'0' is not a whole number from 1 to"},
        {"scenes/sphere.glb -o x.exr --light-paths -5", "'-5' is not a whole number from 1"},
        {"scenes/sphere.glb -o x.exr --light-paths 9 --technique vpl-raytraced",
         "--light-paths is for --technique path"},
        {"scenes/sphere.glb -o x.exr --smooth --materials diffuse",
         "--smooth is for --materials full"},
        {"scenes/sphere.glb -o x.exr --set vpls=64", "--technique vpl-raytraced"},
        {"scenes/sphere.glb -o x.exr --technique vpl-raytraced --set medium.scatter=1",
         "sums of VPLs ignore a medium"},
        {NULL},
    };
    static const char *const failures[][2] = {
        {"no-such.glb -o x.exr", "no-such.glb"},
        {"scenes/sphere.glb -o x.exr --light sun", "no light 'sun'"},
        {"scenes/sphere.glb -o no/such/x.exr --size 8x8 --spp 4", "no/such/x.exr"},
        {NULL},
    };
    expect_command(0, "reference", "--help");
    expect_text("standard_error");
    expect_refusals(2, "reference", wrong);
    expect_refusals(1, "reference", failures);
    assert_int_equal(access("x.exr", F_OK), -1);
}

/* A scene without glass says so; one with glass in a medium has all layers. */
TEST(light_paths) {
    OWNED(image) image;
    expect(0, "% reference scenes/sphere.glb -o @/paths.exr --size 4x4 --spp 1 --light-paths 9");
    expect_text("no glass");
    expect(0, "% reference scenes/gem.glb -o @/paths.exr --size 16x12 --spp 4 --light-paths 20000");
    expect_text("20000 light paths");
    check_ok("read", image_read(&image, scratch("paths.exr")));
    static const char *const layers[] = {"caustic", "standard_error.caustic", "volume",
                                         "standard_error.volume", "airlight"};
    for (size_t i = 0; i < sizeof layers / sizeof *layers; i++) {
        int channels[3];
        assert_true(image_find_layer(&image, layers[i], channels));
        assert_true(image_mean(&image, channels) > 0);
    }
}

/* Scene file to picture file: 0.5 direct, 0.25 bounced radiance in every pixel. */
TEST(sphere_file) {
    OWNED(image) image;
    expect(0, "% reference scenes/sphere.glb -o @/sphere.exr --size 16x12 --noise 1% -q");
    assert_string_equal(output, "");
    check_ok("read", image_read(&image, scratch("sphere.exr")));
    assert_true(image.width == 16 && image.height == 12);
    static const struct {
        const char *channel;
        double value, tolerance;
    } cases[] = {
        /* Half floats are good to 0.05 %, noise is below 1 %. */
        {"R", 0.75, 0.01},       {"direct.G", 1, 2e-3}, {"indirect.B", 0.5, 0.01},
        {"albedo.R", 0.5, 5e-4}, {"A", 1, 0},           {"standard_error.G", 0, 0.02},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        int channel = image_find_channel(&image, cases[i].channel);
        assert_true(channel >= 0);
        check_near(cases[i].channel, image_at(&image, 5, 7)[channel], cases[i].value,
                   cases[i].tolerance);
    }
    assert_true(image_find_channel(&image, "Z") >= 0);
    assert_true(image_find_channel(&image, "normal.X") >= 0);
}

/* The sphere's diameter is 2 m: nothing is open from 2 m on, and all but (D / 2)^2 within D. */
TEST(ao_file) {
    static const struct {
        const char *distance;
        double open;
    } cases[] = {{"2.1", 0}, {"1m", .75}, {"auto", 1 - .2711864 * .2711864}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        OWNED(image) image;
        int channels[3];
        expect_command(
            0, "reference scenes/sphere.glb -o @/ao.exr --size 16x12 --spp 64 --bounces 0 -q --ao",
            cases[i].distance);
        check_ok("read",
                 image_read(&image, scratch("ao.exr")) && image_find_layer(&image, "ao", channels));
        check_near("open", image_mean(&image, channels), cases[i].open, .003);
        assert_true(image_find_channel(&image, "standard_error.ao.Y") >= 0);
    }
}

/* A block of pixels as one: layer x albedo, which a box filter keeps, unlike the layer alone. */
static double block_mean(const struct image *image, int block, int x, int y, int layer,
                         int albedo) {
    double sum = 0;
    for (int j = 0; j < block; j++)
        for (int i = 0; i < block; i++) {
            const float *pixel = image_at(image, x * block + i, y * block + j);
            sum += (double)pixel[layer] * (albedo < 0 ? 1 : pixel[albedo]);
        }
    return sum / block / block;
}

struct difference {
    double mean, relative_bias, relative_rmse;
};

/* Of the radiance that a layer stands for. */
static struct difference compare_layer(const struct image *test, const struct image *given,
                                       const char *layer) {
    int a[3], b[3], test_albedo[3], given_albedo[3];
    bool is_light = strcmp(layer, "direct") == 0 || strcmp(layer, "indirect") == 0;
    int block = given->width / test->width;
    check_ok("layer", image_find_layer(test, layer, a) && image_find_layer(given, layer, b));
    check_ok("albedo", image_find_layer(test, "albedo", test_albedo) &&
                           image_find_layer(given, "albedo", given_albedo));
    double sum = 0, bias = 0, squares = 0, values = 3.0 * test->width * test->height;
    for (int y = 0; y < test->height; y++)
        for (int x = 0; x < test->width; x++)
            for (int c = 0; c < 3; c++) {
                double v = block_mean(test, 1, x, y, a[c], is_light ? test_albedo[c] : -1);
                double r = block_mean(given, block, x, y, b[c], is_light ? given_albedo[c] : -1);
                sum += r / values;
                bias += (v - r) / values;
                squares += (v - r) * (v - r) / values;
            }
    return (struct difference){sum, bias / sum, sqrt(squares) / sum};
}

/* The given pictures are 800 x 800 with a noise of 1.1 and 0.9 %, here averaged over 10 x 10
 * pixels: what differs is our noise, which the indirect layer knows, and the sampling of shadow
 * edges. */
static void compare_with_given(const char *name) {
    OWNED(image) test, given;
    if (!shared_path())
        skip();
    expect_command(0, "reference -o @/given.exr --spp 32",
                   form("%s/scenes/%s.glb --size %dx%d", shared_path(), name, SIZE, SIZE));
    const char *given_path = form("%s/reference/%s.exr", shared_path(), name);
    check_ok("read", image_read(&test, scratch("given.exr")));
    check_ok("read", image_read(&given, given_path));
    static const struct {
        const char *layer;
        double rmse;
    } cases[] = {{"albedo", 0.015}, {"direct", 0.08}, {"indirect", 0.06}, {"", 0.06}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct difference difference = compare_layer(&test, &given, cases[i].layer);
        printf("    %s %s, mean %g\n", name, cases[i].layer, difference.mean);
        check_near("relative bias", difference.relative_bias, 0, 1e-3);
        check_at_most("relative RMSE", difference.relative_rmse, cases[i].rmse);
    }
}

TEST(given_box) {
    compare_with_given("cornell-box");
}

TEST(given_horse) {
    compare_with_given("cornell-horse");
}

RUN_TESTS(NULL, NULL)
