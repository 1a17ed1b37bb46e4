/* The first time, with mouse and keys: start without arguments, click a scene, hold it against the
 * reference, find the cheapest setting below 5 % error, save a command line; in at most ten clicks.
 *
 *     build/test/test_view_walk [SHEET.jpg]     writes what was on screen after each step, too
 */
#define _XOPEN_SOURCE 700
#include "view_stage.h"

enum { SHEET_WIDTH = 440, STEPS_MAX = 6, COLUMNS = 3 };

static const char *sheet_path;
static int width = WIDTH; /* of the picture */
static struct bitmap steps[STEPS_MAX];
static int step_count, click_count;

/* Where no widget explains itself. */
static void keep(void) {
    xdo("mousemove %d %d", width - 40, HEIGHT - 60);
    sync_viewer();
    if (sheet_path)
        pause_ms(1200); /* what was explained goes */
    steps[step_count++] = read_screen();
}

/* Waits for what may take minutes on a busy machine. */
static void wait_for(const char *name) {
    for (int i = 0; i < 1200 && !is_on_screen(name); i++)
        pause_ms(100);
}

/* Until more is seen of the wall than a word on a ground. */
static void wait_for_picture(void) {
    for (int i = 0; i < 3000; i++) {
        struct bitmap screen = read_screen();
        int changes = 0;
        for (int x = 1; x < width; x++)
            changes += memcmp(pixel(&screen, x, 240), pixel(&screen, x - 1, 240), 3) != 0;
        bitmap_free(&screen);
        if (changes > width / 4)
            return;
        pause_ms(100);
    }
    fail_msg("no picture came");
}

static void click_on(const char *name) {
    press(name);
    click_count++;
}

TEST(start) {
    const char *arguments = form("--size %dx%d", width, HEIGHT);
    start_empty_viewer(arguments);
    if (sheet_path)
        pause_ms(20000); /* all pictures are there */
    keep();
    click_on("cornell-box");
    wait_for_scene("cornell-box.glb");
    wait_for("Chart speed and accuracy");
    wait_for_picture();
    keep();
}

TEST(reference) {
    need_viewer();
    click_on("Chart speed and accuracy");
    wait_for("Take the cheapest below 5 %");
    keep();
    int y = HEIGHT / 2;
    xdo("mousemove %d %d mousedown 1 mousemove %d %d mouseup 1", width / 2, y, width * 3 / 4, y);
    click_count++;
    keep();
}

TEST(cheapest) {
    need_viewer();
    click_on("Take the cheapest below 5 %");
    keep();
}

/* The picture by the script that was saved is the one left of the wipe. */
TEST(save) {
    need_viewer();
    click_on("Settings");
    click_on("Save command line");
    keep();
    struct bitmap shown = screenshot();
    assert_int_equal(shell("cd %s && mkdir -p bin && ln -sf %s bin/manylight && PATH=bin:$PATH sh "
                           "./manylight.settings.sh >render.log",
                           stage.folder, stage.binary),
                     0);
    const char *path = form("%s/picture.png", stage.folder);
    struct bitmap made = read_bitmap(path);
    int different = 0;
    for (int py = 0; py < HEIGHT; py++)
        for (int px = 0; px < width / 2 - 20; px++)
            different += memcmp(pixel(&made, px, py), pixel(&shown, px, py), 3) != 0;
    printf("    %d clicks; the saved command's picture: %d pixels differ\n", click_count,
           different);
    assert_int_equal(different, 0);
    assert_true(click_count <= 10);
    bitmaps_free(&made, &shown);
    end_viewer();
}

/* Half as large, beside each other. */
static void paste(struct bitmap *sheet, const struct bitmap *step, int left, int top) {
    for (int y = 0; y < step->height / 2; y++)
        for (int x = 0; x < step->width / 2; x++)
            for (int c = 0; c < 4; c++) {
                int sum = 0;
                for (int i = 0; i < 4; i++)
                    sum += pixel(step, 2 * x + i % 2, 2 * y + i / 2)[c];
                sheet->rgba[4 * ((top + y) * sheet->width + left + x) + c] =
                    (unsigned char)(sum / 4);
            }
}

static void write_sheet(void) {
    int wide = steps[0].width / 2, high = steps[0].height / 2;
    int rows = (step_count + COLUMNS - 1) / COLUMNS;
    OWNED(bitmap) sheet = {COLUMNS * (wide + 8) - 8, rows * (high + 8) - 8, NULL};
    sheet.rgba = calloc((size_t)sheet.width * (size_t)sheet.height, 4);
    memset(sheet.rgba, 255, (size_t)sheet.width * (size_t)sheet.height * 4);
    for (int i = 0; i < step_count; i++)
        paste(&sheet, &steps[i], i % COLUMNS * (wide + 8), i / COLUMNS * (high + 8));
    check_ok(sheet_path, bitmap_write(&sheet, sheet_path));
}

static int close_walk(void **state) {
    if (sheet_path && step_count == STEPS_MAX)
        write_sheet();
    for (int i = 0; i < step_count; i++)
        bitmap_free(&steps[i]);
    return close_view_stage(state);
}

int main(int argc, char **argv) {
    sheet_path = argc > 1 ? argv[1] : NULL;
    width = sheet_path ? SHEET_WIDTH : WIDTH;
    return run_file(__FILE__, open_view_stage, close_walk);
}
