#include "viewer/window/window.h"

#include "base/error.h"
#include "base/memory.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <stdlib.h>
#include <string.h>

struct window {
    GLFWwindow *handle;
    struct input input;
    /* What callbacks collect: in order, and what has none until the next poll. */
    struct events events;
    struct input next;
    float scale; /* that is asked for; 0 = the monitor's */
    bool down[GLFW_KEY_LAST + 1];
    /* Where to come back to from full screen, in screen coordinates. */
    int x, y, width, height;
};

/* Function keys and Escape; all others are ASCII. */
static int key_of(int key) {
    if (key == GLFW_KEY_ESCAPE)
        return KEY_ESCAPE;
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12)
        return KEY_F1 + key - GLFW_KEY_F1;
    return key >= GLFW_KEY_SPACE && key < 128 ? key : KEY_NONE;
}

static void on_error(int code, const char *description) {
    (void)code;
    error_set("%s", description);
}

/* Shift alone is part of the character that is typed. */
static int key_with(int key, int modifiers) {
    bool control = modifiers & GLFW_MOD_CONTROL, shift = modifiers & GLFW_MOD_SHIFT;
    return key + (control ? KEY_WITH_CONTROL : 0) + (control && shift ? KEY_WITH_SHIFT : 0) +
           (modifiers & GLFW_MOD_ALT ? KEY_WITH_ALT : 0);
}

static void add(GLFWwindow *handle, const struct event *event) {
    struct window *window = glfwGetWindowUserPointer(handle);
    events_add(&window->events, event);
}

/* A key that is held comes again and again. What it types comes as text; fields repeat the other
 * keys by themselves, as long as the window draws. */
static void on_key(GLFWwindow *handle, int code, int scancode, int action, int modifiers) {
    (void)scancode;
    if (action == GLFW_REPEAT)
        ((struct window *)glfwGetWindowUserPointer(handle))->next.any = true;
    else
        add(handle, &(struct event){.kind = EVENT_KEY,
                                    .code = code,
                                    .modifiers = modifiers,
                                    .down = action == GLFW_PRESS});
}

static void on_text(GLFWwindow *handle, unsigned character) {
    add(handle, &(struct event){.kind = EVENT_TEXT, .code = (int)character});
}

/* From the system's own units, which may be several pixels, to pixels. */
static void to_pixels(GLFWwindow *handle, double *x, double *y) {
    int width, height, pixel_width, pixel_height;
    glfwGetWindowSize(handle, &width, &height);
    glfwGetFramebufferSize(handle, &pixel_width, &pixel_height);
    if (width > 0 && height > 0) {
        *x *= (double)pixel_width / width;
        *y *= (double)pixel_height / height;
    }
}

static void on_button(GLFWwindow *handle, int button, int action, int modifiers) {
    (void)modifiers;
    if (button < BUTTON_COUNT)
        add(handle,
            &(struct event){.kind = EVENT_BUTTON, .code = button, .down = action == GLFW_PRESS});
}

static void on_scroll(GLFWwindow *handle, double x, double y) {
    (void)x;
    add(handle, &(struct event){.kind = EVENT_SCROLL, .y = y});
}

static void on_cursor(GLFWwindow *handle, double x, double y) {
    to_pixels(handle, &x, &y);
    add(handle, &(struct event){.kind = EVENT_CURSOR, .x = x, .y = y});
}

static void on_refresh(GLFWwindow *handle) {
    ((struct window *)glfwGetWindowUserPointer(handle))->next.any = true;
}

static void on_drop(GLFWwindow *handle, int count, const char **paths) {
    struct input *next = &((struct window *)glfwGetWindowUserPointer(handle))->next;
    if (count == 0)
        return;
    next->any = true;
    free(next->dropped);
    next->dropped = mem_strdup(paths[0]);
}

static void set_callbacks(struct window *window) {
    glfwSetWindowUserPointer(window->handle, window);
    glfwSetKeyCallback(window->handle, on_key);
    glfwSetCharCallback(window->handle, on_text);
    glfwSetMouseButtonCallback(window->handle, on_button);
    glfwSetScrollCallback(window->handle, on_scroll);
    glfwSetCursorPosCallback(window->handle, on_cursor);
    glfwSetWindowRefreshCallback(window->handle, on_refresh);
    glfwSetDropCallback(window->handle, on_drop);
}

