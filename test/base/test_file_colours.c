/* What picture files say of their numbers: exposures, formats and old run lengths of Radiance;
 * primaries and units of EXR. And what own .hdr files lose. */
#include "support.h"

#include "base/file/image_plugin.h"
#include "base/primaries.h"

enum { WIDTH = 16, HEIGHT = 8 };

/* --- Radiance --------------------------------------------------------------------------------- */

#define ONE "\x80\x80\x80\x81"
#define WHITE "\x79\x80\x8b\x81" /* XYZ of D65 */

/* A picture of one colour in those pixels, which fill the first rows; the others are WHITE
 * or ONE. */
static const struct radiance {
    const char *name, *lines, *pixel;
    double rgb[3];
} radiances[] = {
    {"plain", "FORMAT=32-bit_rle_rgbe\n", ONE, {1, 1, 1}},
    {"exposure", "FORMAT=32-bit_rle_rgbe\nEXPOSURE=2\n", ONE, {.5, .5, .5}},
    {"exposures", "EXPOSURE= 2.0\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=.25\n", ONE, {2, 2, 2}},
    {"FreeImage's", "FORMAT=32-bit_rle_rgbe\nGAMMA=1\nEXPOSURE=0\n", ONE, {1, 1, 1}},
    {"nonsense", "EXPOSURE=nan\nEXPOSURE=-1\nEXPOSURE=x\n", ONE, {1, 1, 1}},
    {"colours", "COLORCORR=2 1 .5\nEXPOSURE=.5\n", ONE, {1, 2, 4}},
    {"no format", "SOFTWARE=x\n", ONE, {1, 1, 1}},
    {"XYZ", "FORMAT=32-bit_rle_xyze\nEXPOSURE=4\n", WHITE, {.25, .25, .25}},
    {"primaries", "PRIMARIES=.713 .293 .165 .83 .128 .044 .32168 .33767\n", ONE, {1, 1, 1}},
};

static void write_radiance(const char *path, const struct radiance *row) {
    FILE *file = fopen(path, "wb");
    fprintf(file, "#?RADIANCE\n%s\n-Y %d +X %d\n", row->lines, HEIGHT, WIDTH);
    for (int y = 0; y < HEIGHT; y++) {
        if (y % 2) { /* old run lengths: a pixel, and fifteen more like it */
            fwrite(row->pixel, 1, 4, file);
            fwrite("\x01\x01\x01\x0f", 1, 4, file);
        }
        for (int x = 0; x < WIDTH && y % 2 == 0; x++)
            fwrite(row->pixel, 1, 4, file);
    }
    fclose(file);
}

static void check_even(const struct image *image, const double rgb[3], double tolerance) {
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++)
            for (int c = 0; c < 3; c++)
                if (!(fabs((double)image_at(image, x, y)[c] - rgb[c]) <= tolerance))
                    check_near("a pixel", (double)image_at(image, x, y)[c], rgb[c], tolerance);
}

TEST(radiance) {
    for (size_t i = 0; i < sizeof radiances / sizeof *radiances; i++) {
        const char *path = scratch("radiance.hdr");
        OWNED(image) image;
        int size[2];
        write_radiance(path, &radiances[i]);
        check_ok(radiances[i].name, image_read(&image, path) && image_size(path, size));
        assert_int_equal(size[0], WIDTH);
        /* 1/64 in XYZ, whose mantissas are seven bits here, is up to 3 % of red */
        check_even(&image, radiances[i].rgb,
                   radiances[i].pixel == (const char *)WHITE ? .01 : 1e-6);
    }
}

TEST(radiance_refusals) {
    static const struct radiance bad = {"", "FORMAT=16-bit\n", ONE, {0}};
    struct image image = {0};
    write_radiance(scratch("bad.hdr"), &bad);
    check_refused(image_read(&image, scratch("bad.hdr")), "'16-bit', neither RGBE nor XYZE");
    check_refused(image_is_whole(scratch("bad.hdr")), "bad.hdr: ");
}

/* Mantissas are rounded: no error beyond half of their last bit, and none on average. The largest
 * floats stay large. */
