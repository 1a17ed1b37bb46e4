/* Opens a window with an OpenGL 4.5 core context and collects its input. Only this file names
 * GLFW. */
#ifndef VIEWER_WINDOW_WINDOW_H
#define VIEWER_WINDOW_WINDOW_H

#include "viewer/window/events.h"

/* Keys. Letters, digits and punctuation are their ASCII characters, letters in upper case. */
enum window_key {
    KEY_NONE,
    KEY_SPACE = ' ',
    KEY_LEFT_BRACKET = '[',
    KEY_RIGHT_BRACKET = ']',
    KEY_ESCAPE = 256,
    KEY_F1,
    KEY_F2,
    KEY_F3,
    KEY_F4,
    KEY_F5,
    KEY_F6,
    KEY_F7,
    KEY_F8,
    KEY_F9,
    KEY_F10,
    KEY_F11,
    KEY_F12,
    KEY_COUNT,
    KEY_WITH_CONTROL = 1 << 10, /* added to a key pressed with Ctrl */
    KEY_WITH_ALT = 1 << 12,     /* the same for Alt */
    KEY_WITH_SHIFT = 1 << 11,   /* the same for Shift */
};

/* Keys of widgets: Dear ImGui's name, and GLFW's. */
#define WIDGET_KEYS(KEY)                                                                           \
    KEY(Tab, TAB)                                                                                  \
    KEY(LeftArrow, LEFT)                                                                           \
    KEY(RightArrow, RIGHT)                                                                         \
    KEY(UpArrow, UP)                                                                               \
    KEY(DownArrow, DOWN)                                                                           \
    KEY(PageUp, PAGE_UP)                                                                           \
    KEY(PageDown, PAGE_DOWN)                                                                       \
    KEY(Home, HOME)                                                                                \
    KEY(End, END)                                                                                  \
    KEY(Insert, INSERT)                                                                            \
    KEY(Delete, DELETE)                                                                            \
    KEY(Backspace, BACKSPACE)                                                                      \
    KEY(Space, SPACE)                                                                              \
    KEY(Enter, ENTER)                                                                              \
    KEY(KeypadEnter, KP_ENTER)                                                                     \
    KEY(Escape, ESCAPE)                                                                            \
    KEY(A, A)                                                                                      \
    KEY(C, C)                                                                                      \
    KEY(V, V)                                                                                      \
    KEY(X, X)                                                                                      \
    KEY(Y, Y)                                                                                      \
    KEY(Z, Z)

enum widget_key {
#define WIDGET_KEY(name, code) WIDGET_KEY_##name,
    WIDGET_KEYS(WIDGET_KEY)
#undef WIDGET_KEY
        WIDGET_KEY_COUNT
};

enum window_button { BUTTON_LEFT, BUTTON_RIGHT, BUTTON_MIDDLE, BUTTON_COUNT };

/* Input of one turn, in which order does not matter (viewer/window/events.h). Positions are in
 * pixels of the framebuffer, y down. */
struct input {
    int width, height; /* of the framebuffer; 0 while minimised */
    float scale;       /* of widgets; 2: twice as many pixels per inch */
    double x, y, dx, dy, scroll;
    double press_x, press_y; /* place of the last press */
    bool inside;             /* the mouse is over the window */
    bool held[BUTTON_COUNT], pressed[BUTTON_COUNT], released[BUTTON_COUNT];
    bool shift, control, alt;
    bool key_held[KEY_COUNT]; /* without keys pressed with Ctrl or Alt, which are commands */
    int keys[EVENTS_OF_TURN]; /* pressed, in order */
    int key_count;
    unsigned text[EVENTS_OF_TURN]; /* characters typed */
    int text_count;
    bool widget_keys[WIDGET_KEY_COUNT]; /* held */
    char *dropped;                      /* path of a dropped file, or NULL */
    bool any;                           /* at least one event */
    bool close;                         /* requested by the window manager */
};

struct window_desc {
    const char *title;
    int width, height; /* of the picture, pixels */
    int margin;        /* beside the picture, pixels of a monitor of scale 1 */
    float scale;       /* of widgets; 0: the monitor's */
    bool debug;        /* a debug context */
};

struct window;

/* Opens a window and makes its context current. Error: no display, or no such context. */
struct window *window_create(const struct window_desc *desc);

/* Hides the window. Accepts NULL. */
void window_hide(struct window *window);

/* Closes the window. Accepts NULL. */
void window_free(struct window *window);

/* Opens a hidden window for its context, which is like the window's and shares nothing with it.
 * Call it on the window's thread. Error: as window_create. */
struct window *window_create_hidden(void);
void window_free_hidden(struct window *window);

/* Bind the context to the calling thread, and unbind it. */
void window_bind(struct window *window);
void window_unbind(void);

/* Returns the address of an OpenGL function, for context_adopt. */
void *window_getproc(const char *name);

/* Returns GLFW's window, for the user interface. */
void *window_native(struct window *window);

/* Returns the input of the next turn. Waits up to `wait` seconds for input. holds: keeps further
 * events for later turns. Valid until the next poll. */
const struct input *window_poll(struct window *window, double wait, bool holds);

/* Ends a waiting window_poll. Any thread may call it. */
void window_wake(void);

/* Shows the drawn frame; with vertical sync, waits for the monitor. */
void window_swap(struct window *window);

void window_set_title(struct window *window, const char *title);
void window_set_size(struct window *window, int width, int height);
bool window_is_full_screen(const struct window *window);
void window_toggle_full_screen(struct window *window);

/* Sets the scale of widgets. 0: the monitor's. */
void window_set_scale(struct window *window, float scale);
void window_set_clipboard(struct window *window, const char *text);

/* Returns seconds since a fixed point in the past. */
double window_time(void);

#endif
