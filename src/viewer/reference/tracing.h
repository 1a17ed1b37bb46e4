/* Traces the reference of the view in the background, and holds the picture against it as it gets
 * cleaner. */
#ifndef VIEWER_TRACING_H
#define VIEWER_TRACING_H

#include "viewer/state.h"

/* Traces the reference of the view as it is, in place of the one before; viewer_follow_reference
 * takes what has been traced, each turn; viewer_forget_reference ends the comparison with it. */
void viewer_trace(struct viewer *viewer);
void viewer_follow_reference(struct viewer *viewer);
void viewer_forget_reference(struct viewer *viewer);
bool viewer_is_tracing(const struct viewer *viewer);

/* Relative RMSE of the layer that is shown against the right picture, by the same definition: what
 * is known of a traced reference's noise, which is its indirect light's, is taken off. False: it
 * has not been measured. */
bool viewer_compared_error(const struct viewer *viewer, double *error);

/* That noise over the mean of the layer that is shown; 0: none is known. */
double viewer_reference_noise(const struct viewer *viewer);

/* Measures presets and techniques on the view, and traces its reference where there is none;
 * viewer_take_dot makes the picture as one of them. */
void viewer_chart(struct viewer *viewer);
bool viewer_is_charting(const struct viewer *viewer);
void viewer_take_dot(struct viewer *viewer, int i);

#endif
