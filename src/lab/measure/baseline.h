/* The baseline on a CPU: the path tracer with few samples, denoised. Its error against
 * its time is a curve, and a technique is as good as the tracer takes long to err as little. */
#ifndef LAB_MEASURE_BASELINE_H
#define LAB_MEASURE_BASELINE_H

#include "lab/measure/results.h"
#include "lab/measure/reference.h"

/* Adds a subject without technique, "denoised tracer", in the desc's size for each of a few counts
 * of samples, whose point is "spp=4": "clock" and "cpu", from building the tree to the denoised
 * picture, and errors against the reference, which results call `against`. Error: of the tracer or
 * the reference. */
enum { BASELINE_SUBJECTS = 5 };
bool baseline_measure(struct results *results, const struct measure_desc *desc,
                      const struct reference_desc *reference, const char *against);

/* Adds to the last subject, where it has errors and the baseline was measured on its scene in its
 * size: "baseline-at-rmse" and "baseline-at-flip", the baseline's CPU time for the same relative
 * RMSE of the indirect layer, and for the same FLIP of the picture, over its own; 0 where the
 * fewest samples err less, infinity where the most err more. Not on a GPU: its time is not the
 * CPU's. */
void baseline_add_ratios(struct results *results);

#endif
