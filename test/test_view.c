/* The viewer under an X server of its own, with real input events; what it shows is checked by
 * picture: against pictures rendered offscreen, bit for bit. Skipped without Xvfb or xdotool. */
#define _XOPEN_SOURCE 700
#include "support.h"

#include "base/image_file.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* Small and cheap, but tall enough that the panel's rows are on screen. */
enum { WIDTH = 240, HEIGHT = 740, PANEL = 340 };
#define CHEAP                                                                                      \
    "--set vpls=64 --set vals=4 --set map-size=32 --set rsm-size=64 --set shadow-size=256 "        \
    "--set interleave=4"
#define SCENE "scenes/cornell-box.glb"

static struct {
    pid_t server, viewer;
    char display[16], screen[640], here[256], folder[600], binary[512];
} stage;

/* --- processes --- */

static void pause_ms(long ms) {
    nanosleep(&(struct timespec){ms / 1000, ms % 1000 * 1000000}, NULL);
}

static pid_t spawn(const char *command) {
    char line[4096];
    snprintf(line, sizeof line, "exec %s", command);
    pid_t child = fork();
    if (child == 0) {
        execl("/bin/sh", "sh", "-c", line, (char *)NULL);
        _exit(127);
    }
    return child;
}

static int shell(const char *format, ...) __attribute__((format(printf, 1, 2)));
static int shell(const char *format, ...) {
    char command[3000], output[4096];
    va_list args;
    va_start(args, format);
    vsnprintf(command, sizeof command, format, args);
    va_end(args);
    int status = run_command(command, output, sizeof output);
    if (status != 0 && !strstr(command, "search"))
        printf("    %s\n    -> %d: %s\n", command, status, output);
    return status;
}

#define xdo(...) assert_int_equal(shell("xdotool " __VA_ARGS__), 0)

/* Begins a server on a display that is free. */
static bool start_server(void) {
    char command[2048], number[640], text[16] = "";
    char output[64];
    if (run_command("command -v Xvfb && command -v xdotool", output, sizeof output) != 0)
        return false;
    snprintf(number, sizeof number, "%s/display", stage.folder);
    remove(number);
    snprintf(command, sizeof command,
             "Xvfb -displayfd 3 -screen 0 800x800x24 -nolisten tcp -fbdir %s 3>%s 2>/dev/null",
             stage.folder, number);
    stage.server = spawn(command);
    for (int i = 0; i < 100 && !strchr(text, '\n'); i++) {
        pause_ms(50);
        FILE *file = fopen(number, "r");
        if (file && !fgets(text, sizeof text, file))
            text[0] = '\0';
        if (file)
            fclose(file);
    }
    snprintf(stage.display, sizeof stage.display, ":%d", atoi(text));
    snprintf(stage.screen, sizeof stage.screen, "%s/Xvfb_screen0", stage.folder);
    setenv("DISPLAY", stage.display, 1);
    return strchr(text, '\n') != NULL;
}

static void stop(pid_t *process) {
    if (*process > 0) {
        kill(*process, SIGTERM);
        waitpid(*process, NULL, 0);
    }
    *process = 0;
}

/* --- the screen --- */

/* X's window dump: a header of big-endian words, then B G R x. */
static struct bitmap read_screen(void) {
    FILE *file = fopen(stage.screen, "rb");
    unsigned char header[100];
    assert_non_null(file);
    assert_int_equal(fread(header, 1, sizeof header, file), sizeof header);
#define WORD(i)                                                                                    \
    (long)((unsigned)header[4 * (i)] << 24 | header[4 * (i) + 1] << 16 |                           \
           header[4 * (i) + 2] << 8 | header[4 * (i) + 3])
    int width = (int)WORD(4), height = (int)WORD(5);
    long row = WORD(12), start = WORD(0) + 12 * WORD(19);
    struct bitmap screen = {width, height, calloc((size_t)width * (size_t)height, 4)};
    unsigned char *line = malloc((size_t)row);
    for (int y = 0; y < height; y++) {
        fseek(file, start + y * row, SEEK_SET);
        assert_int_equal(fread(line, 1, (size_t)row, file), row);
        for (int x = 0; x < width; x++)
            for (int c = 0; c < 4; c++)
                screen.rgba[4 * (y * width + x) + c] = c < 3 ? line[4 * x + 2 - c] : 255;
    }
    free(line);
    fclose(file);
    return screen;
}

static const unsigned char *pixel(const struct bitmap *bitmap, int x, int y) {
    return bitmap->rgba + 4 * (y * bitmap->width + x);
}

