/* Pictures of figures: heat maps, their labels, and pictures beside each other. */
#include "support.h"

#include "base/image.h"
#include "metrics/colour.h"
#include "metrics/heat_map.h"
#include "metrics/label.h"

static double lightness_at(const struct bitmap *picture, int x, int y) {
    float rgb[3], lab[3];
    for (int c = 0; c < 3; c++)
        rgb[c] = srgb_decode(picture->rgba[(y * picture->width + x) * 4 + c] / 255.f);
    rgb_to_lab(rgb, lab);
    return (double)lab[0];
}

/* Lightness changes in proportion: up from black, or down on both sides of white. */
TEST(heat_map) {
    enum { WIDTH = 401 };
    static float values[WIDTH];
    for (int is_signed = 0; is_signed < 2; is_signed++) {
        for (int x = 0; x < WIDTH; x++)
            values[x] = is_signed ? (x - 200) / 100.f : x / 200.f;
        struct heat_map map = {.title = "bias -0.5",
                               .width = WIDTH,
                               .height = 1,
                               .values = values,
                               .top = 2,
                               .is_signed = is_signed};
        OWNED(bitmap) picture;
        heat_map_draw(&map, &picture);
        assert_int_equal(picture.width, WIDTH);
        for (int x = 20; x < WIDTH; x += 20) {
            double rise = !is_signed ? 97 / 20. : x <= 200 ? 57 / 10. : -57 / 10.;
            check_near("lightness step",
                       lightness_at(&picture, x, 0) - lightness_at(&picture, x - 20, 0), rise, .5);
        }
        check_near("zero", lightness_at(&picture, is_signed ? 200 : 0, 0), is_signed ? 97 : 0, 1);
    }
}

TEST(heat_map_scale) {
    float values[1000];
    for (int i = 0; i < 1000; i++)
        values[i] = (i % 2 ? -.31f : .31f) * (float)i / 1000;
    values[7] = 1e6f; /* a firefly does not set the scale */
    check_near("top", (double)heat_map_fit_top(values, 1000), .5, 1e-6);
    check_near("top of nothing", (double)heat_map_fit_top((const float[]){0, 0}, 2), 1, 0);
    check_near("top of a single error", (double)heat_map_fit_top((const float[]){0, -.1f}, 2), .1,
               1e-6);
    struct heat_map map = {.title = "x", .width = 2, .height = 1, .values = values, .top = 1};
    OWNED(bitmap) picture;
    heat_map_draw(&map, &picture);
    assert_int_equal(picture.width, 256); /* enlarged, so that the scale has room */
    map = (struct heat_map){.title = "x", .width = 1, .height = 900, .values = values, .top = 1};
    bitmap_free(&picture);
    heat_map_draw(&map, &picture);
    assert_int_equal(picture.width, 256); /* beside black */
    assert_true(picture.height > 900 && picture.height < 1000);
}

/* The rectangle of what is not black: left, top, right, bottom, the last two behind it. */
static void find_drawn(const struct bitmap *picture, int first_row, int box[4]) {
    box[0] = picture->width, box[1] = picture->height, box[2] = box[3] = 0;
    for (int y = first_row; y < picture->height; y++)
        for (int x = 0; x < picture->width; x++) {
            if (!picture->rgba[4 * (y * picture->width + x)])
                continue;
            box[0] = x < box[0] ? x : box[0];
            box[1] = y < box[1] ? y : box[1];
            box[2] = x >= box[2] ? x + 1 : box[2];
            box[3] = y >= box[3] ? y + 1 : box[3];
        }
}

static void check_box(const char *what, const int box[4], int left, int top, int right,
                      int bottom) {
    printf("    %-24s %d %d %d %d\n", what, box[0], box[1], box[2], box[3]);
    assert_true(box[0] == left && box[1] == top && box[2] == right && box[3] == bottom);
}

/* Letters of 5 dots, one dot apart; a z fills its five rows from the third on, and is cut at
 * borders. */
