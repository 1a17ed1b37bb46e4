/* Compares estimated errors with measured ones, and the choices by them with the cheapest possible
 * ones. */
#ifndef LAB_MEASURE_QUALITY_CHECK_H
#define LAB_MEASURE_QUALITY_CHECK_H

#include "lab/measure/results.h"
#include "quality/quality.h"

struct quality_check_desc {
    const struct measure_desc *measure; /* as quality_desc's, with settings */
    const char *const *texts;
    int text_count;
    const struct image *reference; /* of all pixels */
    int most_passes;
    bool estimates; /* only the ladder: each choice drawn once, and no times */
};

/* Draws each choice of the quality ladder, in the order in which the program comes, and fixed
 * settings and techniques beside it. Each is a subject, of variant "ladder" or "fixed". It has
 * "error", the relative RMSE of the indirect layer as far as pixels are covered, without the
 * reference's noise. It has "clock" and "cpu", and of the ladder "told", the estimated error.
 *
 * Then each error that may be asked for ("error=8%") is a subject of variant "automatic", with what
 * the ladder's choice has. Its "told" is the error that was estimated. "of-asked" is its error over
 * the one asked for. "of-fastest" is its CPU time over that of the fastest that errs no more. With
 * estimates alone, the variant is the camera, if one is named. Error: of a renderer or
 * the tracer. */
int quality_check_subjects(const struct quality_check_desc *desc); /* how many they are */
bool quality_check(struct results *results, const struct quality_check_desc *desc);

#endif
