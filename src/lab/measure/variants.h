/* Lists of subjects: variants of a picture, and grids of settings over them. */
#ifndef LAB_MEASURE_VARIANTS_H
#define LAB_MEASURE_VARIANTS_H

#include "quality/measure.h"

/* Calls the desc by a variant's name and sets what that stands for:
 *
 *     instant-radiosity                        a technique with its defaults
 *     paper                                    a preset of the default technique
 *     NAME:technique=clustered,vals=8          anything
 *
 * Error: no such name or setting. */
bool variant_apply(struct measure_desc *desc, const char *text);

/* All that have names, for --help. */
void variants_print(FILE *out);

/* Zeroed: empty. free(items) frees. */
struct measure_list {
    struct measure_desc *items;
    int count;
};

void measure_list_add(struct measure_list *list, const struct measure_desc *desc);

/* Replaces each subject of the list by one for each value of a setting, "KEY=VALUE,VALUE...":
 *
 *     vals=2..120                        powers of two from 2, and 120
 *     vals=2,8,30                        these
 *     technique=clustered,unshadowed     so do size (400x400) and direct
 *
 * N, M and K stand for vpls, vals and terms. Numbers are appended to the subject's point, names to
 * its variant. Error: no such setting, a value out of its range, or too much for a name. */
bool measure_vary(struct measure_list *list, const char *text);

#endif