TEST(label) {
    OWNED(bitmap) picture = {30, 20, calloc(30 * 20, 4)};
    int box[4];
    assert_int_equal(label_width("zz", 1), 12);
    assert_int_equal(label_width("z", 3), 18);
    label_draw(&picture, 3, 2, 2, "zz");
    find_drawn(&picture, 0, box);
    check_box("two letters", box, 3, 6, 25, 16);
    memset(picture.rgba, 0, 30 * 20 * 4);
    label_draw(&picture, 26, -3, 2, "z");
    find_drawn(&picture, 0, box);
    check_box("a letter at the corner", box, 26, 1, 30, 11);
    memset(picture.rgba, 0, 30 * 20 * 4);
    label_draw(&picture, -4, 8, 2, "z");
    find_drawn(&picture, 0, box);
    check_box("a letter at the other", box, 0, 12, 6, 18);
}

/* Each value fills a square; below lie the bar, its numbers and the title. */
TEST(heat_map_layout) {
    static const float values[6] = {1, .5f, .25f, .5f, .75f, .5f};
    struct heat_map map = {.title = "z", .width = 3, .height = 2, .values = values, .top = 1};
    OWNED(bitmap) picture;
    unsigned char expected[3];
    int box[4], zoom = 85;
    heat_map_draw(&map, &picture);
    assert_int_equal(picture.width, 256);
    assert_int_equal(picture.height, 2 * zoom + 38);
    for (int i = 0; i < 6; i++) {
        int left = i % 3 * zoom, top = i / 3 * zoom;
        heat_map_color(&map, values[i], expected);
        for (int y = top; y < top + zoom; y++)
            for (int x = left; x < left + zoom; x++)
                assert_memory_equal(picture.rgba + 4 * (y * 256 + x), expected, 3);
    }
    heat_map_color(&map, 1 - .5f / 220, expected); /* the middle of the bar's last pixel */
    assert_memory_equal(picture.rgba + 4 * ((2 * zoom + 8) * 256 + 256 - 19), expected, 3);
    find_drawn(&picture, 2 * zoom + 23, box);
    check_box("title", box, 18, 2 * zoom + 29, 23, 2 * zoom + 34);
}

/* Colours without a legend, as they lie on the picture; files as numbers, and none of no format. */
TEST(heat_map_files) {
    static const float values[6] = {1, .5f, .25f, .5f, .75f, .5f}, none[2] = {0, 0},
                       wild[2] = {INFINITY, INFINITY};
    struct heat_map map = {.title = "z", .width = 3, .height = 2, .values = values, .top = 1};
    struct bitmap picture;
    unsigned char expected[3];
    struct image image;
    heat_map_draw_values(&map, &picture);
    assert_true(picture.width == 3 && picture.height == 2);
    for (int i = 0; i < 6; i++) {
        heat_map_color(&map, values[i], expected);
        assert_memory_equal(picture.rgba + 4 * i, expected, 3);
    }
    bitmap_free(&picture);
    check_ok("as numbers", heat_map_write(&map, scratch("map.exr")));
    check_ok("read", image_read(&image, scratch("map.exr")));
    for (int i = 0; i < 6; i++)
        check_near("value", (double)image.pixels[i], (double)values[i], 1e-3);
    image_free(&image);
    check_refused(heat_map_write(&map, scratch("map.doc")), "");
    check_near("top of nothing", (double)heat_map_fit_top(none, 2), 1, 0);
    check_near("top without bound", (double)heat_map_fit_top(wild, 2), 1, 0);
    for (int digit = 1; digit < 10; digit++) {
        float value = .1F * (float)digit;
        static const double tops[] = {.1, .2, .5, .5, .5, 1, 1, 1, 1};
        check_near("top", (double)heat_map_fit_top(&value, 1), tops[digit - 1], 1e-6);
    }
}

RUN_TESTS(NULL, NULL)
