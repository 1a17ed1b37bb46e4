/* The metrics floor: errors by hand, FLIP against known values and against its definition. */
#include "support.h"

#include "base/image.h"
#include "flip_direct.h"
#include "metrics/colour.h"
#include "metrics/flip/flip.h"
#include "metrics/flip/hdr_flip.h"
#include "metrics/layer.h"
#include "metrics/metric.h"
#include "metrics/quantile.h"
#include "metrics/summary.h"

static double measure(const char *name, const struct image *test, const struct image *reference) {
    struct comparison comparison = {
        .test = test, .reference = reference, .pixels_per_degree = DEFAULT_PIXELS_PER_DEGREE};
    return metric_measure(metric_find(name), &comparison, NULL);
}

/* Repeatable noise over [0, 1). */
static float random_unit(uint32_t *state) {
    *state = *state * 1664525u + 1013904223u;
    return (float)(*state >> 8) / 16777216.0f;
}

static void fill_random(struct image *image, int width, int height, uint32_t seed) {
    image_init(image, width, height, "R G B");
    for (int i = 0; i < width * height * 3; i++)
        image->pixels[i] = random_unit(&seed);
}

TEST(errors_by_hand) {
    OWNED(image) test, reference;
    image_init(&test, 2, 1, "R G B");
    image_init(&reference, 2, 1, "R G B");
    memcpy(reference.pixels, (const float[]){1, 1, 1, 2, 2, 2}, 6 * sizeof(float));
    memcpy(test.pixels, (const float[]){1.5, 1, 1, 2, 1, 2}, 6 * sizeof(float));
    const double rmse = sqrt((.25 + 1) / 6);
    check_near("rmse", measure("rmse", &test, &reference), rmse, 1e-6);
    check_near("relative-rmse", measure("relative-rmse", &test, &reference), rmse / 1.5, 1e-6);
    check_near("mrse", measure("mrse", &test, &reference),
               (.25 / (1.01 * 1.01) + 1 / (2.01 * 2.01)) / 6, 1e-6);
    check_near("mae", measure("mae", &test, &reference), 1.5 / 6, 1e-6);
    check_near("relative-mae", measure("relative-mae", &test, &reference), 1.5 / 6 / 1.5, 1e-6);
    check_near("smape", measure("smape", &test, &reference), (.5 / 2.51 + 1 / 3.01) / 6, 1e-6);
    check_near("bias", measure("bias", &test, &reference), -.5 / 6, 1e-6);
    check_near("bias, swapped", measure("bias", &reference, &test), .5 / 6, 1e-6);
    check_near("relative-bias", measure("relative-bias", &test, &reference), -.5 / 6 / 1.5, 1e-6);
}

static void fill(struct image *image, int width, int height, float value) {
    image_init(image, width, height, "R G B");
    for (int i = 0; i < width * height * 3; i++)
        image->pixels[i] = value;
}

TEST(gradient_by_hand) {
    OWNED(image) test, reference;
    fill(&reference, 3, 3, .5f);
    fill(&test, 3, 3, 2);
    check_near("gradient of an offset", measure("gradient", &test, &reference), 0, 0);
    /* A spike of 3 makes four steps of 3, two in its own pixel and one in two neighbours. */
    image_free(&test);
    fill(&test, 3, 3, .5f);
    for (int c = 0; c < 3; c++)
        image_at(&test, 1, 1)[c] += 3;
    check_near("gradient of a spike", measure("gradient", &test, &reference), sqrt(4 * 9 / 9.) / .5,
               1e-6);
}

/* Of 200 pixels two are the worst 1 %. */
TEST(worst_share_by_hand) {
    OWNED(image) test, reference;
    float map[200];
    fill(&reference, 20, 10, 1);
    fill(&test, 20, 10, 1.5f);
    struct comparison comparison = {.test = &test, .reference = &reference};
    check_near("all alike", measure("worst-share", &test, &reference), .01, 1e-6);
    for (int c = 0; c < 3; c++) {
        image_at(&test, 3, 2)[c] = 1 + 4;
        image_at(&test, 9, 8)[c] = 1 - 3;
    }
    check_near("two spikes", metric_measure(metric_find("worst-share"), &comparison, map),
               25 / (25 + 198 * .25), 1e-6);
    check_near("a spike's share, times the pixels", (double)map[2 * 20 + 3],
               16 / (25 + 198 * .25) * 200, 1e-4);
    check_near("others", (double)map[0], 0, 0);
    /* One spike: the other place is shared by the 199 that are alike. */
    for (int c = 0; c < 3; c++)
        image_at(&test, 9, 8)[c] = 1.5f;
    check_near("one spike", measure("worst-share", &test, &reference), 16.25 / (16 + 199 * .25),
               1e-6);
}

