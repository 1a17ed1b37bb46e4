/* Writes the shown picture to files, under names with free numbers. No file of the user is
 * overwritten. */
#ifndef VIEWER_SCREENSHOT_H
#define VIEWER_SCREENSHOT_H

#include "viewer/state.h"

enum { FREE_NUMBER_MOST = 999999 };

enum name_state { NAME_IS_FREE, NAME_IS_TAKEN, NAME_IS_REFUSED };

/* Returns the first number from 1 on whose names are free, by state_of. Returns 0 and an error
 * if all are taken, or if state_of refuses one with its own error. */
int free_number(enum name_state (*state_of)(void *user, int number), void *user);

/* Writes the shown picture at its own size as PNG and the like, or the renderer's layers as EXR. */
bool viewer_write_picture(struct viewer *viewer, const char *path);

/* Writes the traced reference with all layers as EXR, under a free name in the working folder. */
void viewer_save_reference(struct viewer *viewer);

/* Writes picture and layers under a free name in the working folder, or shows why not. Error:
 * the scene cannot be drawn any more. */
bool viewer_take_screenshot(struct viewer *viewer);

#endif
