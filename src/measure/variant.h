/* Variants: named ways to draw a picture, compared in one run.
 *
 *     instant-radiosity                        a technique with its defaults
 *     paper                                    a preset of the default technique
 *     NAME:technique=clustered,vals=8          anything
 */
#ifndef MEASURE_VARIANT_H
#define MEASURE_VARIANT_H

#include "measure/measure.h"

/* Calls the desc so and sets what the variant stands for. Error: no such name or setting. */
bool variant_apply(struct measure_desc *desc, const char *text);

/* All that have names, for --help. */
void variants_print(FILE *out);

#endif
