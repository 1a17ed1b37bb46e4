/* Traces the reference of the view in the background and compares the picture with it as its
 * noise falls. */
#ifndef VIEWER_TRACING_H
#define VIEWER_TRACING_H

#include "viewer/state.h"

/* viewer_trace traces the present view in place of the reference before. viewer_follow_reference
 * takes new pictures; call it each turn. viewer_forget_reference ends the comparison. */
void viewer_trace(struct viewer *viewer);
void viewer_follow_reference(struct viewer *viewer);
void viewer_forget_reference(struct viewer *viewer);
bool viewer_is_tracing(const struct viewer *viewer);

/* Writes the relative RMSE of the shown layer against the right picture. Subtracts a traced
 * reference's noise, which is that of its indirect light. Returns false if it is not measured. */
bool viewer_compared_error(const struct viewer *viewer, double *error);

/* Returns that noise over the mean of the shown layer. 0: unknown. */
double viewer_reference_noise(const struct viewer *viewer);

/* viewer_measure measures presets and techniques on the view, and traces its reference if there is
 * none. viewer_take_row applies the settings of row i to the picture. */
void viewer_measure(struct viewer *viewer);
bool viewer_is_measuring(const struct viewer *viewer);
void viewer_take_row(struct viewer *viewer, int i);

#endif
