/* Errors of pictures that differ by one thing each. */
#ifndef LAB_MEASURE_ACCURACY_H
#define LAB_MEASURE_ACCURACY_H

#include "lab/measure/results.h"
#include "lab/measure/reference.h"

/* What errors are against. */
#define AGAINST_BEFORE "step before"
#define AGAINST_REFERENCE "reference"
#define AGAINST_CENTERS "pixel centres"
#define AGAINST_RAYS "rays from the VPLs"

/* Measures where the error of a frame comes from, by single steps from the reference to the frame.
 * Adds a subject for each step, named by the step, with its errors against the reference and
 * against the step before. The last step before antialiasing also has errors against pixel centres;
 * the first has the reference's "noise". desc: size and settings of all steps. Error: of the
 * reference or a picture. */
int budget_subjects(void); /* how many they are */
bool budget_measure(struct results *results, const struct measure_desc *desc,
                    const struct reference_desc *reference);

/* Errors along one setting at a time, as in the paper's Fig. 10: M, K and the size of maps against
 * ray-traced visibility from the same VPLs, N against the reference through pixel centres. Adds a
 * subject for each value of each curve: the curve's name is the variant, "vals=8" the point. */
int curves_subjects(const struct measure_desc *desc); /* how many they are */
bool curves_measure(struct results *results, const struct measure_desc *desc,
                    const struct reference_desc *reference);

#endif
