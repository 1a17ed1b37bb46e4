/* Measures errors of a picture against a reference. */
#ifndef LAB_MEASURE_ERRORS_H
#define LAB_MEASURE_ERRORS_H

#include "base/image.h"
#include "lab/measure/results.h"

/* Adds relative-rmse, relative-mae, relative-bias (% of the reference's mean) and gradient of the
 * indirect layer, and ldr-flip of the picture. Few wrong pixels raise RMSE, many raise MAE; FLIP
 * tells whether they are visible. against: name of the reference in the results. Error: a layer is
 * missing, or a value is not finite. */
bool errors_add(struct results *results, const struct image *test, const struct image *reference,
                const char *against);

/* Adds the same errors of the layer ao, and its rmse. */
bool errors_add_ao(struct results *results, const struct image *test, const struct image *reference,
                   const char *against);

/* Columns of these errors, for a table of results_print. */
#define ERROR_COLUMNS(against)                                                                     \
    {"rRMSE %", "relative-rmse", against}, {"rMAE %", "relative-mae", against},                    \
        {"bias %", "relative-bias", against}, {"gradient", "gradient", against}, {                 \
        "FLIP", "ldr-flip", against                                                                \
    }

#endif
