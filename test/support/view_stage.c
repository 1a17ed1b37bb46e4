/* The X server lets its screen be read as a file (-fbdir). */
#define _GNU_SOURCE
#include "view_stage.h"

#include <dlfcn.h>
#include <limits.h>
#include <link.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

struct view_stage stage;

/* --- processes --- */

void pause_ms(long ms) {
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

int shell(const char *format, ...) {
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

/* Begins a server on a display that is free. */
static bool start_server(void) {
    char command[2048], number[640], text[16] = "";
    char output[64];
    if (run_command("command -v Xvfb && command -v xdotool", output, sizeof output) != 0)
        return false;
    snprintf(number, sizeof number, "%s/display", stage.folder);
    remove(number);
    snprintf(command, sizeof command,
             "Xvfb -displayfd 3 -noreset -screen 0 800x800x24 -nolisten tcp -fbdir %s 3>%s "
             "2>/dev/null",
             stage.folder, number);
    stage.server = spawn(command);
    for (int i = 0; i < PATIENCE_MS / 50 && !strchr(text, '\n'); i++) {
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
    unsetenv("WAYLAND_DISPLAY");
    return strchr(text, '\n') != NULL;
}

static void end_process(pid_t *process) {
    if (*process > 0) {
        kill(*process, SIGTERM);
        waitpid(*process, NULL, 0);
    }
    *process = 0;
}

/* --- the screen --- */

/* X's window dump: a header of big-endian words, then B G R x. */
struct bitmap read_screen(void) {
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

const unsigned char *pixel(const struct bitmap *bitmap, int x, int y) {
    return bitmap->rgba + 4 * (y * bitmap->width + x);
}

/* Leaves what the screen shows for whoever looks into it. */
static void fail_with_screen(const char *why) {
    char path[700];
    struct bitmap screen = read_screen();
    snprintf(path, sizeof path, "%s/screen.png", stage.folder);
    bitmap_write(&screen, path);
    fail_msg("%s; the screen: %s", why, path);
}

/* The middle of the first widget whose name begins so, as the viewer tells where they are, and its
 * name. */
static bool read_place(const char *begin, bool is_whole, int *x, int *y, char name[300]) {
    char path[700], line[300];
    bool found = false;
    snprintf(path, sizeof path, "%s/places", stage.folder);
    FILE *file = fopen(path, "r");
    while (file && !found && fgets(line, sizeof line, file)) {
        int left, top, width, height, at = 0;
        line[strcspn(line, "\n")] = '\0';
        found = sscanf(line, "%d %d %d %d %n", &left, &top, &width, &height, &at) == 4 &&
                strncmp(line + at, begin, strlen(begin)) == 0 &&
                (!is_whole || strlen(line + at) == strlen(begin));
        if (found) {
            *x = left + width / 2;
            *y = top + height / 2;
            snprintf(name, 300, "%s", line + at);
        }
    }
    if (file)
        fclose(file);
    return found;
}

/* How often the viewer has told that all is shown. */
static int count_answers(void) {
    char path[700], line[300];
    int count = 0;
    snprintf(path, sizeof path, "%s/places", stage.folder);
    FILE *file = fopen(path, "r");
    while (file && fgets(line, sizeof line, file))
        sscanf(line, "0 0 0 0 answered %d", &count);
    if (file)
        fclose(file);
    return count;
}

void sync_viewer(void) {
    xdo("key " F9);
    stage.questions++;
    for (int i = 0; i < PATIENCE_MS / 10 && count_answers() < stage.questions; i++) {
        if (waitpid(stage.viewer, NULL, WNOHANG) != 0) {
            stage.viewer = 0;
            fail_msg("the viewer has ended");
        }
        pause_ms(10);
    }
    if (count_answers() < stage.questions)
        fail_with_screen("the viewer does not come to rest");
}

bool is_on_screen(const char *name) {
    char known[300];
    int x, y;
    sync_viewer();
    return read_place(name, true, &x, &y, known);
}

const char *find_text(const char *begin) {
    static char name[300];
    int x, y;
    return read_place(begin, false, &x, &y, name) ? name : "";
}

/* What is not there after a moment may be above or below what the panel shows. */
void find_place(const char *name, int *x, int *y) {
    char known[300];
    for (int i = 0; i < 200; i++) {
        sync_viewer();
        if (read_place(name, true, x, y, known))
            return;
        if (i >= 3 && i % 3 == 0)
            xdo("mousemove %d %d click --repeat %d --delay 1 %d", WIDTH + PANEL - 6, HEIGHT / 2,
                i == 3 ? 40 : 3, i == 3 ? 4 : 5);
        pause_ms(50);
    }
    char why[200];
    snprintf(why, sizeof why, "no widget is called '%s'", name);
    fail_with_screen(why);
}

void press(const char *name) {
    int x, y;
    find_place(name, &x, &y);
    click(x, y);
}

void rest_mouse(void) {
    xdo("mousemove %d %d", WIDTH / 2, HEIGHT / 2);
}

void click(int x, int y) {
    xdo("mousemove %d %d click 1", x, y);
}

void type_into(const char *row, const char *text) {
    int x, y;
    find_place(row, &x, &y);
    xdo("mousemove %d %d keydown ctrl click 1 keyup ctrl", x, y);
    sync_viewer();
    xdo("key ctrl+a type --delay 5 %s", text);
    xdo("key Return");
    rest_mouse();
    sync_viewer();
}

void press_in_settings(const char *button) {
    if (!is_on_screen(button))
        press("Settings");
    press(button);
    rest_mouse();
    sync_viewer();
}

const char *copy_command(void) {
    static char command[3000];
    press_in_settings("Copy command line");
    assert_true(desktop_read_clipboard(command, sizeof command));
    printf("    %s\n", command);
    return command;
}

void check_command(const char *command) {
    assert_int_equal(shell("cd %s && %s -q", stage.folder, command), 0);
    OWNED(bitmap) expected = read_bitmap(in_stage("picture.png")), got = screenshot();
    assert_int_equal(count_differences(&expected, &got), 0);
}

const char *render_file(const char *name, int width, int height, const char *arguments) {
    const char *path = form("%s/%s", stage.folder, name);
    assert_int_equal(shell("%s render --size %dx%d %s %s -q -o %s", stage.binary, width, height,
                           CHEAP, arguments, path),
                     0);
    return path;
}

void save_settings(void) {
    char path[700];
    snprintf(path, sizeof path, "%s/manylight.settings", stage.folder);
    sync_viewer();
    remove(path);
    press_in_settings("Save");
    for (int i = 0; i < PATIENCE_MS / 50 && access(path, R_OK) != 0; i++)
        pause_ms(50);
}

void read_setting(const char *key, char *value, size_t size) {
    char path[700], line[600];
    size_t length = strlen(key);
    snprintf(path, sizeof path, "%s/manylight.settings", stage.folder);
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    value[0] = '\0';
    while (fgets(line, sizeof line, file))
        if (strncmp(line, key, length) == 0 && strncmp(line + length, " = ", 3) == 0)
            snprintf(value, size, "%.*s", (int)strcspn(line + length + 3, "\n"), line + length + 3);
    fclose(file);
}

/* --- pictures --- */

struct bitmap read_bitmap(const char *path) {
    OWNED(image) image;
    check_ok(path, image_read(&image, path));
    struct bitmap bitmap = {image.width, image.height,
                            calloc((size_t)image.width * (size_t)image.height, 4)};
    for (int i = 0; i < image.width * image.height; i++)
        for (int c = 0; c < 3; c++)
            bitmap.rgba[4 * i + c] = (unsigned char)lrintf(
                255 * image.pixels[(size_t)i * (size_t)image.channel_count + (size_t)c]);
    return bitmap;
}

int count_differences(const struct bitmap *a, const struct bitmap *b) {
    assert_int_equal(a->width, b->width);
    assert_int_equal(a->height, b->height);
    int count = 0;
    for (int i = 0; i < a->width * a->height; i++)
        count += memcmp(a->rgba + 4 * i, b->rgba + 4 * i, 3) != 0;
    return count;
}

/* Each picture is rendered once. */
struct bitmap offscreen(const char *arguments) {
    static char known[64][900];
    char path[700];
    int i = 0;
    while (i < 64 && known[i][0] && strcmp(known[i], arguments) != 0)
        i++;
    assert_true(i < 64 && strlen(arguments) < sizeof known[0]);
    snprintf(path, sizeof path, "%s/offscreen-%d.png", stage.folder, i);
    if (known[i][0])
        return read_bitmap(path);
    remove(path);
    snprintf(known[i], sizeof known[i], "%s", arguments);
    assert_int_equal(shell("%s render --size %dx%d %s %s -q -o %s", stage.binary, WIDTH, HEIGHT,
                           CHEAP, arguments, path),
                     0);
    return read_bitmap(path);
}

struct bitmap screenshot(void) {
    char png[700], exr[700];
    snprintf(png, sizeof png, "%s/manylight-0001.png", stage.folder);
    snprintf(exr, sizeof exr, "%s/manylight-0001.exr", stage.folder);
    remove(png);
    remove(exr);
    sync_viewer();
    xdo("key " F12);
    for (int i = 0; i < PATIENCE_MS / 10 && access(exr, R_OK) != 0; i++)
        pause_ms(10);
    if (access(exr, R_OK) != 0)
        fail_with_screen("no screenshot came");
    struct bitmap bitmap = read_bitmap(png);
    remove(png);
    remove(exr);
    return bitmap;
}

void check_same(const char *what, const char *arguments) {
    OWNED(bitmap) expected = offscreen(arguments), got = screenshot();
    int different = count_differences(&expected, &got);
    printf("    %-48s %d pixels differ\n", what, different);
    if (different)
        fail_with_screen(what);
}

/* --- the viewer --- */

void wait_for_scene(const char *file) {
    for (int i = 0; i < PATIENCE_MS / 20 &&
                    shell("xdotool search --onlyvisible --name '%s - manylight'", file);
         i++)
        pause_ms(20);
    rest_mouse();
    sync_viewer();
}

/* Another viewer's. */
static void remove_places(void) {
    char path[700];
    snprintf(path, sizeof path, "%s/places", stage.folder);
    remove(path);
}

void need_server(void) {
    if (!stage.server)
        skip();
}

static void spawn_viewer(const char *arguments) {
    char command[2000], line[2100];
    need_server();
    end_process(&stage.viewer); /* left by the test before, it would take this one's keys */
    /* Under make asan: GLFW unloads the driver with what that has lost; leaks of ours are
     * test_view_leaks' to find. */
    snprintf(command, sizeof command,
             "cd %s && LSAN_OPTIONS=detect_leaks=0 exec %s view %s --gl-debug --places places "
             ">viewer.log 2>&1",
             stage.folder, stage.binary, arguments);
    snprintf(line, sizeof line, "sh -c '%s'", command);
    remove_places();
    stage.questions = 0;
    stage.viewer = spawn(line);
}

/* Before it there is nobody to take a key. */
static void wait_for_window(void) {
    for (int i = 0; i < PATIENCE_MS / 20 && shell("xdotool search --onlyvisible --name manylight");
         i++)
        pause_ms(20);
}

void start_viewer(const char *scene, const char *arguments) {
    char all[1500];
    const char *slash = strrchr(scene, '/');
    snprintf(all, sizeof all, "%s/%s --size %dx%d " CHEAP " %s", stage.here, scene, WIDTH, HEIGHT,
             arguments);
    spawn_viewer(all);
    wait_for_scene(slash ? slash + 1 : scene);
}

void start_empty_viewer(const char *arguments) {
    int x, y;
    spawn_viewer(arguments);
    wait_for_window();
    find_place("Open a file ...", &x, &y);
}

void need_viewer(void) {
    if (!stage.viewer)
        skip();
}

void end_viewer(void) {
    char log[700], output[4096];
    int status = -1;
    xdo("key ctrl+q");
    for (int i = 0; i < PATIENCE_MS / 10 && waitpid(stage.viewer, &status, WNOHANG) == 0; i++)
        pause_ms(10);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), 0);
    stage.viewer = 0;
    snprintf(log, sizeof log, "cat %s/viewer.log", stage.folder);
    run_command(log, output, sizeof output);
    printf("%s", output);
    assert_null(strstr(output, "OpenGL"));
}

void open_by_panel(const char *path) {
    press("open");
    sync_viewer(); /* until the field has the keyboard: a slow viewer added the path to what was
                      there */
    xdo("key ctrl+a");
    sync_viewer();
    xdo("type --delay 1 %s/%s", stage.here, path);
    xdo("key Return");
    rest_mouse();
}

void drop(const char *path) {
    char full[700], window[256];
    snprintf(full, sizeof full, "%s%s%s", *path == '/' ? "" : stage.here, *path == '/' ? "" : "/",
             path);
    assert_int_equal(run_command("xdotool search --name manylight", window, sizeof window), 0);
    assert_true(desktop_drop(strtoul(window, NULL, 10), full));
}

const char *in_stage(const char *name) {
    static char path[700];
    snprintf(path, sizeof path, "%s/%s", stage.folder, name);
    return path;
}

void write_in_stage(const char *name, const char *text) {
    FILE *file = fopen(in_stage(name), "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

double used_seconds(void) {
    char path[64], line[1024];
    unsigned long user = 0, system = 0;
    snprintf(path, sizeof path, "/proc/%d/stat", (int)stage.viewer);
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    assert_non_null(fgets(line, sizeof line, file));
    fclose(file);
    const char *after = strrchr(line, ')');
    assert_non_null(after);
    assert_int_equal(
        sscanf(after + 2, "%*c %*d %*d %*d %*d %*d %*u %*u %*u %*u %*u %lu %lu", &user, &system),
        2);
    return (double)(user + system) / (double)sysconf(_SC_CLK_TCK);
}

int open_view_stage(void **state) {
    (void)state;
    assert_non_null(getcwd(stage.here, sizeof stage.here));
    char name[64];
    snprintf(name, sizeof name, "view-%d", (int)getpid());
    const char *folder = scratch(name);
    snprintf(stage.folder, sizeof stage.folder, "%s%s%s", folder[0] == '/' ? "" : stage.here,
             folder[0] == '/' ? "" : "/", folder);
    mkdir(stage.folder, 0777);
    setenv("XDG_CACHE_HOME", stage.folder, 1); /* not the user's own */
    /* For a binary that no scenes lie beside, as one with sanitizers. */
    shell("ln -sfn %s/scenes %s/scenes", stage.here, stage.folder);
    char *binary = realpath(binary_path(), NULL);
    assert_non_null(binary);
    snprintf(stage.binary, sizeof stage.binary, "%s", binary);
    free(binary);
    if (!start_server())
        printf("    skipped: Xvfb or xdotool is not here\n");
    return 0;
}

static int find_driver(struct dl_phdr_info *info, size_t size, void *path) {
    (void)size;
    if (strstr(info->dlpi_name, "_dri.so"))
        snprintf(path, PATH_MAX, "%s", info->dlpi_name);
    return 0;
}

void keep_driver(void) {
    char path[PATH_MAX] = "";
    dl_iterate_phdr(find_driver, path);
    if (path[0])
        dlopen(path, RTLD_LAZY | RTLD_NOLOAD | RTLD_NODELETE);
}

int close_view_stage(void **state) {
    (void)state;
    end_process(&stage.viewer);
    end_process(&stage.server);
    return 0;
}