/* The middle of the n-th run of a widget's ground colour down a column of the panel, below y; 0 =
 * there is none. */
static int find_widget(int x, int below, int n) {
    static const unsigned char raised[3] = {42, 46, 54};
    struct bitmap screen = read_screen();
    int start = -1, found = 0;
    for (int y = below; y < HEIGHT && !found; y++) {
        bool on = memcmp(pixel(&screen, WIDTH + x, y), raised, 3) == 0;
        if (on && start < 0)
            start = y;
        if (!on && start >= 0) {
            if (y - start > 12 && n-- == 0)
                found = (start + y) / 2;
            start = -1;
        }
    }
    bitmap_free(&screen);
    return found;
}

/* The headings' row; they alone reach the panel's left edge. */
static int find_section(int n) {
    return find_widget(10, 0, n);
}

enum { SECTION_SCENE, SECTION_SETTINGS = 5, SECTION_TECHNIQUE = 6 };
enum { COLUMN_WIDGET = 123, COLUMN_BUTTON = 17 };

static void click(int x, int y) {
    xdo("mousemove %d %d sleep .3 mousedown 1 sleep .3 mouseup 1 sleep .3", x, y);
}

/* --- pictures --- */

static struct bitmap read_bitmap(const char *path) {
    struct image image;
    check_ok(path, image_read(&image, path));
    struct bitmap bitmap = {image.width, image.height,
                            calloc((size_t)image.width * (size_t)image.height, 4)};
    for (int i = 0; i < image.width * image.height; i++)
        for (int c = 0; c < 3; c++)
            bitmap.rgba[4 * i + c] = (unsigned char)lrintf(
                255 * image.pixels[(size_t)i * (size_t)image.channel_count + (size_t)c]);
    image_free(&image);
    return bitmap;
}

static int count_differences(const struct bitmap *a, const struct bitmap *b) {
    assert_int_equal(a->width, b->width);
    assert_int_equal(a->height, b->height);
    int count = 0;
    for (int i = 0; i < a->width * a->height; i++)
        count += memcmp(a->rgba + 4 * i, b->rgba + 4 * i, 3) != 0;
    return count;
}

static struct bitmap offscreen(const char *arguments) {
    char path[700];
    snprintf(path, sizeof path, "%s/offscreen.png", stage.folder);
    remove(path);
    assert_int_equal(shell("%s render --size %dx%d %s %s -q -o %s", stage.binary, WIDTH, HEIGHT,
                           CHEAP, arguments, path),
                     0);
    return read_bitmap(path);
}

/* Leaves what the screen shows for whoever looks into it. */
static void fail_with_screen(const char *why) {
    char path[700];
    struct bitmap screen = read_screen();
    snprintf(path, sizeof path, "%s/screen.png", stage.folder);
    bitmap_write(&screen, path);
    fail_msg("%s; the screen: %s", why, path);
}

/* Presses F12 and takes the picture that comes. */
static struct bitmap screenshot(void) {
    char png[700], exr[700];
    snprintf(png, sizeof png, "%s/manylight-0001.png", stage.folder);
    snprintf(exr, sizeof exr, "%s/manylight-0001.exr", stage.folder);
    remove(png);
    remove(exr);
    xdo("key F12");
    for (int i = 0; i < 300 && access(exr, R_OK) != 0; i++)
        pause_ms(50);
    if (access(exr, R_OK) != 0)
        fail_with_screen("no screenshot came");
    struct bitmap bitmap = read_bitmap(png);
    remove(png);
    remove(exr);
    return bitmap;
}

/* What the viewer has is, bit for bit, what is rendered offscreen. */
static void check_same(const char *what, const char *arguments) {
    struct bitmap expected = offscreen(arguments), got = screenshot();
    int different = count_differences(&expected, &got);
    printf("    %-48s %d pixels differ\n", what, different);
    if (different)
        fail_with_screen(what);
    bitmap_free(&expected);
    bitmap_free(&got);
}

/* --- the viewer --- */

static void start_viewer(void) {
    char command[2000];
    snprintf(command, sizeof command,
             "cd %s && exec %s view %s/%s --size %dx%d %s --gl-debug >viewer.log 2>&1",
             stage.folder, stage.binary, stage.here, SCENE, WIDTH, HEIGHT, CHEAP);
    char line[2100];
    snprintf(line, sizeof line, "sh -c '%s'", command);
    stage.viewer = spawn(line);
    for (int i = 0; i < 200 && shell("xdotool search --name 'cornell-box.glb - manylight'"); i++)
        pause_ms(50);
    xdo("mousemove %d %d", WIDTH / 2, HEIGHT / 2);
    pause_ms(500);
}