TEST(box_errors_by_hand) {
    OWNED(image) test, reference;
    fill(&reference, 32, 32, 2);
    fill(&test, 32, 32, 2);
    /* Noise of one sign here and the other there is gone, and so it is in any box of even size. */
    for (int y = 0; y < 32; y++)
        for (int x = 0; x < 32; x++)
            for (int c = 0; c < 3; c++)
                image_at(&test, x, y)[c] += (x + y) % 2 ? 1 : -1;
    check_near("checkers", measure("relative-rmse", &test, &reference), .5, 1e-6);
    check_near("checkers in 4 x 4", measure("box4-rmse", &test, &reference), 0, 1e-6);
    /* A pixel that is off by 8 leaves 8/16 in one of 64 boxes, 8/256 in one of 4. */
    image_free(&test);
    fill(&test, 32, 32, 2);
    for (int c = 0; c < 3; c++)
        image_at(&test, 17, 5)[c] += 8;
    check_near("spike in 4 x 4", measure("box4-rmse", &test, &reference), .5 / 8 / 2, 1e-6);
    check_near("spike in 16 x 16", measure("box16-rmse", &test, &reference), 8. / 256 / 2 / 2,
               1e-6);
    images_free(&test, &reference);
    /* Cut boxes: of 5 x 5 pixels the last makes one of its own, and counts as one pixel. */
    fill(&reference, 5, 5, 1);
    fill(&test, 5, 5, 1);
    for (int c = 0; c < 3; c++)
        image_at(&test, 4, 4)[c] += 3;
    check_near("corner", measure("box4-rmse", &test, &reference), 3. / 5, 1e-6);
    check_near("one box for all", measure("box16-rmse", &test, &reference), 3. / 25, 1e-6);
}

TEST(psnr_by_hand) {
    OWNED(image) test, reference;
    fill(&reference, 2, 2, 0);
    fill(&test, 2, 2, srgb_decode(.5f));
    check_near("psnr", measure("psnr", &test, &reference), -10 * log10(.25), 1e-5);
    assert_true(isinf(measure("psnr", &reference, &reference)));
    /* A screen shows no more than 1. */
    image_free(&reference);
    fill(&reference, 2, 2, 1);
    image_free(&test);
    fill(&test, 2, 2, 7);
    assert_true(isinf(measure("psnr", &test, &reference)));
}

TEST(equal_and_black_pictures) {
    OWNED(image) random, black;
    fill_random(&random, 33, 21, 1);
    fill(&black, 33, 21, 0);
    for (int i = 0; i < METRIC_COUNT; i++) {
        if (metrics[i].higher_is_better)
            continue;
        check_near(metrics[i].name, measure(metrics[i].name, &random, &random), 0, 0);
        check_near(metrics[i].name, measure(metrics[i].name, &black, &black), 0, 0);
    }
    assert_true(isinf(measure("relative-rmse", &random, &black)));
}

TEST(symmetry_and_growth) {
    OWNED(image) reference, noisy;
    fill_random(&reference, 48, 32, 2);
    fill_random(&noisy, 48, 32, 3);
    static const char *const symmetric[] = {"rmse", "mae", "smape", "psnr", "ldr-flip"};
    for (int i = 0; i < 5; i++)
        check_near(symmetric[i], measure(symmetric[i], &noisy, &reference),
                   measure(symmetric[i], &reference, &noisy), 1e-7);
    double last[METRIC_COUNT] = {0};
    for (float amount = .02f; amount < .3f; amount *= 2) {
        uint32_t seed = 4;
        for (int i = 0; i < 48 * 32 * 3; i++)
            noisy.pixels[i] = reference.pixels[i] + amount * random_unit(&seed);
        for (int i = 0; i < METRIC_COUNT; i++) {
            double value = measure(metrics[i].name, &noisy, &reference);
            double worse = metrics[i].higher_is_better ? 1 / value : value;
            /* Which pixels have the error does not depend on how much there is. */
            if (strcmp(metrics[i].name, "worst-share") == 0)
                check_near("worst-share", value, last[i] > 0 ? last[i] : value, 1e-4);
            else
                check_at_most(metrics[i].name, last[i] * 1.01, worse);
            last[i] = worse;
        }
    }
}