/* Smaller, not even the times have room; a window that was asked to be smaller may stay so. */
static void limit_size(struct window *window) {
    enum { LEAST_WIDTH = 320, LEAST_HEIGHT = 240 };
    int width, height;
    glfwGetWindowSize(window->handle, &width, &height);
    glfwSetWindowSizeLimits(window->handle, width < LEAST_WIDTH ? width : LEAST_WIDTH,
                            height < LEAST_HEIGHT ? height : LEAST_HEIGHT, GLFW_DONT_CARE,
                            GLFW_DONT_CARE);
}

static float monitor_scale(void) {
    float x = 1, y = 1;
    GLFWmonitor *monitor = glfwGetPrimaryMonitor();
    if (monitor)
        glfwGetMonitorContentScale(monitor, &x, &y);
    return x;
}

struct window *window_create(const struct window_desc *desc) {
    glfwSetErrorCallback(on_error);
    if (!glfwInit()) {
        error_prefix("no window: is there a display? (manylight render needs none)");
        return NULL;
    }
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, desc->debug);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    struct window *window = mem_alloc(1, sizeof *window);
    window->scale = desc->scale;
    float scale = desc->scale > 0 ? desc->scale : monitor_scale();
    int width = desc->width + (int)((float)desc->margin * scale);
    window->handle = glfwCreateWindow(width, desc->height, desc->title, NULL, NULL);
    if (!window->handle) {
        error_prefix("no window with OpenGL 4.5");
        window_free(window);
        return NULL;
    }
    glfwMakeContextCurrent(window->handle);
    glfwSwapInterval(1);
    set_callbacks(window);
    limit_size(window);
    glfwGetCursorPos(window->handle, &window->next.x, &window->next.y);
    to_pixels(window->handle, &window->next.x, &window->next.y);
    return window;
}

void window_hide(struct window *window) {
    if (!window || !window->handle)
        return;
    glfwHideWindow(window->handle);
    glfwPollEvents();
}

void window_free(struct window *window) {
    if (!window)
        return;
    if (window->handle)
        glfwDestroyWindow(window->handle);
    glfwTerminate();
    mem_free(window->input.dropped, window->next.dropped);
    events_free(&window->events);
    free(window);
}

/* The hints are still those of the window that is there. */
struct window *window_create_hidden(void) {
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_FALSE);
    GLFWwindow *handle = glfwCreateWindow(1, 1, "", NULL, NULL);
    if (!handle)
        return NULL;
    struct window *window = mem_alloc(1, sizeof *window);
    window->handle = handle;
    return window;
}

void window_free_hidden(struct window *window) {
    if (window)
        glfwDestroyWindow(window->handle);
    free(window);
}

void window_bind(struct window *window) {
    glfwMakeContextCurrent(window->handle);
}

void window_unbind(void) {
    glfwMakeContextCurrent(NULL);
}

void *window_getproc(const char *name) {
    return (void *)glfwGetProcAddress(name);
}

void *window_native(struct window *window) {
    return window->handle;
}

/* --- a turn --- */

static void take_key(struct window *window, const struct event *event) {
    struct input *input = &window->next;
    int key = key_of(event->code);
    if (event->code >= 0 && event->code <= GLFW_KEY_LAST)
        window->down[event->code] = event->down;
    input->key_held[key] = event->down && !(event->modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_ALT));
    if (event->down && key)
        input->keys[input->key_count++] = key_with(key, event->modifiers);
}

static void take_button(struct input *input, const struct event *event) {
    input->held[event->code] = event->down;
    (event->down ? input->pressed : input->released)[event->code] = true;
    if (event->down) {
        input->press_x = input->x;
        input->press_y = input->y;
    }
}