static int set_up(void **state) {
    (void)state;
    assert_non_null(getcwd(stage.here, sizeof stage.here));
    const char *folder = scratch("view");
    snprintf(stage.folder, sizeof stage.folder, "%s%s%s", folder[0] == '/' ? "" : stage.here,
             folder[0] == '/' ? "" : "/", folder);
    mkdir(stage.folder, 0777);
    char *binary = realpath(binary_path(), NULL);
    assert_non_null(binary);
    snprintf(stage.binary, sizeof stage.binary, "%s", binary);
    free(binary);
    if (!start_server())
        printf("    skipped: Xvfb or xdotool is not here\n");
    else
        start_viewer();
    return 0;
}

static int tear_down(void **state) {
    (void)state;
    stop(&stage.viewer);
    stop(&stage.server);
    return 0;
}

static void need_viewer(void) {
    if (!stage.viewer)
        skip();
}

/* --- tests --- */

static void test_first_picture(void **state) {
    (void)state;
    need_viewer();
    check_same("the window's picture", SCENE);
    /* And so it is on the screen, where no overlay lies. */
    xdo("key F3 sleep .4");
    struct bitmap expected = offscreen(SCENE), screen = read_screen();
    int different = 0;
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            /* Messages below, the mouse in the middle. */
            if (y < HEIGHT - 120 && abs(x - WIDTH / 2) + abs(y - HEIGHT / 2) > 30)
                different += memcmp(pixel(&expected, x, y), pixel(&screen, x, y), 3) != 0;
    printf("    %-48s %d pixels differ\n", "on the screen", different);
    assert_int_equal(different, 0);
    bitmap_free(&expected);
    bitmap_free(&screen);
}

static void test_wipe(void **state) {
    (void)state;
    need_viewer();
    xdo("key c sleep 1");
    xdo("mousemove %d %d mousedown 1 sleep .2 mousemove %d %d sleep .2 mouseup 1 sleep .6",
        WIDTH / 2, 80, WIDTH / 4, 80);
    struct bitmap left = offscreen(SCENE), right = offscreen(SCENE " --technique unshadowed"),
                  screen = read_screen();
    int wrong = 0, told_apart = 0;
    for (int y = 0; y < HEIGHT - 140; y++)
        for (int x = 0; x < WIDTH; x++) {
            if (abs(x - WIDTH / 4) < 24) /* the line and the mouse on it */
                continue;
            const struct bitmap *side = x < WIDTH / 4 ? &left : &right;
            wrong += memcmp(pixel(side, x, y), pixel(&screen, x, y), 3) != 0;
            told_apart += memcmp(pixel(&left, x, y), pixel(&right, x, y), 3) != 0;
        }
    printf("    %-48s %d pixels wrong, %d differ between the two\n", "wipe", wrong, told_apart);
    assert_int_equal(wrong, 0);
    assert_true(told_apart > WIDTH * HEIGHT / 20);
    bitmap_free(&left);
    bitmap_free(&right);
    bitmap_free(&screen);
    xdo("key c sleep .5"); /* no reference is loaded: off */
}

static void test_panel(void **state) {
    (void)state;
    need_viewer();
    int section = find_section(SECTION_TECHNIQUE);
    assert_true(section > 0);
    int technique = find_widget(COLUMN_WIDGET, section + 14, 0);
    int vals = find_widget(COLUMN_WIDGET, section + 14, 3); /* after path and vpls */
    assert_true(technique > 0 && vals > technique);
    /* Ctrl and a click let a slider's value be typed. */
    xdo("mousemove %d %d sleep .3 keydown ctrl sleep .3 mousedown 1 sleep .3 mouseup 1 sleep .2",
        WIDTH + COLUMN_WIDGET, vals);
    xdo("keyup ctrl sleep .3");
    xdo("type --delay 100 9");
    xdo("sleep .3 key Return sleep .8");
    check_same("vals typed into the panel", SCENE " --set vals=9");
    click(WIDTH + COLUMN_WIDGET, technique);
    xdo("sleep .5 mousemove %d %d sleep .5 mousedown 1 sleep .3 mouseup 1 sleep 1",
        WIDTH + COLUMN_WIDGET + 30, technique + 12 + 12 + 5 + 2 * 19);
    check_same("technique chosen in the panel", SCENE " --set vals=9 --technique unshadowed");
}

