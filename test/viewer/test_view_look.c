/* Looking closely, by real input events: pictures beside each other, their difference, enlarged
 * pixels, and the values under the mouse. Checked against pictures rendered offscreen. */
#define _XOPEN_SOURCE 700
#include "view_stage.h"

#include "inspect/marks.h"

#include <unistd.h>

#define BOX "scenes/cornell-box.glb"

enum { SMALL_WIDTH = WIDTH / 2, SMALL_HEIGHT = HEIGHT / 2 };

/* Half as wide and high as the window: what fits is enlarged twice. */
static void render_reference(const char *arguments, char *path, size_t size) {
    snprintf(path, size, "%s/reference.exr", stage.folder);
    assert_int_equal(shell("%s render --size %dx%d %s " BOX " %s -q -o %s", stage.binary,
                           SMALL_WIDTH, SMALL_HEIGHT, CHEAP, arguments, path),
                     0);
}

static struct bitmap render_small(const char *arguments) {
    const char *path = form("%s/small.png", stage.folder);
    assert_int_equal(shell("%s render --size %dx%d %s " BOX " %s -q -o %s", stage.binary,
                           SMALL_WIDTH, SMALL_HEIGHT, CHEAP, arguments, path),
                     0);
    return read_bitmap(path);
}

/* The name of a label or a line of values that begins so; "" = there is none. */
static void find_text(const char *begin, char *text, size_t size) {
    char line[300];
    const char *path = form("%s/places", stage.folder);
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    *text = '\0';
    while (!*text && fgets(line, sizeof line, file)) {
        int at = 0;
        line[strcspn(line, "\n")] = '\0';
        if (sscanf(line, "%*d %*d %*d %*d %n", &at) == 0 && at > 0 &&
            strncmp(line + at, begin, strlen(begin)) == 0)
            snprintf(text, size, "%s", line + at);
    }
    fclose(file);
}

static void begin(void) {
    char path[700];
    if (!stage.server)
        skip();
    render_reference("", path, sizeof path);
    const char *arguments = form("--technique unshadowed --reference %s", path);
    start_viewer(BOX, arguments);
    sync_viewer();
    xdo("key " F3 " key " F3); /* no times */
    sync_viewer();
}

/* Left of the wipe, each pixel is a square of four. */
TEST(enlarged) {
    begin();
    struct bitmap left = render_small("--technique unshadowed"), screen = read_screen();
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
    OWNED(bitmap) left = render_small("--technique unshadowed"), right = render_small("");
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
    char text[200];
    double told[3];
    OWNED(image) image;
    find_text(name, text, sizeof text);
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
    char text[200];
    need_viewer();
    xdo("key i mousemove %d %d", WIDTH / 4 + 1, HEIGHT / 2 + 201);
    sync_viewer();
    const char *reference = form("%s/reference.exr", stage.folder);
    const char *own = form("%s/own.exr", stage.folder);
    const char *command = form("%s render --size %dx%d %s " BOX " --technique unshadowed -q -o %s",
                               stage.binary, SMALL_WIDTH, SMALL_HEIGHT, CHEAP, own);
    assert_int_equal(shell("%s", command), 0);
    const int x = (WIDTH / 4 + 1) / 2, y = (HEIGHT / 2 + 201) / 2;
    int left, above, below;
    check_values("left ", own, x, y);
    check_values("right ", reference, x, y);
    find_text("left ", text, sizeof text);
    find_place(text, &left, &above);
    xdo("key " F3); /* the line of times, for which it makes room */
    find_place(text, &left, &below);
    printf("    at row %d, beside the times at %d\n", above, below);
    assert_true(above < 100 && below > HEIGHT / 2);
    xdo("key " F3 " key " F3 " key i");
    sync_viewer();
    find_text("left ", text, sizeof text);
    assert_string_equal(text, "");
}

/* Moved, the picture is not the reference's any more, and is told so; back again it is. */
TEST(view) {
    char text[200];
    need_viewer();
    press("Compare"); /* folded, it has no button of that name */
    sync_viewer();
    find_text("reference", text, sizeof text);
    assert_string_equal(text, "reference");
    xdo("mousemove 40 600 click 4");
    sync_viewer();
    find_text("reference", text, sizeof text);
    printf("    moved: %s\n", text);
    assert_string_equal(text, "reference of another view");
    xdo("key r");
    sync_viewer();
    find_text("reference", text, sizeof text);
    printf("    back: %s\n", text);
    assert_string_equal(text, "reference");
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
    char first[200], text[200];
    if (!stage.server)
        skip();
    start_viewer(BOX, "");
    sync_viewer();
    open_surface();
    xdo("mousemove 150 640 click 1");
    sync_viewer();
    find_text("position, m ", first, sizeof first);
    for (int i = 0; i < 4; i++) {
        xdo("mousemove 60 300 mousedown 1 mousemove %d 300 mouseup 1", i % 2 ? 53 : 67);
        sync_viewer();
        find_text("position, m ", text, sizeof text);
        printf("    %s, after a turn %s\n", first, text);
        assert_true(strlen(text) > 12);
        assert_string_equal(text, first);
    }
    end_viewer();
}

/* Where no surface is there is no normal. */
TEST(normals) {
    if (!stage.server)
        skip();
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
    if (!stage.server)
        skip();
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