static void take(struct window *window, const struct event *event) {
    struct input *input = &window->next;
    input->any = true;
    switch (event->kind) {
    case EVENT_KEY:
        take_key(window, event);
        break;
    case EVENT_TEXT:
        input->text[input->text_count++] = (unsigned)event->code;
        break;
    case EVENT_BUTTON:
        take_button(input, event);
        break;
    case EVENT_CURSOR:
        input->dx = event->x - input->x;
        input->dy = event->y - input->y;
        input->x = event->x;
        input->y = event->y;
        break;
    case EVENT_SCROLL:
        input->scroll = event->y;
        break;
    }
}

/* What is held goes on, what happened is over. */
static struct input next_of(const struct input *input) {
    struct input next = {
        .x = input->x, .y = input->y, .press_x = input->press_x, .press_y = input->press_y};
    memcpy(next.held, input->held, sizeof next.held);
    memcpy(next.key_held, input->key_held, sizeof next.key_held);
    return next;
}

static bool either(const struct window *window, int left, int right) {
    return window->down[left] || window->down[right];
}

/* What the system tells at any time. */
static void read_state(struct window *window, struct input *input) {
    GLFWwindow *handle = window->handle;
    float scale_y;
    glfwGetFramebufferSize(handle, &input->width, &input->height);
    glfwGetWindowContentScale(handle, &input->scale, &scale_y);
    if (window->scale > 0)
        input->scale = window->scale;
    if (glfwGetWindowAttrib(handle, GLFW_ICONIFIED))
        input->width = input->height = 0;
    input->inside = glfwGetWindowAttrib(handle, GLFW_HOVERED);
    input->close = glfwWindowShouldClose(handle);
}

const struct input *window_poll(struct window *window, double wait, bool holds) {
    if (wait > 0 && !holds && window->events.count == 0)
        glfwWaitEventsTimeout(wait);
    else
        glfwPollEvents();
    struct input *input = &window->next;
    int count = holds ? 0 : events_of_turn(&window->events);
    for (int i = 0; i < count; i++)
        take(window, &window->events.items[i]);
    events_drop(&window->events, count);
    read_state(window, input);
    input->shift = either(window, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
    input->control = either(window, GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
    input->alt = either(window, GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
#define TAKE_KEY(name, code) input->widget_keys[WIDGET_KEY_##name] = window->down[GLFW_KEY_##code];
    WIDGET_KEYS(TAKE_KEY)
#undef TAKE_KEY
    free(window->input.dropped);
    window->input = *input;
    *input = next_of(input);
    return &window->input;
}

void window_wake(void) {
    glfwPostEmptyEvent();
}

void window_swap(struct window *window) {
    glfwSwapBuffers(window->handle);
}

void window_set_title(struct window *window, const char *title) {
    glfwSetWindowTitle(window->handle, title);
}

void window_set_size(struct window *window, int width, int height) {
    int points, pixels, unused;
    glfwGetWindowSize(window->handle, &points, &unused);
    glfwGetFramebufferSize(window->handle, &pixels, &unused);
    if (pixels > 0)
        glfwSetWindowSize(window->handle, width * points / pixels, height * points / pixels);
}

bool window_is_full_screen(const struct window *window) {
    return glfwGetWindowMonitor(window->handle);
}

void window_toggle_full_screen(struct window *window) {
    if (window_is_full_screen(window)) {
        glfwSetWindowMonitor(window->handle, NULL, window->x, window->y, window->width,
                             window->height, GLFW_DONT_CARE);
        return;
    }
    GLFWmonitor *monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode *mode = monitor ? glfwGetVideoMode(monitor) : NULL;
    if (!mode)
        return;
    glfwGetWindowPos(window->handle, &window->x, &window->y);
    glfwGetWindowSize(window->handle, &window->width, &window->height);
    glfwSetWindowMonitor(window->handle, monitor, 0, 0, mode->width, mode->height,
                         mode->refreshRate);
}

void window_set_scale(struct window *window, float scale) {
    window->scale = scale;
}

void window_set_clipboard(struct window *window, const char *text) {
    glfwSetClipboardString(window->handle, text);
}

double window_time(void) {
    return glfwGetTime();
}
