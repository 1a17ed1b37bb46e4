/* manylight compare: exit statuses, messages and outputs, as a shell sees them. */
#include "command_support.h"

#include "base/image.h"

#include <unistd.h>

/* The value that the table or the JSON has after the name. */
static double value_of(const char *name) {
    const char *at = strstr(output, name);
    if (!at)
        fail_msg("no '%s' in: %s", name, output);
    at += strlen(name);
    return strtod(at + strspn(at, "\": "), NULL);
}

#define PAIR "@/compare-test.exr @/compare-reference.exr "

/* A grey reference and a test that is brighter by 1/8, with a layer that is brighter by 1/4. */
static int make_pictures(void **state) {
    (void)state;
    OWNED(image) image;
    image_init(&image, 16, 8, "R G B indirect.R indirect.G indirect.B");
    for (int brighter = 0; brighter < 2; brighter++) {
        for (int i = 0; i < 16 * 8 * 6; i++)
            image.pixels[i] = .5f + (i % 6 < 3 ? .125f : .25f) * (float)brighter;
        if (!image_write(&image, scratch(brighter ? "compare-test.exr" : "compare-reference.exr")))
            return -1;
    }
    return 0;
}

TEST(help) {
    expect_command(0, "compare", "--help");
    expect_text("usage: manylight compare TEST REFERENCE");
    expect_text("--max METRIC=VALUE");
    expect_text("hdr-flip");
    expect_command(0, "compare", "--nonsense --help");
}

TEST(usage_errors) {
    static const char *const wrong[][2] = {
        {"", "manylight compare: arguments are missing: TEST REFERENCE"},
        {"a.exr b.exr c.exr", "one argument too many: 'c.exr'"},
        {"a.exr b.exr --metric ssim", "metric: no metric is called 'ssim' (there is: rmse"},
        {"a.exr b.exr --max rmse", "max: 'rmse' is not METRIC=VALUE"},
        {"a.exr b.exr --max rmse=nan", "max: 'nan' is not a number"},
        {"a.exr b.exr --max rmse=10%%", "max: '10%%' is not a number"},
        {"a.exr b.exr --max rmse=%", "max: '%' is not a number"},
        {"a.exr b.exr --max psnr=30", "psnr has no upper bound"},
        {"a.exr b.exr -o heat", "heat: no extension"},
        {"a.exr b.exr -m psnr -o heat.png", "psnr has no picture"},
        {NULL},
    };
    expect_refusals(2, "compare", wrong);
}

TEST(table) {
    expect(0, "% compare " PAIR);
    check_near("rmse", value_of("rmse"), .125, 1e-6);
    check_near("relative-bias", value_of("relative-bias"), .25, 1e-6);
    check_near("gradient", value_of("gradient"), 0, 1e-6);
    check_at_most("some hdr-flip", .05, value_of("hdr-flip"));
    check_near("relative-mae", value_of("relative-mae"), .25, 1e-6);
    check_near("smape", value_of("smape"), .125 / 1.135, 1e-6);
    check_near("box16-rmse", value_of("box16-rmse"), .25, 1e-6);
    check_near("worst-share", value_of("worst-share"), 2. / 128, 1e-6);
    check_at_most("some psnr", value_of("psnr"), 30);
    assert_null(strstr(output, "ldr-flip"));
    expect(0, "% compare " PAIR "--layer indirect --metric bias");
    check_near("bias of a layer", value_of("bias"), .25, 1e-6);
    assert_null(strstr(output, "rmse"));
    expect(0, "% compare " PAIR "--metric all");
    expect_text("ldr-flip");
}

TEST(json) {
    expect(0, "% compare " PAIR "--json -m mae -m rmse");
    assert_int_equal(output[0], '{');
    expect_text("\"layer\": \"beauty\", \"width\": 16, \"height\": 8");
    check_near("mae", value_of("mae"), .125, 1e-6);
    expect(0, "% compare @/compare-test.exr @/compare-test.exr --json -m psnr");
    expect_text("\"psnr\": null}}\n");
}

/* The range that is found, given again, is the same; another one is not. */
TEST(exposures) {
    char found[sizeof output];
    double range[3];
    expect(0, "% compare " PAIR "--json -m hdr-flip");
    memcpy(found, output, sizeof found);
    const char *at = strstr(found, "\"exposures\": [");
    assert_true(at &&
                sscanf(at, "\"exposures\": [%lf, %lf, %lf]", &range[0], &range[1], &range[2]) == 3);
    expect(0, form("%% compare " PAIR "--json -m hdr-flip --exposures %.9g,%.9g,%g", range[0],
                   range[1], range[2]));
    assert_string_equal(output, found);
    double flip = value_of("hdr-flip");
    expect(0, "% compare " PAIR "--exposures -9,-8,2");
    check_at_most("darker", value_of("hdr-flip"), .5 * flip);
    expect(2, "% compare " PAIR "--exposures 0,1,2 -m rmse");
    expect_text("--exposures is for hdr-flip");
    static const char *const wrong[] = {"1,0,2",   "0,1",     "0,1,0", "0,1,2x",
                                        "nan,1,2", "0,121,2", "a"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        expect_command(2, "compare " PAIR "--exposures", wrong[i]);
        expect_text("is not START,STOP,N");
    }
    expect(0, "% compare " PAIR "-m rmse -o @/a.png");
    expect(1, "% compare @/a.png @/a.png --exposures 0,1,2");
    expect_text("--exposures needs hdr-flip");
}