TEST(threads_agree) {
    enum { WIDTH = 57, HEIGHT = 101 };
    OWNED(image) test, reference;
    static float alone[WIDTH * HEIGHT], together[WIDTH * HEIGHT];
    fill_random(&test, WIDTH, HEIGHT, 5);
    fill_random(&reference, WIDTH, HEIGHT, 6);
    struct comparison comparison = {
        .test = &test, .reference = &reference, .pixels_per_degree = 30};
    for (int i = 0; i < METRIC_COUNT; i++) {
        comparison.threads = 1;
        double value = metric_measure(&metrics[i], &comparison, alone);
        for (comparison.threads = 0; comparison.threads < 8; comparison.threads += 3) {
            check_near(metrics[i].name, metric_measure(&metrics[i], &comparison, together), value,
                       0);
            assert_memory_equal(alone, together, sizeof alone);
        }
    }
}

TEST(colour_spaces) {
    check_near("sRGB 188/255", (double)srgb_decode(188 / 255.f), 0.502886, 1e-5);
    check_near("sRGB of 0.18", (double)srgb_encode(.18f), 0.461356, 1e-5);
    check_near("sRGB of 0.002, below the curve", (double)srgb_encode(.002f), .02584, 1e-6);
    const float rgb[] = {.8f, .1f, .35f};
    float there[3], back[3];
    rgb_to_ycxcz(rgb, there);
    ycxcz_to_rgb(there, back);
    for (int c = 0; c < 3; c++)
        check_near("YCxCz and back", (double)back[c], (double)rgb[c], 1e-6);
    rgb_to_lab(rgb, there);
    lab_to_rgb(there, back);
    for (int c = 0; c < 3; c++)
        check_near("CIELAB and back", (double)back[c], (double)rgb[c], 1e-6);
    /* The red primary in CIELAB under D65. */
    rgb_to_lab((const float[]){1, 0, 0}, there);
    const double red[] = {53.24, 80.09, 67.20};
    for (int c = 0; c < 3; c++)
        check_near("red in CIELAB", (double)there[c], red[c], .02);
}

TEST(flip_against_definition) {
    OWNED(image) test, reference;
    fill_random(&test, 23, 37, 7);
    fill_random(&reference, 23, 37, 8);
    for (int i = 0; i < 23 * 20 * 3; i++)
        test.pixels[i] = reference.pixels[i] * .7f + .1f;
    static const float resolutions[] = {4, 25, DEFAULT_PIXELS_PER_DEGREE};
    static float map[23 * 37];
    for (int i = 0; i < 3; i++) {
        struct comparison comparison = {
            .test = &test, .reference = &reference, .pixels_per_degree = resolutions[i]};
        flip_ldr(&comparison, map);
        double largest = 0;
        for (int y = 0; y < 37; y += 2)
            for (int x = 0; x < 23; x += 2)
                largest = fmax(largest,
                               fabs((double)map[y * 23 + x] -
                                    flip_direct(&test, &reference, (double)resolutions[i], x, y)));
        check_at_most("LDR-FLIP against its definition", largest, 2e-5);
    }
}

/* Pictures of 64 by 48 whose FLIP is known from other implementations. */
typedef void pattern(int x, int y, float test[3], float reference[3]);

