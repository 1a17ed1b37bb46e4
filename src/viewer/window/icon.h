/* The window's icon, drawn: a lamp, and points of light on the floor and walls about it. */
#ifndef VIEWER_WINDOW_ICON_H
#define VIEWER_WINDOW_ICON_H

/* Fills size x size pixels of RGBA, rows from above. */
void icon_draw(unsigned char *rgba, int size);

#endif
