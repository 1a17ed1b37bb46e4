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
    /* What callbacks collect until the next poll. */
    struct input next;
    float scale;               /* that is asked for; 0 = the monitor's */
    int last_code;             /* the key pressed since the last poll, GLFW's code */
    double cursor_x, cursor_y; /* of the last event, in screen coordinates */
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

static void on_key(GLFWwindow *handle, int code, int scancode, int action, int modifiers) {
    (void)scancode;
    struct window *window = glfwGetWindowUserPointer(handle);
    struct input *next = &window->next;
    int key = key_of(code);
    next->any = true;
    next->key_held[key] = action != GLFW_RELEASE;
    if (action == GLFW_PRESS)
        window->last_code = code;
    if (action == GLFW_RELEASE && code == window->last_code && next->tap_count < INPUT_KEYS_MAX)
        next->taps[next->tap_count++] = code;
    if (action == GLFW_PRESS && key && next->key_count < INPUT_KEYS_MAX)
        next->keys[next->key_count++] = key_with(key, modifiers);
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

static bool was_pressed(const struct input *input) {
    for (int i = 0; i < BUTTON_COUNT; i++)
        if (input->pressed[i])
            return true;
    return false;
}

/* Since the last poll; a drag begins where the button was pressed. */
static void read_motion(const struct window *window, struct input *input) {
    bool pressed = was_pressed(input);
    glfwGetCursorPos(window->handle, &input->x, &input->y);
    to_pixels(window->handle, &input->x, &input->y);
    input->dx = input->x - (pressed ? input->press_x : window->input.x);
    input->dy = input->y - (pressed ? input->press_y : window->input.y);
}

static void on_button(GLFWwindow *handle, int button, int action, int modifiers) {
    (void)modifiers;
    struct window *window = glfwGetWindowUserPointer(handle);
    struct input *next = &window->next;
    if (button >= BUTTON_COUNT)
        return;
    next->any = true;
    next->held[button] = action == GLFW_PRESS;
    if (action == GLFW_PRESS) {
        /* Where the mouse was then, which glfwGetCursorPos does not know. */
        next->press_x = window->cursor_x;
        next->press_y = window->cursor_y;
        to_pixels(handle, &next->press_x, &next->press_y);
    }
    next->pressed[button] |= action == GLFW_PRESS;
    next->released[button] |= action == GLFW_RELEASE;
}

static void on_scroll(GLFWwindow *handle, double x, double y) {
    (void)x;
    struct input *next = &((struct window *)glfwGetWindowUserPointer(handle))->next;
    next->any = true;
    next->scroll += y;
}

static void on_cursor(GLFWwindow *handle, double x, double y) {
    struct window *window = glfwGetWindowUserPointer(handle);
    window->next.any = true;
    window->cursor_x = x;
    window->cursor_y = y;
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
    glfwSetMouseButtonCallback(window->handle, on_button);
    glfwSetScrollCallback(window->handle, on_scroll);
    glfwSetCursorPosCallback(window->handle, on_cursor);
    glfwSetWindowRefreshCallback(window->handle, on_refresh);
    glfwSetDropCallback(window->handle, on_drop);
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
    return window;
}

void window_free(struct window *window) {
    if (!window)
        return;
    if (window->handle)
        glfwDestroyWindow(window->handle);
    glfwTerminate();
    free(window->input.dropped);
    free(window->next.dropped);
    free(window);
}

void *window_getproc(const char *name) {
    return (void *)glfwGetProcAddress(name);
}

void *window_native(struct window *window) {
    return window->handle;
}

static bool either(GLFWwindow *handle, int left, int right) {
    return glfwGetKey(handle, left) == GLFW_PRESS || glfwGetKey(handle, right) == GLFW_PRESS;
}

const struct input *window_poll(struct window *window, double wait) {
    if (wait > 0)
        glfwWaitEventsTimeout(wait);
    else
        glfwPollEvents();
    struct input *input = &window->next;
    glfwGetFramebufferSize(window->handle, &input->width, &input->height);
    float scale_y;
    glfwGetWindowContentScale(window->handle, &input->scale, &scale_y);
    if (window->scale > 0)
        input->scale = window->scale;
    if (glfwGetWindowAttrib(window->handle, GLFW_ICONIFIED))
        input->width = input->height = 0;
    read_motion(window, input);
    input->shift = either(window->handle, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
    input->control = either(window->handle, GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
    input->alt = either(window->handle, GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
    input->close = glfwWindowShouldClose(window->handle);

    free(window->input.dropped);
    window->input = *input;
    for (int i = 0; i < BUTTON_COUNT; i++)
        window->input.held[i] |= input->pressed[i];
    window->last_code = GLFW_KEY_UNKNOWN;
    /* What is held goes on, what happened is over. */
    bool held[BUTTON_COUNT];
    memcpy(held, input->held, sizeof held);
    *input = (struct input){0};
    memcpy(input->held, held, sizeof input->held);
    input->press_x = window->input.press_x;
    input->press_y = window->input.press_y;
    memcpy(input->key_held, window->input.key_held, sizeof input->key_held);
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

void window_set_clipboard(struct window *window, const char *text) {
    glfwSetClipboardString(window->handle, text);
}

double window_time(void) {
    return glfwGetTime();
}
