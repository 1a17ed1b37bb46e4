/* Draws the window's icon: a lamp, and points of light on the floor and walls around it. */
#ifndef VIEWER_WINDOW_ICON_H
#define VIEWER_WINDOW_ICON_H

/* Fills size x size pixels of RGBA, rows from above. */
void icon_draw(unsigned char *rgba, int size);

#endif
