/* manylight score: the figures of manylight compare, and each planted fault by its name. */
#include "command_support.h"

#include "base/file/image_file.h"
#include "lab/score/sha256.h"
#include "metrics/colour.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 96, HEIGHT = 72 };

/* Names of files. Pictures of the box of that size, and one of twice the size. */
#define NAME "box.96x72.exr"
static struct image truth, frame, fine;

static void write_entry(const struct image *image, const char *file, const char *method) {
    expect(0, "rm -rf @/entry && mkdir -p @/entry");
    write_text(scratch("entry/method.json"), method);
    const char *path = form("entry/%s", file);
    check_ok(file, image_write(image, scratch(path)));
}

static int make_pictures(void **state) {
    (void)state;
    scratch("");
    expect(0, "rm -rf @/references && mkdir -p @/references");
    expect(0, "% reference scenes/cornell-box.glb --size 96x72 --spp 32 -q -o @/references/" NAME);
    expect(0, "% render scenes/cornell-box.glb --size 96x72 -q -o @/frame.exr");
    expect(0, "% render scenes/cornell-box.glb --size 192x144 -q -o @/fine.exr");
    return image_read(&truth, scratch("references/" NAME)) &&
                   image_read(&frame, scratch("frame.exr")) &&
                   image_read(&fine, scratch("fine.exr"))
               ? 0
               : -1;
}

static int free_pictures(void **state) {
    (void)state;
    images_free(&truth, &frame, &fine);
    return 0;
}

/* --- planted faults --------------------------------------------------------------------------- */

static struct image copy_of(const struct image *from, int width, int height) {
    struct image image;
    image_init_named(&image, width, height, (const char *const *)from->names, from->channel_count);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++)
            memcpy(image_at(&image, x, y), image_at(from, x, y),
                   sizeof(float) * (size_t)from->channel_count);
    return image;
}

static void expose(struct image *image) {
    for (int i = 0; i < WIDTH * HEIGHT * image->channel_count; i++)
        image->pixels[i] *= 1.25F;
}

static void encode(struct image *image) {
    for (int i = 0; i < WIDTH * HEIGHT * image->channel_count; i++)
        image->pixels[i] = srgb_encode(image->pixels[i]);
}

static void mirror(struct image *image) {
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            memcpy(image_at(image, x, y), image_at(&frame, WIDTH - 1 - x, y),
                   sizeof(float) * (size_t)frame.channel_count);
}

static void turn_over(struct image *image) {
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            memcpy(image_at(image, x, y), image_at(&frame, x, HEIGHT - 1 - y),
                   sizeof(float) * (size_t)frame.channel_count);
}

/* A pixel is the mean of four small ones, which begin one further to the left. */
static void shift(struct image *image) {
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            for (int c = 0; c < image->channel_count; c++) {
                int left = x > 0 ? 2 * x - 1 : 0, top = 2 * y;
                image_at(image, x, y)[c] =
                    (image_at(&fine, left, top)[c] + image_at(&fine, left + 1, top)[c] +
                     image_at(&fine, left, top + 1)[c] + image_at(&fine, left + 1, top + 1)[c]) /
                    4;
            }
}

static void plant_fireflies(struct image *image) {
    for (int i = 0; i < 3; i++)
        image_at(image, 20 + 20 * i, 30)[1] = 500;
}

static void plant_nan(struct image *image) {
    image_at(image, 10, 10)[0] = NAN;
    image_at(image, 11, 10)[2] = INFINITY;
}

static void check_shift(void) {
    const char *at = strstr(output, "about ");
    double right = NAN, down = NAN;
    assert_int_equal(sscanf(at, "about %lf pixels to the right and %lf", &right, &down), 2);
    check_near("shift to the right", right, .5, .15);
    check_near("shift down", down, 0, .1);
}

TEST(each_fault_is_named) {
    static const struct planted {
        const char *fault;
        void (*plant)(struct image *image);
    } planted[] = {
        {"exposure: all of it is 1.25 times", expose},
        {"encoded: its values are sRGB", encode},
        {"mirrored: it is mirrored left to right", mirror},
        {"mirrored: it is mirrored top to bottom", turn_over},
        {"shifted: it is shifted by about ", shift},
        {"fireflies: pixels eight times as bright as the reference around them: 3",
         plant_fireflies},
        {"not-finite: 2 values", plant_nan},
    };
    for (size_t i = 0; i < sizeof planted / sizeof *planted; i++) {
        struct image image = copy_of(&frame, WIDTH, HEIGHT);
        planted[i].plant(&image);
        write_entry(&image, NAME, "{\"name\": \"test\"}");
        expect(1, "% score @/entry @/references");
        expect_text(planted[i].fault);
        assert_int_equal(count_text(output, "fault: "), 1);
        image_free(&image);
        if (planted[i].plant == shift)
            check_shift();
    }
}

