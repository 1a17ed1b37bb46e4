/* The a-trous filter on pictures made by hand, and `manylight reference --denoise`. */
#include "command_support.h"

#include "base/image.h"
#include "reference/atrous.h"

enum { SIZE = 64, COUNT = SIZE * SIZE };

struct picture {
    struct atrous_guide guides[COUNT];
    struct atrous_pixel pixels[COUNT];
};

static const struct atrous_desc desc_of_all = {
    .width = SIZE, .height = SIZE, .levels = 5, .blind_levels = 1};

/* A plane seen squarely, pixels 1 mm apart; light of 1 and much noise, so that nothing but the
 * surface keeps pixels apart. */
static void make_plane(struct picture *picture) {
    for (int i = 0; i < COUNT; i++) {
        picture->guides[i] = FILLED(
            atrous_guide, .position = {{0.001f * (float)(i % SIZE), 0.001f * (float)(i / SIZE), 0}},
            .normal = {{0, 0, 1}}, .pixel_size = 0.001f);
        picture->pixels[i] = (struct atrous_pixel){{{1, 1, 1}}, 100};
    }
}

static void filter(struct picture *picture) {
    struct atrous_desc desc = desc_of_all;
    atrous_find_lonely(SIZE, SIZE, picture->guides);
    desc.guides = picture->guides;
    atrous_filter(&desc, picture->pixels);
}

static bool is_right(int i) {
    return i % SIZE >= SIZE / 2;
}

/* The farthest from 1 on the left and 3 on the right. */
static double farthest(const struct picture *picture) {
    double worst = 0;
    for (int i = 0; i < COUNT; i++)
        for (int c = 0; c < 3; c++)
            worst =
                fmax(worst, fabs((double)picture->pixels[i].light.raw[c] - (is_right(i) ? 3 : 1)));
    return worst;
}

static void brighten_right(struct picture *picture) {
    for (int i = 0; i < COUNT; i++)
        if (is_right(i))
            picture->pixels[i].light = (vec3s){{3, 3, 3}};
}

TEST(constant) {
    static struct picture picture;
    make_plane(&picture);
    for (int i = 0; i < COUNT; i += 7)
        picture.guides[i].normal = vec3s_unit((vec3s){{0.3f, 0.1f, 1}});
    filter(&picture);
    double worst = 0;
    for (int i = 0; i < COUNT; i++)
        worst = fmax(worst, fabs((double)picture.pixels[i].light.x - 1));
    check_at_most("a constant changes by", worst, 1e-6);
}

TEST(edges) {
    static struct picture picture;
    make_plane(&picture);
    brighten_right(&picture);
    for (int i = 0; i < COUNT; i++)
        if (is_right(i))
            picture.guides[i].position.z = 0.01f;
    filter(&picture);
    check_at_most("over a step of ten pixels", farthest(&picture), 1e-5);

    make_plane(&picture);
    brighten_right(&picture);
    for (int i = 0; i < COUNT; i++)
        if (is_right(i))
            picture.guides[i].normal = vec3s_unit((vec3s){{0.6f, 0, 1}});
    filter(&picture);
    check_at_most("over a bend of 31 degrees", farthest(&picture), 1e-5);

    make_plane(&picture);
    brighten_right(&picture);
    for (int i = 0; i < COUNT; i++)
        picture.pixels[i].variance = 0;
    struct atrous_desc desc = desc_of_all;
    desc.guides = picture.guides;
    desc.blind_levels = 0;
    atrous_filter(&desc, picture.pixels);
    check_at_most("over an edge of light without noise", farthest(&picture), 1e-5);

    make_plane(&picture);
    brighten_right(&picture);
    filter(&picture);
    double across = farthest(&picture);
    check_at_most("with nothing between, it spreads", 0.5, across);
}

