/* Adapts settings to a time per frame, by the levels of quality/time_budget.h. */
#ifndef VIEWER_BUDGET_H
#define VIEWER_BUDGET_H

#include "viewer/state.h"

/* Sets the time per frame, ms. 0: settings stay as they are. */
void viewer_set_budget(struct viewer *viewer, float ms);

/* Chooses the next level from the times of the frame. Call it after each frame. */
void viewer_follow_budget(struct viewer *viewer);

#endif
