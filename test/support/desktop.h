/* What a desktop does to a window; Xvfb alone has none. Windows are X11's, of the display that
 * DISPLAY names. */
#ifndef TEST_DESKTOP_H
#define TEST_DESKTOP_H

#include <stdbool.h>
#include <stddef.h>

/* What is waited for at most, where it is sure to come on an idle machine at once: others may be at
 * work. */
enum { PATIENCE_MS = 120000 };

/* Drops a file, as a file manager does: the source's side of XDND 5. False: the window did not take
 * it. */
bool desktop_drop(unsigned long window, const char *path);

/* Minimises it, or shows it again, as a window manager does. */
bool desktop_minimise(unsigned long window, bool away);

/* Reads the window's minimum size from its hints. False: it has none. */
bool desktop_read_hints(unsigned long window, int *width, int *height);

/* The text that was copied last. False: there is none. */
bool desktop_read_clipboard(char *text, size_t size);

#endif
