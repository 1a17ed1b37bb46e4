/* How far a picture is from the reference. */
#ifndef LAB_MEASURE_ERRORS_H
#define LAB_MEASURE_ERRORS_H

#include "base/image.h"
#include "lab/measure/results.h"

/* Adds relative-rmse, relative-mae, relative-bias (% of the reference's mean) and gradient of the
 * indirect layer, and ldr-flip of the picture: few wrong pixels make the first, many the second,
 * and the last says whether they are seen. against: what results call the reference. Error: a layer
 * is missing, or a value is not finite. */
bool errors_add(struct results *results, const struct image *test, const struct image *reference,
                const char *against);

/* The same of the layer ao, and its rmse. */
bool errors_add_ao(struct results *results, const struct image *test, const struct image *reference,
                   const char *against);

/* The columns of these errors, for the table of a results_print. */
#define ERROR_COLUMNS(against)                                                                     \
    {"rRMSE %", "relative-rmse", against}, {"rMAE %", "relative-mae", against},                    \
        {"bias %", "relative-bias", against}, {"gradient", "gradient", against}, {                 \
        "FLIP", "ldr-flip", against                                                                \
    }

#endif