/* White noise on a plane. */
TEST(noise) {
    static struct picture picture;
    uint32_t random = 1;
    make_plane(&picture);
    for (int i = 0; i < COUNT; i++) {
        random = random * 1664525u + 1013904223u;
        float value = 1 + ((float)(random >> 8) / 0x1p24f - 0.5f) * sqrtf(12 * 0.04f);
        picture.pixels[i] = (struct atrous_pixel){{{value, value, value}}, 0};
    }
    struct atrous_desc desc = desc_of_all;
    desc.guides = picture.guides;
    atrous_estimate_variance(&desc, false, picture.pixels);
    double estimate = 0, left = 0, mean = 0;
    for (int i = 0; i < COUNT; i++)
        estimate += (double)picture.pixels[i].variance / COUNT;
    /* The mean of 49 pixels takes a forty-ninth of it. */
    check_near("variance of 0.04, by the neighbours", estimate, 0.04 * 48 / 49, 0.001);
    atrous_filter(&desc, picture.pixels);
    for (int i = 0; i < COUNT; i++) {
        mean += (double)picture.pixels[i].light.x / COUNT;
        left += pow((double)picture.pixels[i].light.x - 1, 2) / COUNT;
    }
    check_near("mean", mean, 1, 0.005);
    check_at_most("noise of 0.2 that is left", sqrt(left), 0.02);
}

/* A pixel that is unlike all others has only them to take light from. */
TEST(lonely) {
    static struct picture picture;
    make_plane(&picture);
    int leaf = 20 * SIZE + 20;
    picture.guides[leaf].normal = vec3s_unit((vec3s){{0.5f, 0, 1}});
    picture.pixels[leaf].light = (vec3s){{50, 50, 50}};
    filter(&picture);
    assert_true(picture.guides[leaf].is_lonely);
    assert_false(picture.guides[leaf + 1].is_lonely);
    check_at_most("a bright pixel of another surface", (double)picture.pixels[leaf].light.x, 25);
    check_near("beside it", (double)picture.pixels[leaf + 1].light.x, 1, 0.02);
}

/* --- the command --- */

static void trace(const char *arguments, struct image *image) {
    expect_command(0, "reference scenes/cornell-box.glb -o @/denoise.exr --size 80x80", arguments);
    check_ok("read", image_read(image, scratch("denoise.exr")));
}

static double relative_error(const struct image *test, const struct image *reference) {
    int layer[3];
    check_ok("layer", image_find_layer(reference, "indirect", layer));
    double squares = 0, sum = 0;
    for (int y = 0; y < reference->height; y++)
        for (int x = 0; x < reference->width; x++)
            for (int c = 0; c < 3; c++) {
                float v = image_at(test, x, y)[layer[c]], r = image_at(reference, x, y)[layer[c]];
                squares += (double)((v - r) * (v - r));
                sum += (double)r;
            }
    return sqrt(squares * 3 * reference->width * reference->height) / sum;
}

static double energy_of(const struct image *image) {
    double sum = 0;
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++)
            for (int c = 0; c < 3; c++)
                sum += (double)image_at(image, x, y)[c];
    return sum;
}

TEST(box) {
    static const struct {
        int samples;
        double least_gain;
    } cases[] = {{1, 2.5}, {4, 2}, {16, 1.2}};
    struct image reference, raw, filtered;
    trace("--spp 64 --seed 9 -q", &reference);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char arguments[64];
        snprintf(arguments, sizeof arguments, "--spp %d --paths 1", cases[i].samples);
        trace(arguments, &raw);
        snprintf(arguments, sizeof arguments, "--spp %d --paths 1 --denoise", cases[i].samples);
        trace(arguments, &filtered);
        double before = relative_error(&raw, &reference),
               after = relative_error(&filtered, &reference);
        printf("    %d paths: error %g, denoised %g, %g times less\n", cases[i].samples, before,
               after, before / after);
        check_at_most("the gain asked for", cases[i].least_gain, before / after);
        check_near("energy", energy_of(&filtered) / energy_of(&raw), 1, 0.01);
        images_free(&raw, &filtered);
    }
    image_free(&reference);
}

RUN_TESTS(NULL, NULL)
