/* Looking closely, by real input events: pictures beside each other, their difference, enlarged
 * pixels, and the values under the mouse. Checked against pictures rendered offscreen. */
#define _XOPEN_SOURCE 700
#include "view_stage.h"

#include "inspect/marks.h"

#define BOX "scenes/cornell-box.glb"

enum { SMALL_WIDTH = WIDTH / 2, SMALL_HEIGHT = HEIGHT / 2 };

/* Half as wide and high as the window: what fits is enlarged twice. */
static const char *render_small(const char *name, const char *arguments) {
    return render_file(name, SMALL_WIDTH, SMALL_HEIGHT, arguments);
}

static void begin(void) {
    need_server();
    const char *arguments =
        form("--technique unshadowed --reference %s", render_small("reference.exr", BOX));
    start_viewer(BOX, arguments);
    sync_viewer();
    xdo("key " F3 " key " F3); /* no times */
    sync_viewer();
}

/* Left of the wipe, each pixel is a square of four. */
TEST(enlarged) {
    begin();
    struct bitmap left = read_bitmap(render_small("small.png", BOX " --technique unshadowed")),
                  screen = read_screen();
    int wrong = 0;
    for (int y = 20; y < HEIGHT - 140; y++)
        for (int x = 0; x < WIDTH / 2 - 24; x++)
            wrong += memcmp(pixel(&left, x / 2, y / 2), pixel(&screen, x, y), 3) != 0;
    printf("    %-48s %d pixels wrong\n", "twice as large", wrong);
    assert_int_equal(wrong, 0);
    bitmap_free(&screen);
    xdo("mousemove %d %d key z mousemove %d 30", WIDTH / 4, HEIGHT / 2, WIDTH - 10);
    sync_viewer();
    screen = read_screen();
    wrong = 0;
    /* What was under the mouse stays there. */
    for (int y = -40; y < 40; y++)
        for (int x = -20; x < 20; x++)
            wrong += memcmp(pixel(&left, WIDTH / 8 + x, HEIGHT / 4 + y),
                            pixel(&screen, WIDTH / 4 + x, HEIGHT / 2 + y), 3) != 0;
    printf("    %-48s %d pixels wrong\n", "1:1", wrong);
    assert_int_equal(wrong, 0);
    bitmaps_free(&left, &screen);
    xdo("key z");
}

TEST(layouts) {
    need_viewer();
    OWNED(bitmap) left = read_bitmap(render_small("small.png", BOX " --technique unshadowed"));
    OWNED(bitmap) right = read_bitmap(render_small("small.png", BOX));
    xdo("key v");
    OWNED(bitmap) beside = screenshot();
    assert_int_equal(beside.width, 2 * SMALL_WIDTH);
    xdo("key v");
    OWNED(bitmap) difference = screenshot();
    int wrong = 0, apart = 0, wrong_beside = 0;
    for (int y = 0; y < SMALL_HEIGHT; y++)
        for (int x = 0; x < SMALL_WIDTH; x++)
            for (int c = 0; c < 3; c++) {
                int l = pixel(&left, x, y)[c], r = pixel(&right, x, y)[c];
                int expected = abs(l - r) < 64 ? 4 * abs(l - r) : 255;
                /* Half floats in the file. */
                wrong += abs(pixel(&difference, x, y)[c] - expected) > 4;
                apart += expected > 16;
                wrong_beside += pixel(&beside, x, y)[c] != l;
                wrong_beside += abs(pixel(&beside, x + SMALL_WIDTH, y)[c] - r) > 1;
            }
    printf("    beside %d values wrong; difference %d wrong, %d large\n", wrong_beside, wrong,
           apart);
    assert_int_equal(wrong_beside, 0);
    assert_int_equal(wrong, 0);
    assert_true(apart > SMALL_WIDTH * SMALL_HEIGHT / 20);
    xdo("key v"); /* the wipe again */
}

/* The inspector tells what is in the files. */
static void check_values(const char *name, const char *path, int x, int y) {
    const char *text = find_text(name);
    double told[3];
    OWNED(image) image;
    printf("    %s\n", text);
    assert_int_equal(sscanf(text + strlen(name), "%lf %lf %lf", &told[0], &told[1], &told[2]), 3);
    check_ok(path, image_read(&image, path));
    for (int c = 0; c < 3; c++) {
        double expected = (double)image_at(&image, x, y)[c];
        printf("        %.5f in the file, %.5f told\n", expected, told[c]);
        assert_true(fabs(told[c] - expected) <= 1e-4 + .001 * fabs(expected));
    }
}

