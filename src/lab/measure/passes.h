/* How the mean of passes converges. */
#ifndef LAB_MEASURE_PASSES_H
#define LAB_MEASURE_PASSES_H

#include "lab/measure/results.h"
#include "lab/measure/reference.h"

/* Adds a subject for each power of two up to `count` passes, whose point is "passes=K", with the
 * errors of the mean of K; "noise", the reference's; and "error", the relative RMSE of the indirect
 * layer without that noise, as squares. desc: what is drawn. Error: of the reference or the
 * renderer. */
int passes_subjects(int count); /* how many they are */
bool passes_measure(struct results *results, const struct measure_desc *desc,
                    const struct reference_desc *reference, int count);

#endif
