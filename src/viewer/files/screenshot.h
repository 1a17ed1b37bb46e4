/* Writes what is shown to files, under names with free numbers: no file of the user is
 * overwritten. */
#ifndef VIEWER_SCREENSHOT_H
#define VIEWER_SCREENSHOT_H

#include "viewer/state.h"

enum { FREE_NUMBER_MOST = 999999 };

enum name_state { NAME_IS_FREE, NAME_IS_TAKEN, NAME_IS_REFUSED };

/* The first number from 1 on whose names are free. 0 and an error: all numbers are taken, or the
 * function has refused one with an error of its own. */
int free_number(enum name_state (*state_of)(void *user, int number), void *user);

/* What is shown, in its own size, as PNG and the like; the renderer's layers as EXR. */
bool viewer_write_picture(struct viewer *viewer, const char *path);

/* Writes what was traced, with all layers, as EXR under a fresh name in the working folder. */
void viewer_save_reference(struct viewer *viewer);

/* Writes both under a fresh name in the working folder, or shows why not. Error: the scene cannot
 * be drawn any more. */
bool viewer_take_screenshot(struct viewer *viewer);

#endif
