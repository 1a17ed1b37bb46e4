/* Drops a file on a window, as a file manager does: the source's side of XDND 5. */
#ifndef TEST_XDND_H
#define TEST_XDND_H

#include <stdbool.h>

/* The window is an X11 one, of the display that DISPLAY names. False: it did not take the file
 * within some seconds. */
bool xdnd_drop(unsigned long window, const char *path);

#endif