TEST(rounding) {
    OWNED(image) image, read;
    double most = 0, sum = 0;
    image_init(&image, 64, 64, "R G B");
    for (int i = 0; i < 64 * 64 * 3; i++)
        image.pixels[i] = ldexpf(1 + ((float)(i * 7919 % 4093) + .5f) / 4096, i / 3 % 13 - 6);
    image.pixels[0] = image.pixels[1] = image.pixels[2] = 255.9f;
    image.pixels[3] = image.pixels[4] = image.pixels[5] = 3.4e38f;
    check_ok("write", image_write(&image, scratch("rounded.hdr")));
    check_ok("read", image_read(&read, scratch("rounded.hdr")));
    check_near("a mantissa beyond 255", (double)read.pixels[0], 256, 0);
    check_at_most("of the largest float", 1.6e38, (double)read.pixels[3]);
    for (int i = 6; i < 64 * 64 * 3; i++) {
        const float *rgb = image.pixels + i - i % 3;
        double step = ldexp(1, ilogbf(fmaxf(rgb[0], fmaxf(rgb[1], rgb[2]))) - 7);
        double error = (double)(read.pixels[i] - image.pixels[i]) / step;
        most = fmax(most, fabs(error));
        sum += error;
    }
    check_at_most("largest error, steps", most, 1); /* half, and whole where 255.5 becomes 256 */
    check_near("mean error, steps", sum / (64 * 64 * 3 - 6), 0, .01);
}

/* --- EXR -------------------------------------------------------------------------------------- */

static const float ap1[] = {.713f, .293f, .165f, .83f, .128f, .044f, .32168f, .33767f};
/* AP1 of BT.709 by Bradford, to four digits. */
static const float ap1_of_bt709[3][3] = {
    {.6131f, .3395f, .0474f}, {.0702f, .9164f, .0135f}, {.0206f, .1096f, .8698f}};

/* Colours and normals of (1, .2, .05) in AP1, and in a unit. */
static void write_exr(const char *path, const float *primaries, float unit) {
    OWNED(image) image;
    image_init(&image, WIDTH, HEIGHT, "R G B normal.R normal.G normal.B x.R x.G x.B");
    for (int i = 0; i < WIDTH * HEIGHT * 9; i++) {
        const float *row = ap1_of_bt709[i % 3];
        image.pixels[i] = row[0] + .2f * row[1] + .05f * row[2];
    }
    if (primaries)
        image_add_numbers(&image, "chromaticities", IMAGE_CHROMATICITIES, primaries);
    if (unit > 0)
        image_add_numbers(&image, "whiteLuminance", IMAGE_NUMBER, &unit);
    check_ok(path, image_write(&image, path));
}

static void check_exr(const char *note, const float *primaries, float unit, const double rgb[3]) {
    const char *path = scratch("colours.exr");
    const double as_stored[] = {.6834, .2542, .086};
    struct image image;
    int channels[3];
    write_exr(path, primaries, unit);
    hear_notes();
    check_ok("all", image_read(&image, path));
    end_notes();
    assert_true(*note ? strstr(notes, note) != NULL : !*notes);
    check_even(&image, rgb, 1e-3 * rgb[0]); /* halves, four digits */
    for (int c = 0; c < 3; c++)
        check_near("normals stay", (double)image.pixels[3 + c], as_stored[c], 1e-3);
    check_near("other colours do not", (double)image.pixels[6], rgb[0], 1e-3 * rgb[0]);
    image_free(&image);
    check_ok("layer", image_read_layer(&image, path, "x", channels));
    check_near("of a layer", (double)image.pixels[channels[1]], rgb[1], 1e-3 * rgb[0]);
    image_free(&image);
    if (!image_plugin_is_there())
        return;
    check_ok("other bridge", image_plugin_get()->read(&image, path, NULL, NULL));
    check_near("unit", (double)image.unit, (double)unit, 1e-6);
    assert_memory_equal(image.primaries, primaries ? primaries : (float[8]){0},
                        sizeof image.primaries);
    image_free(&image);
}

TEST(exr) {
    static const float none[8] = {.3f, .3f, .3f, .3f, .3f, .3f, .3f, .3f};
    const double stored[] = {.6834, .2542, .086}, scaled[] = {100 * .6834, 25.42, 8.6},
                 right[] = {1, .2, .05}, both[] = {2, .4, .1};
    check_exr("", NULL, 0, stored);
    check_exr("", primaries_bt709, 1, stored);
    check_exr("its colours are converted", ap1, 0, right);
    check_exr("multiplied by its whiteLuminance, 100", NULL, 100, scaled);
    check_exr("its whiteLuminance, 2", ap1, 2, both);
    check_exr("span no colours", none, 0, stored);
}

RUN_TESTS(NULL, NULL)