TEST(another_camera) {
    write_entry(&frame, NAME, "{\"name\": \"test\"}");
    expect(0, "% render scenes/cornell-box.glb --size 96x72 -q --camera \"0 eye=-2,4,1 "
              "forward=1,-.5,-.4\""
              " -o @/entry/" NAME);
    expect(1, "% score @/entry @/references");
    expect_text("fault: other-view: another camera, scene or light");
    assert_int_equal(count_text(output, "fault: "), 1);
}

TEST(size_layer_and_names) {
    struct image small = copy_of(&frame, 48, 36);
    write_entry(&small, NAME, "{\"name\": \"test\"}");
    expect(1, "% score @/entry @/references");
    expect_text("fault: size: it is 48x36, the reference 96x72");
    image_free(&small);
    write_entry(&frame, NAME, "{\"name\": \"test\", \"layers\": [\"indirect\", \"glow\"]}");
    expect(1, "% score @/entry @/references");
    expect_text("no layer 'glow'"); /* of the reference: it is no fault of the entry */
    write_entry(&frame, "box.96x72.3.exr", "{\"name\": \"test\"}");
    expect(0, "cp @/frame.exr @/entry/box.exr");
    expect(1, "% score @/entry @/references");
    expect_text("fault: missing-picture");
    expect_text("fault: no-reference");
    expect_text("fault: name");
}

TEST(missing_layer) {
    OWNED(image) beauty;
    image_init(&beauty, WIDTH, HEIGHT, "R G B");
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        memcpy(beauty.pixels + 3 * i, frame.pixels + frame.channel_count * i, 3 * sizeof(float));
    write_entry(&beauty, NAME, "{\"name\": \"test\", \"layers\": [\"indirect\"]}");
    expect(1, "% score @/entry @/references");
    expect_text("fault: missing-layer: ");
    assert_int_equal(count_text(output, "fault: "), 1);
}

/* The table does not mix with JSON on standard output. */
TEST(sums_and_standard_output) {
    char method[256], digits[SHA256_DIGITS + 1];
    write_entry(&frame, NAME, "{\"name\": \"test\"}");
    check_ok(NAME, sha256_of_file(scratch("entry/" NAME), digits));
    snprintf(method, sizeof method, "{\"name\": \"test\", \"sha256\": {\"" NAME "\": \"%s\"}}",
             digits);
    write_entry(&frame, NAME, method);
    expect(0, "% score @/entry @/references -o - 2> @/table");
    assert_int_equal(output[0], '{');
    expect_text("\"sha256\"");
    assert_int_equal(count_text(output, "relative-bias "), 0);
    expect(0, "cat @/table");
    expect_text("relative-bias ");
    char *last = &method[strlen(method) - 4];
    *last = *last == '0' ? '1' : '0';
    write_entry(&frame, NAME, method);
    expect(1, "% score @/entry @/references");
    expect_text("fault: sha256: its SHA-256 is ");
    assert_int_equal(count_text(output, "fault: "), 1);
    snprintf(method, sizeof method, "{\"name\": \"test\", \"sha256\": {\"a.1x1.exr\": \"%s\"}}",
             digits);
    write_entry(&frame, NAME, method);
    expect(1, "% score @/entry @/references");
    expect_text("a.1x1.exr");
    expect_text("fault: missing-picture: method.json lists its SHA-256");
}

/* --- figures ---------------------------------------------------------------------------------- */

/* The same digits as compare prints, and no fault, be the technique right or wrong. */
TEST(figures_are_those_of_compare) {
    static const char *const techniques[] = {"clustered", "unshadowed", "lightcuts"};
    for (int i = 0; i < 3; i++) {
        write_entry(&frame, NAME, "{\"name\": \"test\", \"layers\": [\"indirect\"]}");
        expect(
            0,
            form("%% render scenes/cornell-box.glb --size 96x72 --technique %s -q -o @/entry/" NAME,
                 techniques[i]));
        expect(0, "% score @/entry @/references -o @/score.json && cat @/score.json");
        assert_int_equal(count_text(output, "fault: "), 0);
        const char *of_score = form("%s", strstr(output, "\"scores\""));
        expect(0, "% compare @/entry/" NAME " @/references/" NAME
                  " --json -m relative-rmse -m mrse -m smape -m hdr-flip -m relative-bias"
                  " -l indirect | grep -o '\"[a-z-]*\": [-0-9.e]*[0-9]' | grep -v "
                  "'width\\|height\\|ppd'");
        for (char *figure = strtok(output, "\n"); figure; figure = strtok(NULL, "\n")) {
            printf("    %s\n", figure);
            expect_in(of_score, figure);
        }
    }
}

