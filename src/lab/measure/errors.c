#include "lab/measure/errors.h"

#include "base/error.h"
#include "metrics/layer.h"
#include "metrics/metric.h"

static const struct error_row {
    const char *metric, *layer, *unit;
    double scale;
} rows[] =
    {
        {"relative-rmse", "indirect", "%", 100}, {"relative-mae", "indirect", "%", 100},
        {"relative-bias", "indirect", "%", 100}, {"gradient", "indirect", "1", 1},
        {"ldr-flip", "beauty", "1", 1},
},
  ao_rows[] = {
      {"relative-rmse", "ao", "%", 100}, {"relative-mae", "ao", "%", 100},
      {"relative-bias", "ao", "%", 100}, {"gradient", "ao", "1", 1},
      {"ldr-flip", "ao", "1", 1},        {"rmse", "ao", "1", 1},
};

static bool add(struct results *results, const struct error_row *row, const struct image *test,
                const struct image *reference, const char *against) {
    struct image layers[2] = {{0}};
    struct comparison comparison = {.test = &layers[0],
                                    .reference = &layers[1],
                                    .pixels_per_degree = DEFAULT_PIXELS_PER_DEGREE};
    bool ok = (layer_extract(&layers[0], test, row->layer) || error_prefix("frame")) &&
              (layer_extract(&layers[1], reference, row->layer) || error_prefix("reference"));
    if (ok)
        results_add(results, row->metric, against, row->unit,
                    row->scale * metric_measure(metric_find(row->metric), &comparison, NULL));
    images_free(&layers[0], &layers[1]);
    return ok;
}

static bool add_all(struct results *results, const struct error_row *row, size_t count,
                    const struct image *test, const struct image *reference, const char *against) {
    for (size_t i = 0; i < count; i++)
        if (!add(results, &row[i], test, reference, against))
            return false;
    return true;
}

bool errors_add(struct results *results, const struct image *test, const struct image *reference,
                const char *against) {
    return add_all(results, rows, sizeof rows / sizeof *rows, test, reference, against);
}

bool errors_add_ao(struct results *results, const struct image *test, const struct image *reference,
                   const char *against) {
    return add_all(results, ao_rows, sizeof ao_rows / sizeof *ao_rows, test, reference, against);
}
