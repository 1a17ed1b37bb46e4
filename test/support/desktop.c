#define _POSIX_C_SOURCE 199309L
#include "desktop.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <stdio.h>
#include <string.h>
#include <time.h>

struct source {
    Display *display;
    Window window, target;
    char list[1100]; /* text/uri-list */
};

static Atom atom(const struct source *source, const char *name) {
    return XInternAtom(source->display, name, False);
}

static void tell(const struct source *source, const char *type, long l1, long l2, long l4) {
    XEvent event = {.xclient = {.type = ClientMessage,
                                .window = source->target,
                                .message_type = atom(source, type),
                                .format = 32,
                                .data = {.l = {(long)source->window, l1, l2, CurrentTime, l4}}}};
    XSendEvent(source->display, source->target, False, NoEventMask, &event);
    XFlush(source->display);
}

/* The target asks for what is dropped. */
static void answer(const struct source *source, const XSelectionRequestEvent *request) {
    XChangeProperty(source->display, request->requestor, request->property, request->target, 8,
                    PropModeReplace, (const unsigned char *)source->list,
                    (int)strlen(source->list));
    XEvent event = {.xselection = {.type = SelectionNotify,
                                   .requestor = request->requestor,
                                   .selection = request->selection,
                                   .target = request->target,
                                   .property = request->property,
                                   .time = request->time}};
    XSendEvent(source->display, request->requestor, False, NoEventMask, &event);
    XFlush(source->display);
}

/* Serves the target until it sends a message of that type; false: it never does. */
static bool wait_for(const struct source *source, const char *type) {
    for (int i = 0; i < PATIENCE_MS / 10; i++) {
        while (XPending(source->display)) {
            XEvent event;
            XNextEvent(source->display, &event);
            if (event.type == SelectionRequest)
                answer(source, &event.xselectionrequest);
            if (event.type == ClientMessage && event.xclient.message_type == atom(source, type))
                return true;
        }
        nanosleep(&(struct timespec){0, 10000000}, NULL);
    }
    return false;
}

bool desktop_drop(unsigned long window, const char *path) {
    struct source source = {.display = XOpenDisplay(NULL), .target = window};
    if (!source.display)
        return false;
    enum { VERSION = 5 };
    Atom list = atom(&source, "text/uri-list"), copy = atom(&source, "XdndActionCopy");
    snprintf(source.list, sizeof source.list, "file://%s\r\n", path);
    source.window =
        XCreateSimpleWindow(source.display, DefaultRootWindow(source.display), 0, 0, 1, 1, 0, 0, 0);
    XSetSelectionOwner(source.display, atom(&source, "XdndSelection"), source.window, CurrentTime);
    tell(&source, "XdndEnter", VERSION << 24, (long)list, 0);
    tell(&source, "XdndPosition", 0, 100 << 16 | 100, (long)copy);
    bool ok = wait_for(&source, "XdndStatus");
    if (ok) {
        tell(&source, "XdndDrop", 0, CurrentTime, 0);
        ok = wait_for(&source, "XdndFinished");
    }
    XCloseDisplay(source.display);
    return ok;
}

/* ICCCM 4.1.3.1: the state is a property, and the window is unmapped. */
bool desktop_minimise(unsigned long window, bool away) {
    Display *display = XOpenDisplay(NULL);
    if (!display)
        return false;
    Atom state = XInternAtom(display, "WM_STATE", False);
    const long values[2] = {away ? IconicState : NormalState, None};
    XChangeProperty(display, window, state, state, 32, PropModeReplace,
                    (const unsigned char *)values, 2);
    if (away)
        XUnmapWindow(display, window);
    else
        XMapWindow(display, window);
    XCloseDisplay(display);
    return true;
}

bool desktop_read_hints(unsigned long window, int *width, int *height) {
    Display *display = XOpenDisplay(NULL);
    XSizeHints hints = {0};
    long supplied;
    if (!display)
        return false;
    bool ok = XGetWMNormalHints(display, window, &hints, &supplied) && hints.flags & PMinSize;
    *width = hints.min_width;
    *height = hints.min_height;
    XCloseDisplay(display);
    return ok;
}

bool desktop_read_clipboard(char *text, size_t size) {
    struct source reader = {.display = XOpenDisplay(NULL)};
    if (!reader.display)
        return false;
    Display *display = reader.display;
    Atom utf8 = atom(&reader, "UTF8_STRING"), property = atom(&reader, "MANYLIGHT_TEST");
    Window window = XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0);
    XConvertSelection(display, atom(&reader, "CLIPBOARD"), utf8, property, window, CurrentTime);
    XFlush(display);
    bool ok = false;
    for (int i = 0; i < PATIENCE_MS / 10 && !ok; i++) {
        XEvent event;
        ok = XCheckTypedWindowEvent(display, window, SelectionNotify, &event);
        nanosleep(&(struct timespec){0, 10000000}, NULL);
    }
    Atom type;
    int format;
    unsigned long count, left;
    unsigned char *data = NULL;
    ok = ok &&
         XGetWindowProperty(display, window, property, 0, (long)size / 4, True, AnyPropertyType,
                            &type, &format, &count, &left, &data) == Success &&
         data;
    snprintf(text, size, "%s", ok ? (char *)data : "");
    if (data)
        XFree(data);
    XCloseDisplay(display);
    return ok;
}