TEST(schemas) {
    need_command("python3 -c 'import jsonschema'");
    write_entry(
        &frame, NAME,
        "{\"name\": \"test\", \"version\": \"1\", \"url\": null, \"licence\": \"MIT\", \"device\":"
        " \"llvmpipe\", \"driver\": \"Mesa\", \"layers\": [\"indirect\"], \"ms\": {\"median\":"
        " 3.5, \"p99\": 4, \"frames\": 100, \"covers\": \"all passes\"}, \"history_frames\":"
        " 0, \"denoiser\": null, \"hardware_rays\": false, \"precomputed_s\": 0}");
    expect(0, "% score @/entry @/references -o @/score.json");
    expect(0, "python3 test/apps/check_schema.py bench/schema/score.schema.json @/score.json"
              " bench/schema/method.schema.json @/entry/method.json");
    write_text(scratch("wrong.json"), "{\"name\": \"test\", \"ms\": {\"median\": -1}}");
    expect(1, "python3 test/apps/check_schema.py bench/schema/method.schema.json @/wrong.json");
}

TEST(refusals) {
    static const struct refusal {
        const char *method, *message;
    } refusals[] = {
        {"{}", "method.json: name is missing"},
        {"{\"name\": \"\"}", "name: it is no text"},
        {"{\"name\": 3}", "name: it is no text"},
        {"[1]", "it is no object"},
        {"{\"name\"", "no JSON"},
        {"{\"name\": \"a\", \"ms\": {\"median\": -1}}", "ms: median: it is no number from 0 up"},
        {"{\"name\": \"a\", \"ms\": 3}", "ms: it is no object"},
        {"{\"name\": \"a\", \"ms\": {\"frames\": 1.5}}", "ms: frames: it is no whole number"},
        {"{\"name\": \"a\", \"layers\": \"direct\"}", "layers: it is no list of texts"},
        {"{\"name\": \"a\", \"hardware_rays\": 1}", "hardware_rays: it is neither true nor false"},
        {"{\"name\": \"a\", \"sha256\": {\"b.exr\": \"ab\"}}",
         "sha256: b.exr: it is no 64 lower-case hexadecimal digits"},
        {"{\"name\": \"a\", \"sha256\": []}", "sha256: it is no object"},
        {"{\"name\": \"a\", \"speed\": 1}", "'speed' is no field of it"},
    };
    for (size_t i = 0; i < sizeof refusals / sizeof *refusals; i++) {
        write_entry(&frame, NAME, refusals[i].method);
        expect(1, "% score @/entry @/references -o @/none.json");
        expect_text(refusals[i].message);
        expect(1, "test -e @/none.json");
    }
    expect(2, "% score @/entry");
    expect(1, "% score @/nowhere @/references");
    expect_text("cannot open");
    write_entry(&frame, NAME, "{\"name\": \"a\"}");
    expect(1, "% score @/entry @/nowhere");
    expect_text("cannot read the folder");
    expect(1, "% score @/entry @/references -o @/entry/method.json");
    expect_text("is the input");
    expect(1, "% score @/entry @/references -o @/references/" NAME);
    expect_text("is the input");
    expect(1, "% score @/entry @/references --scene sponza");
    expect_text("scene: REFERENCES has no picture of 'sponza'");
    expect(0, "head -c 2000 @/frame.exr > @/entry/" NAME);
    expect(1, "% score @/entry @/references -o @/none.json");
    expect_text(NAME);
    expect(1, "test -e @/none.json");
}

/* Examples of the standard, and all lengths around the ends of blocks: bytes that follow one
 * another in a chain. */
TEST(sha256) {
    static const struct example {
        const char *text, *digits;
    } examples[] = {
        {"", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"},
        {"abc", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"},
        {"abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq",
         "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"},
    };
    char digits[SHA256_DIGITS + 1];
    for (size_t i = 0; i < sizeof examples / sizeof *examples; i++) {
        sha256(examples[i].text, strlen(examples[i].text), digits);
        printf("    %s\n", digits);
        assert_string_equal(digits, examples[i].digits);
    }
    char chain[200 * SHA256_DIGITS + 1] = "";
    for (size_t i = 0; i < 200; i++) {
        sha256(chain, i, digits);
        memcpy(chain + i * SHA256_DIGITS, digits, SHA256_DIGITS);
    }
    sha256(chain, 200 * SHA256_DIGITS, digits);
    printf("    chain %s\n", digits);
    assert_string_equal(digits, "4eac42b463100e77a6ab668b7188207e90e2c9b280713517f60bdac2f7bf352f");
}

RUN_TESTS(make_pictures, free_pictures)
