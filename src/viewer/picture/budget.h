/* Frames in the time that they may take: settings that are wanted follow the budget's level
 * (quality/time_budget.h). */
#ifndef VIEWER_BUDGET_H
#define VIEWER_BUDGET_H

#include "viewer/state.h"

/* What a frame may take, ms: settings then follow from how long frames took; 0: they stay as they
 * are. */
void viewer_set_budget(struct viewer *viewer, float ms);

/* After each frame. */
void viewer_follow_budget(struct viewer *viewer);

#endif
