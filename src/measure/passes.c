#include "measure/passes.h"

#include "base/log.h"
#include "measure/errors.h"

#include <math.h>
#include <stdio.h>

/* What is shown now: the mean of so many passes. */
static bool add_mean(struct results *results, const struct measure_desc *desc,
                     struct renderer *renderer, int passes, const struct image *truth) {
    struct measure_desc point = *desc;
    struct image mean;
    double noise = 100 * truth_noise(truth);
    snprintf(point.point, sizeof point.point, "passes=%d", passes);
    if (!renderer_read_layers(renderer, &mean))
        return false;
    results_begin(results, &point);
    bool ok = errors_add(results, &mean, truth, truth_names[TRUTH_PATH]);
    double all = results_value(results, results->subject_count - 1, "relative-rmse", NULL);
    results_add(results, "noise", "", "%", noise);
    results_add(results, "error", truth_names[TRUTH_PATH], "%",
                sqrt(fmax(all * all - noise * noise, 0)));
    log_note("%s: %d passes, error %.2f %%", desc->stage->name, passes,
             results_value(results, results->subject_count - 1, "error", NULL));
    image_free(&mean);
    return ok;
}

bool passes_measure(struct results *results, const struct measure_desc *desc,
                    const struct truth_desc *truth, int count) {
    struct renderer renderer;
    struct image exact;
    if (!truth_get(truth, desc, &exact))
        return false;
    bool ok = measure_start_mean(&renderer, desc);
    if (ok) {
        for (int pass = 0, next = 1; ok && pass < count; pass++) {
            renderer_add_pass(&renderer, pass);
            if (pass + 1 < next)
                continue;
            ok = add_mean(results, desc, &renderer, next, &exact);
            next *= 2;
        }
        renderer_free(&renderer);
    }
    image_free(&exact);
    return ok;
}