static void set(float rgb[3], double r, double g, double b) {
    rgb[0] = (float)r;
    rgb[1] = (float)g;
    rgb[2] = (float)b;
}
static void set_grey(float rgb[3], double value) {
    set(rgb, value, value, value);
}
static void black_white(int x, int y, float test[3], float reference[3]) {
    (void)x, (void)y;
    set_grey(test, 1);
    set_grey(reference, 0);
}
static void green_blue(int x, int y, float test[3], float reference[3]) {
    (void)x, (void)y;
    set(test, 0, 0, 1);
    set(reference, 0, 1, 0);
}
static void grey_reddish(int x, int y, float test[3], float reference[3]) {
    (void)x, (void)y;
    set(test, .6, .5, .5);
    set_grey(reference, .5);
}
static void near_greys(int x, int y, float test[3], float reference[3]) {
    (void)x, (void)y;
    set_grey(test, .51);
    set_grey(reference, .5);
}
static void ramps(int x, int y, float test[3], float reference[3]) {
    (void)y;
    set_grey(test, fmin(1, x / 63. + .05));
    set_grey(reference, x / 63.);
}
static void checkers(int x, int y, float test[3], float reference[3]) {
    bool bright = (x / 8 + y / 8) & 1;
    set_grey(test, bright ? .2 : .8);
    set_grey(reference, bright ? .8 : .2);
}
static void bright_ramps(int x, int y, float test[3], float reference[3]) {
    (void)y;
    set_grey(reference, .01 * exp2(10 * x / 63.));
    set_grey(test, .01 * exp2(10 * x / 63.) * 1.1);
}

static void draw(pattern *pattern, struct image *test, struct image *reference) {
    image_init(test, 64, 48, "R G B");
    image_init(reference, 64, 48, "R G B");
    for (int y = 0; y < 48; y++)
        for (int x = 0; x < 64; x++)
            pattern(x, y, image_at(test, x, y), image_at(reference, x, y));
}

TEST(flip_vectors) {
    static const struct {
        const char *name, *metric;
        pattern *pattern;
        double mean;
    } vectors[] = {
        {"black and white", "ldr-flip", black_white, .967388},
        {"green and blue", "ldr-flip", green_blue, 1},
        {"grey and reddish", "ldr-flip", grey_reddish, .199509},
        {"near greys", "ldr-flip", near_greys, .040722},
        {"ramps", "ldr-flip", ramps, .155187},
        {"checkers", "ldr-flip", checkers, .570019},
        {"ramps of ten stops", "hdr-flip", bright_ramps, .124895},
    };
    for (size_t i = 0; i < sizeof vectors / sizeof *vectors; i++) {
        OWNED(image) test, reference;
        draw(vectors[i].pattern, &test, &reference);
        check_near(vectors[i].name, measure(vectors[i].metric, &test, &reference), vectors[i].mean,
                   1e-4);
    }
}

static double aces(double x) {
    x *= .6;
    return x * (2.51 * x + .03) / (x * (2.43 * x + .59) + .14);
}

TEST(hdr_flip_exposures) {
    OWNED(image) test, reference;
    draw(bright_ramps, &test, &reference);
    struct exposure_range range = hdr_flip_exposures(&reference);
    const double median = .01 * exp2(10 * 32 / 63.);
    assert_int_equal(range.count, 5);
    check_near("brightest at first", aces(10.24 * exp2((double)range.first)), .85, 1e-4);
    check_near("median at last", aces(median * exp2((double)range.last)), .85, 1e-4);
    /* More than half black: the smallest positive luminance stands for the median. */
    for (int i = 0; i < 64 * 48 * 3 * 3 / 4; i++)
        reference.pixels[i] = 0;
    range = hdr_flip_exposures(&reference);
    assert_int_equal(range.count, 10);
    check_near("smallest at last", aces(.01 * exp2((double)range.last)), .85, 1e-4);
    check_at_most("and the error is found", .01, measure("hdr-flip", &test, &reference));
    /* White is white, and the square of a huge value spoils nothing. */
    test.pixels[0] = 1e6f;
    double bright = measure("hdr-flip", &test, &reference);
    test.pixels[0] = 1e30f;
    check_near("with a huge value", measure("hdr-flip", &test, &reference), bright, 1e-7);
    memset(reference.pixels, 0, 64 * 48 * 3 * sizeof(float));
    assert_int_equal(hdr_flip_exposures(&reference).count, 2);
    check_at_most("light where all is black", .5, measure("hdr-flip", &test, &reference));
}