TEST(bounds) {
    expect(0, "% compare " PAIR "-m rmse --max rmse=0.13");
    expect(1, "% compare " PAIR "-m rmse --max rmse=0.12 --max mae=1");
    expect_text("manylight compare: rmse is 0.125, above 0.12");
    assert_null(strstr(output, "mae is"));
    expect(0, "% compare " PAIR "--max rmse=13%");
    expect_text("(at most 0.13)");
    expect(1, "% compare " PAIR "--max relative-rmse=24%"); /* it is a quarter */
    expect(0, "% compare " PAIR "--max relative-rmse=25.1%");
    /* The bound of a signed metric holds on both sides. */
    expect(1, "% compare @/compare-reference.exr @/compare-test.exr -m bias --max bias=0.1");
    expect_text("bias is -0.125, above 0.1");
}

/* The same picture beside channels that other programs made. */
TEST(foreign_channels) {
    static const char *const names[] = {"R", "G", "B", "A mask", "my mask", " z"};
    struct image image;
    image_init_named(&image, 16, 8, names, 6);
    for (int i = 0; i < 16 * 8 * 6; i++)
        image.pixels[i] = i % 6 < 3 ? .5f : (float)i;
    check_ok("write", image_write(&image, scratch("compare-masked.exr")));
    image_free(&image);
    expect(0, "% compare @/compare-masked.exr @/compare-reference.exr -m mae --max mae=0 -m rmse");
    check_near("mae", value_of("mae"), 0, 0);
    check_near("rmse", value_of("rmse"), 0, 0);
}

TEST(pictures_of_the_error) {
    struct image heat;
    expect(0, "% compare " PAIR "-m rmse -o @/heat.png");
    check_ok("read", image_read(&heat, scratch("heat.png")));
    assert_int_equal(heat.width, 256);
    image_free(&heat);
    expect(0, "% compare " PAIR "-m bias -o @/heat.exr");
    check_ok("read", image_read(&heat, scratch("heat.exr")));
    assert_int_equal(heat.width, 16);
    check_near("a bare value", (double)heat.pixels[0], .125, 1e-6);
    image_free(&heat);
    expect(1, "% compare " PAIR "-m rmse -o @/compare-reference.exr");
    expect_text("it is the input");
    expect(0, "% compare " PAIR "-m rmse");
    expect(1, "% compare " PAIR "-m rmse -o no/such/folder/heat.png");
    expect_text("manylight compare: cannot write no/such/folder/heat.png: No such file");
}

TEST(encoded_files) {
    unsigned char pixels[2][16] = {{188, 188, 188, 255, 188, 188, 188, 255},
                                   {255, 255, 255, 255, 255, 255, 255, 255}};
    for (int i = 0; i < 2; i++) {
        struct bitmap bitmap = {.width = 2, .height = 1, .rgba = pixels[i]};
        check_ok("write", bitmap_write(&bitmap, scratch(i ? "white.png" : "grey.png")));
    }
    expect(0, "% compare @/grey.png @/white.png");
    check_near("rmse in linear light", value_of("rmse"), 1 - .502886, 1e-5);
    check_near("psnr as encoded", value_of("psnr"), -20 * log10((255 - 188) / 255.), 1e-3);
    expect_text("ldr-flip");
    assert_null(strstr(output, "hdr-flip"));
}

TEST(files_that_do_not_compare) {
    expect(1, "% compare " PAIR "--layer albedo");
    expect_text("compare-test.exr: no layer 'albedo' (there is: beauty, indirect)");
    expect(1, "% compare @/compare-test.exr no-such-file.exr");
    expect_text("manylight compare: cannot open no-such-file.exr: No such file or directory");
    expect(1, "% compare @/compare-test.exr /dev/zero");
    expect_text("manylight compare: cannot read /dev/zero: not a file"); /* and without an end */

#define ODD "% compare @/compare-odd.exr @/compare-reference.exr"
    OWNED(image) image;
    const char *path = scratch("compare-odd.exr");
    for (int narrow = 0; narrow < 2; narrow++) {
        image_init(&image, narrow ? 15 : 16, narrow ? 8 : 9, "R G B");
        check_ok("write", image_write(&image, path));
        expect(1, ODD);
        expect_text(narrow ? "compare-odd.exr is 15x8, but " : "compare-odd.exr is 16x9, but ");
        expect_text("compare-reference.exr is 16x8");
        image_free(&image);
    }

    image_init(&image, 16, 8, "R G B");
    image_at(&image, 5, 3)[2] = NAN;
    check_ok("write", image_write(&image, path));
    expect(1, ODD);
    expect_text("compare-odd.exr: B is nan at pixel 5,3");
}

TEST(shared_references) {
    if (!shared_path() || access("../shared/reference/cornell-box.exr", R_OK) != 0)
        skip();
#define GIVEN "../shared/reference/cornell-box.exr "
    expect(0, "% compare " GIVEN GIVEN "--ppd 10 --max hdr-flip=0 --max mae=0");
    expect(0,
           "% compare ../shared/reference/cornell-horse.exr " GIVEN "-l indirect -m rmse -m bias");
    check_at_most("the horse shows", .1, value_of("rmse"));
}

RUN_TESTS(make_pictures, NULL)
