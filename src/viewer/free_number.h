/* Numbers names of new files, so that no file of the user's is overwritten. */
#ifndef VIEWER_FREE_NUMBER_H
#define VIEWER_FREE_NUMBER_H

enum { FREE_NUMBER_MOST = 999999 };

enum name_state { NAME_IS_FREE, NAME_IS_TAKEN, NAME_IS_REFUSED };

/* The first number from 1 on whose names are free. 0 and an error: all numbers are taken, or the function has refused
 * one with an error of its own. */
int free_number(enum name_state (*state_of)(void *user, int number), void *user);

#endif