/* The saved settings' camera, for a command line. */
static void read_camera(char *text, size_t size) {
    char path[700], line[600];
    snprintf(path, sizeof path, "%s/manylight.settings", stage.folder);
    for (int i = 0; i < 60 && access(path, R_OK) != 0; i++)
        pause_ms(50);
    pause_ms(100);
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    text[0] = '\0';
    while (fgets(line, sizeof line, file)) {
        line[strcspn(line, "\n")] = '\0';
        if (strncmp(line, "camera = ", 9) == 0)
            snprintf(text, size, "%.399s", line + 9);
    }
    fclose(file);
    remove(path);
}

static void test_orbit(void **state) {
    (void)state;
    need_viewer();
    struct bitmap before = screenshot();
    xdo("mousemove 60 300 mousedown 1 sleep .1 mousemove 90 310 sleep .2 mousemove 100 315 sleep "
        ".2 "
        "mouseup 1 click 4 sleep .6");
    struct bitmap after = screenshot();
    assert_true(count_differences(&before, &after) > WIDTH * HEIGHT / 4);
    bitmap_free(&before);
    bitmap_free(&after);

    int section = find_section(SECTION_SETTINGS);
    click(WIDTH + 60, section);
    pause_ms(300);
    int save = find_widget(COLUMN_BUTTON, section + 14, 0);
    click(WIDTH + COLUMN_BUTTON + 8, save);
    char camera[400], arguments[700];
    read_camera(camera, sizeof camera);
    printf("    %s\n", camera);
    assert_non_null(strstr(camera, "eye="));
    snprintf(arguments, sizeof arguments,
             SCENE " --set vals=9 --technique unshadowed --camera \"%s\"", camera);
    check_same("an orbit, rendered by the saved camera", arguments);
}

/* By the path typed into the panel: what a drop of a file calls, too. */
static void test_open(void **state) {
    (void)state;
    need_viewer();
    int section = find_section(SECTION_SCENE);
    int open = find_widget(COLUMN_WIDGET, section + 14, 0);
    click(WIDTH + COLUMN_WIDGET, open);
    xdo("type --delay 15 %s/scenes/no-such-file.glb", stage.here);
    xdo("key Return sleep .5"); /* an error, and the window lives on */
    click(WIDTH + COLUMN_WIDGET, open);
    xdo("keydown ctrl sleep .5 key a sleep .5 keyup ctrl sleep .2");
    xdo("type --delay 15 %s/scenes/sphere.glb", stage.here);
    xdo("key Return");
    for (int i = 0; i < 100 && shell("xdotool search --name 'sphere.glb - manylight'"); i++)
        pause_ms(50);
    pause_ms(600);
    xdo("mousemove %d %d", WIDTH / 2, HEIGHT / 2);
    check_same("another scene", "scenes/sphere.glb --set vals=9 --technique unshadowed");
}

static void test_end(void **state) {
    (void)state;
    need_viewer();
    char log[700], output[4096];
    int status = -1;
    xdo("key Escape");
    for (int i = 0; i < 100 && waitpid(stage.viewer, &status, WNOHANG) == 0; i++)
        pause_ms(50);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), 0);
    stage.viewer = 0;
    snprintf(log, sizeof log, "cat %s/viewer.log", stage.folder);
    run_command(log, output, sizeof output);
    printf("%s", output);
    assert_null(strstr(output, "OpenGL"));
}

static void test_script(void **state) {
    (void)state;
    if (!stage.server)
        skip();
    char path[700];
    snprintf(path, sizeof path, "%s/script.png", stage.folder);
    assert_int_equal(shell("%s view " SCENE " --size %dx%d " CHEAP " --frames 3 --screenshot %s",
                           stage.binary, WIDTH, HEIGHT, path),
                     0);
    struct bitmap got = read_bitmap(path), expected = offscreen(SCENE);
    assert_int_equal(count_differences(&got, &expected), 0);
    bitmap_free(&got);
    bitmap_free(&expected);
    assert_int_equal(shell("%s view no-such-file.glb --frames 1 2>/dev/null", stage.binary), 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_first_picture), cmocka_unit_test(test_wipe),
        cmocka_unit_test(test_panel),         cmocka_unit_test(test_orbit),
        cmocka_unit_test(test_open),          cmocka_unit_test(test_end),
        cmocka_unit_test(test_script),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
