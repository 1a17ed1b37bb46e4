/* The viewer under an X server of its own, driven by real input events: what its tests share. */
#ifndef TEST_VIEW_STAGE_H
#define TEST_VIEW_STAGE_H

#include "desktop.h"
#include "support.h"

#include "base/image.h"

#include <sys/types.h>

/* Small and cheap, but tall enough that the panel's rows are on screen. */
enum { WIDTH = 240, HEIGHT = 740, PANEL = 340 };
#define CHEAP CHEAP_LIGHTS " --set exposure=0 --set tone-map=clamp"
#define CHEAP_LIGHTS                                                                               \
    "--set vpls=64 --set vals=4 --set map-size=32 --set rsm-size=64 --set shadow-size=256 "        \
    "--set interleave=4"

struct view_stage {
    pid_t server, viewer; /* 0: none */
    int questions;        /* put to this viewer */
    char display[16], screen[640], here[256], folder[600], binary[512];
};

extern struct view_stage stage;

/* For cmocka_run_group_tests: an X server and a scratch folder. Without Xvfb or xdotool there is no
 * server, and tests skip. */
int open_view_stage(void **state);
int close_view_stage(void **state);

/* With a viewer in this process: keeps OpenGL's driver past it, which would lose the name that its
 * leaks are told by (test/leaks-of-others). */
void keep_driver(void);

/* Starts the viewer in the scratch folder, and waits for the window to show the scene. Skips the
 * test where there is no server. */
void start_viewer(const char *scene, const char *arguments);

/* The same with nothing but these arguments, and without a scene. */
void start_empty_viewer(const char *arguments);

/* Skip the test where no window can be opened; where no viewer runs. */
void need_server(void);
void need_viewer(void);

/* Waits until the window shows a scene of that file. */
void wait_for_scene(const char *file);

/* Presses Ctrl Q: the viewer ends well, and OpenGL had nothing to say. */
void end_viewer(void);

void pause_ms(long ms);

/* The status of a shell command; a failure is printed. */
int shell(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Waits until all that was asked for so far is shown, and the viewer has told where its widgets
 * are. */
void sync_viewer(void);

/* Input events: the viewer takes them one after another, however fast they come. */
#define xdo(...) assert_int_equal(shell("xdotool " __VA_ARGS__), 0)
/* Function keys by number: by name, xdotool holds Alt, too, where the keymap is of xkb-data 2.48 */
#define F1 "67"
#define F2 "68"
#define F3 "69"
#define F9 "75"
#define F12 "96"
void click(int x, int y);

/* Drops a file onto the window: a path of the scratch folder's, or one of the tree. */
void drop(const char *path);

/* A path below the scratch folder. Static buffer. */
const char *in_stage(const char *name);

/* Writes a file of the scratch folder. */
void write_in_stage(const char *name, const char *text);

/* Types a path into the panel's open field. */
void open_by_panel(const char *path);

/* Seconds of all cores that the viewer has used so far. */
double used_seconds(void);

/* --- the panel --- */

/* The middle of a row's widget, a button or a heading, by its name; waits for it. */
void find_place(const char *name, int *x, int *y);
bool is_on_screen(const char *name);

/* The first name of a label, a line of values or a widget that begins so; "" = there is none.
 * Static buffer. */
const char *find_text(const char *begin);

/* Types a value into a row that has a slider, by Ctrl and a click. */
void type_into(const char *row, const char *text);
void press(const char *name);

/* Moves the mouse away from all widgets. */
void rest_mouse(void);

/* One of the buttons of the section of settings. */
void press_in_settings(const char *button);

/* The command line that its button copies, in a static buffer. check_command runs it: its picture
 * is the viewer's, bit for bit. */
const char *copy_command(void);
void check_command(const char *command);

/* Saves what all that was asked for so far has come to. */
void save_settings(void);

/* The value of a line "key = value" of the settings that were saved; "" = there is none. */
void read_setting(const char *key, char *value, size_t size);

/* --- pictures --- */

/* What the X server's screen shows. */
struct bitmap read_screen(void);
const unsigned char *pixel(const struct bitmap *bitmap, int x, int y);

struct bitmap read_bitmap(const char *path);
int count_differences(const struct bitmap *a, const struct bitmap *b);

/* Renders to a file of the scratch folder; its path. */
const char *render_file(const char *name, int width, int height, const char *arguments);

/* What `manylight render` makes of these arguments, at the viewer's size. */
struct bitmap offscreen(const char *arguments);

/* Presses F12 and takes the picture that comes. */
struct bitmap screenshot(void);

/* What the viewer has is, bit for bit, what is rendered offscreen. */
void check_same(const char *what, const char *arguments);

#endif