/* One exposure is LDR-FLIP of the curve's pictures; of several each pixel has the most. */
TEST(given_exposures) {
    enum { PIXELS = 64 * 48 };
    OWNED(image) test, reference;
    float maps[3][PIXELS], curve[PIXELS];
    struct comparison comparison = {&test, &reference, DEFAULT_PIXELS_PER_DEGREE, {-1, -1, 1}, 0};
    draw(bright_ramps, &test, &reference);
    flip_hdr(&comparison, maps[0]);
    comparison.exposures = (struct exposure_range){3, 3, 1};
    flip_hdr(&comparison, maps[1]);
    comparison.exposures = (struct exposure_range){-1, 3, 2};
    flip_hdr(&comparison, maps[2]);
    for (int i = 0; i < PIXELS * 3; i++) {
        test.pixels[i] = (float)fmin(1, aces(ldexp((double)test.pixels[i], 3)));
        reference.pixels[i] = (float)fmin(1, aces(ldexp((double)reference.pixels[i], 3)));
    }
    flip_ldr(&comparison, curve);
    double off = 0, differ = 0;
    for (int p = 0; p < PIXELS; p++) {
        off = fmax(off, fabs((double)(curve[p] - maps[1][p])));
        differ = fmax(differ, fabs((double)(maps[0][p] - maps[1][p])));
        assert_true(maps[2][p] == fmaxf(maps[0][p], maps[1][p]));
    }
    check_at_most("of the curve's pictures", off, 1e-4);
    check_at_most("exposures differ", .05, differ);
}

TEST(quantile) {
    float values[] = {5, 1, 4, 2, 3, 6};
    check_near("median of six", (double)quantile(values, 6, .5), 4, 0);
    check_near("least", (double)quantile(values, 6, 0), 1, 0);
    check_near("most", (double)quantile(values, 6, 1), 6, 0);
}

static void refuse_layer(const struct image *picture, const char *layer, const char *message) {
    OWNED(image) refused;
    assert_false(layer_extract(&refused, picture, layer));
    assert_string_equal(error_get(), message);
}

TEST(layer_refusals) {
    struct image picture, layer;
    image_init(&picture, 4, 3, "R G B indirect.R indirect.G indirect.B");
    image_at(&picture, 2, 1)[4] = NAN;
    check_ok("beauty is well", layer_extract(&layer, &picture, "beauty"));
    image_free(&layer);
    refuse_layer(&picture, "indirect", "indirect.G is nan at pixel 2,1");
    image_at(&picture, 3, 0)[3] = -INFINITY;
    refuse_layer(&picture, "indirect", "indirect.R is -inf at pixel 3,0");
    refuse_layer(&picture, "albedo", "no layer 'albedo' (there is: beauty, indirect)");
    image_free(&picture);
}

TEST(encoded_layer) {
    unsigned char pixels[] = {188, 0, 255, 255};
    struct bitmap bitmap = {.width = 1, .height = 1, .rgba = pixels};
    const char *path = scratch("encoded.png");
    check_ok("write", bitmap_write(&bitmap, path));
    OWNED(image) layer;
    bool encoded;
    check_ok("read", layer_read(&layer, path, "beauty", &encoded));
    assert_true(encoded);
    check_near("188 of 255, decoded", (double)layer.pixels[0], 0.502886, 1e-5);
    check_near("255 of 255, decoded", (double)layer.pixels[2], 1, 1e-6);
    path = scratch("linear.exr");
    check_ok("write", image_write(&layer, path));
    image_free(&layer);
    check_ok("read", layer_read(&layer, path, "", &encoded));
    assert_false(encoded);
    check_near("as it was", (double)layer.pixels[0], 0.502886, 1e-3);
}

/* Where a falling curve comes to a height. */
TEST(summary) {
    static const double x[] = {1, 2, 4}, y[] = {9, 3, 1};
    check_near("at its beginning", log_interpolate(x, y, 3, 9), 1, 0);
    check_near("above it", log_interpolate(x, y, 3, 10), 0, 0);
    check_near("between", log_interpolate(x, y, 3, sqrt(27)), sqrt(2), 1e-9);
    check_near("at its end", log_interpolate(x, y, 3, 1), 4, 1e-9);
    assert_true(isinf(log_interpolate(x, y, 3, .5)) && isinf(log_interpolate(x, y, 0, .5)));
}

/* A file without such a layer, and one that is not there. */
TEST(layer_files) {
    struct image picture, layer;
    bool encoded;
    image_init(&picture, 2, 2, "R G B");
    check_ok("write", image_write(&picture, scratch("layer.exr")));
    check_refused(layer_read(&layer, scratch("layer.exr"), "indirect", &encoded),
                  "layer.exr: no layer 'indirect'");
    assert_false(layer_read(&layer, scratch("no-such.exr"), "", &encoded));
    assert_null(layer.pixels);
    image_free(&picture);
}

RUN_TESTS(NULL, NULL)
