/* manylight reference: the command, and its pictures against those of an independent path tracer */
#include "support.h"

#include "base/image.h"

#include <unistd.h>

enum { SIZE = 80 };

static int reference(const char *arguments, char *output, size_t output_size) {
    const char *command = form("%s reference %s", binary_path(), arguments);
    int status = run_command(command, output, output_size);
    printf("    %s -> %d: %.160s\n", arguments, status, output);
    return status;
}

TEST(usage) {
    static const struct {
        const char *arguments, *says;
        int status;
    } cases[] = {
        {"--help", "standard_error", 0},
        {"", "arguments are missing", 2},
        {"scenes/sphere.glb", "-o FILE.exr is missing", 2},
        {"scenes/sphere.glb -o x.png", "x.png: only EXR", 2},
        {"scenes/sphere.glb -o x.exr --noise -1%", "'-1%' is not a number from 0 to 1", 2},
        {"scenes/sphere.glb -o x.exr --noise 1% --spp 4", "exclude each other", 2},
        {"scenes/sphere.glb -o x.exr --technique vpl-raytraced --denoise", "--denoise is for", 2},
        {"scenes/sphere.glb -o x.exr --ao 0", "ao: '0' is not a number from 1e-06 to", 2},
        {"scenes/sphere.glb -o x.exr --ao -1m", "ao: '-1m' is not a number", 2},
        {"scenes/sphere.glb -o x.exr --ao nan", "ao: 'nan' is not a number", 2},
        {"scenes/sphere.glb -o x.exr --ao near", "ao: 'near' is not a number", 2},
        {"scenes/sphere.glb -o x.exr --ao 1 --technique vpl-raytraced",
         "--ao is for --technique path", 2},
        {"scenes/sphere.glb -o x.exr --light-paths 0", "'0' is not a whole number from 1 to", 2},
        {"scenes/sphere.glb -o x.exr --light-paths -5", "'-5' is not a whole number from 1", 2},
        {"scenes/sphere.glb -o x.exr --light-paths 9 --technique vpl-raytraced",
         "--light-paths is for --technique path", 2},
        {"scenes/sphere.glb -o x.exr --smooth --materials diffuse",
         "--smooth is for --materials full", 2},
        {"scenes/sphere.glb -o x.exr --set vpls=64", "--technique vpl-raytraced", 2},
        {"scenes/sphere.glb -o x.exr --technique vpl-raytraced --set medium.scatter=1",
         "sums of VPLs ignore a medium", 2},
        {"no-such.glb -o x.exr", "no-such.glb", 1},
        {"scenes/sphere.glb -o x.exr --light sun", "no light 'sun'", 1},
        {"scenes/sphere.glb -o no/such/x.exr --size 8x8 --spp 4", "no/such/x.exr", 1},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char output[8192];
        assert_int_equal(reference(cases[i].arguments, output, sizeof output), cases[i].status);
        assert_non_null(strstr(output, cases[i].says));
        assert_int_equal(access("x.exr", F_OK), -1);
    }
}

/* A scene without glass says so; one with glass in a medium has all layers. */
TEST(light_paths) {
    char arguments[700], output[4096];
    const char *path = scratch("light-paths.exr");
    snprintf(arguments, sizeof arguments,
             "scenes/sphere.glb -o %s --size 4x4 --spp 1 --light-paths 9", path);
    assert_int_equal(reference(arguments, output, sizeof output), 0);
    assert_non_null(strstr(output, "no glass"));
    snprintf(arguments, sizeof arguments,
             "scenes/gem.glb -o %s --size 16x12 --spp 4 --light-paths 20000", path);
    assert_int_equal(reference(arguments, output, sizeof output), 0);
    assert_non_null(strstr(output, "20000 light paths"));
    OWNED(image) image;
    check_ok("read", image_read(&image, path));
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
    char output[4096];
    const char *path = scratch("reference-sphere.exr");
    const char *arguments = form("scenes/sphere.glb -o %s --size 16x12 --noise 1%% -q", path);
    assert_int_equal(reference(arguments, output, sizeof output), 0);
    assert_string_equal(output, "");
    OWNED(image) image;
    check_ok("read", image_read(&image, path));
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
    const char *path = scratch("reference-ao.exr");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char output[4096];
        OWNED(image) image;
        int channels[3];
        const char *arguments =
            form("scenes/sphere.glb -o %s --size 16x12 --spp 64 --bounces 0 -q --ao %s", path,
                 cases[i].distance);
        assert_int_equal(reference(arguments, output, sizeof output), 0);
        check_ok("read", image_read(&image, path) && image_find_layer(&image, "ao", channels));
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
    char output[4096];
    if (!shared_path())
        skip();
    const char *path = scratch("reference-given.exr");
    const char *arguments =
        form("%s/scenes/%s.glb -o %s --size %dx%d --spp 32", shared_path(), name, path, SIZE, SIZE);
    assert_int_equal(reference(arguments, output, sizeof output), 0);
    const char *given_path = form("%s/reference/%s.exr", shared_path(), name);
    OWNED(image) test, given;
    check_ok("read", image_read(&test, path));
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