TEST(inspector) {
    need_viewer();
    xdo("key i mousemove %d %d", WIDTH / 4 + 1, HEIGHT / 2 + 201);
    sync_viewer();
    const char *reference = form("%s/reference.exr", stage.folder);
    const char *own = render_small("own.exr", BOX " --technique unshadowed");
    const int x = (WIDTH / 4 + 1) / 2, y = (HEIGHT / 2 + 201) / 2;
    int left, above, below;
    check_values("left ", own, x, y);
    check_values("right ", reference, x, y);
    const char *text = find_text("left ");
    find_place(text, &left, &above);
    xdo("key " F3); /* the line of times, for which it makes room */
    find_place(text, &left, &below);
    printf("    at row %d, beside the times at %d\n", above, below);
    assert_true(above < 100 && below > HEIGHT / 2);
    xdo("key " F3 " key " F3 " key i");
    sync_viewer();
    assert_string_equal(find_text("left "), "");
}

/* Moved, the picture is not the reference's any more, and is told so; back again it is. */
TEST(view) {
    need_viewer();
    press("Compare"); /* folded, it has no button of that name */
    sync_viewer();
    assert_string_equal(find_text("reference"), "reference");
    xdo("mousemove 40 600 click 4");
    sync_viewer();
    assert_string_equal(find_text("reference"), "reference of another view");
    xdo("key r");
    sync_viewer();
    assert_string_equal(find_text("reference"), "reference");
    end_viewer();
}

/* Closed, the others leave room for what is told of the surface. */
static void open_surface(void) {
    press("Quality");
    press("Picture");
    press("Surface");
}

/* What was clicked on stays the same place, however often it is looked at from elsewhere. */
TEST(pick) {
    char first[300];
    need_server();
    start_viewer(BOX, "");
    sync_viewer();
    open_surface();
    xdo("mousemove 150 640 click 1");
    sync_viewer();
    snprintf(first, sizeof first, "%s", find_text("position, m "));
    for (int i = 0; i < 4; i++) {
        xdo("mousemove 60 300 mousedown 1 mousemove %d 300 mouseup 1", i % 2 ? 53 : 67);
        sync_viewer();
        printf("    %s, after a turn %s\n", first, find_text("position, m "));
        assert_true(strlen(first) > 12);
        assert_string_equal(find_text("position, m "), first);
    }
    end_viewer();
}

/* Where no surface is there is no normal. */
TEST(normals) {
    need_server();
    start_viewer(BOX, "");
    sync_viewer();
    press("output");
    press("normal");
    struct bitmap normals = screenshot();
    const unsigned char *above = pixel(&normals, WIDTH / 2, 3);
    int most = above[0], least = above[0];
    for (int c = 1; c < 3; c++) {
        most = above[c] > most ? above[c] : most;
        least = above[c] < least ? above[c] : least;
    }
    printf("    where nothing is: %d %d %d\n", above[0], above[1], above[2]);
    assert_true(most - least < 30 && most < 100);
    bitmap_free(&normals);
    end_viewer();
}

/* Four VALs' shadows have their numbers and colours, and what their own colours stand for. */
TEST(sheet) {
    int x, y, wrong = 0;
    need_server();
    start_viewer(BOX, "");
    press("output");
    press("visibility");
    rest_mouse();
    sync_viewer();
    struct bitmap screen = read_screen();
    for (int i = 0; i < 4; i++) {
        unsigned char expected[3];
        const char *number = form("%d", i);
        find_place(number, &x, &y);
        marks_cluster_color(i, expected);
        const unsigned char *got = pixel(&screen, x + 19, y);
        printf("    VAL %d at %d %d: %d %d %d\n", i, x, y, got[0], got[1], got[2]);
        wrong += memcmp(got, expected, 3) != 0;
    }
    bitmap_free(&screen);
    assert_int_equal(wrong, 0);
    assert_true(is_on_screen("in its shadow"));
    xdo("mousemove %d %d click 1", x, y);
    assert_false(is_on_screen("3")); /* alone */
    assert_true(is_on_screen("in its shadow"));
    end_viewer();
}

RUN_TESTS(open_view_stage, close_view_stage)
