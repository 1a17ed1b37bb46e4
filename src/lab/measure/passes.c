#include "lab/measure/passes.h"

#include "lab/measure/errors.h"

#include <math.h>
#include <stdio.h>

static struct measure_desc point_of(const struct measure_desc *desc, int passes) {
    struct measure_desc point = *desc;
    snprintf(point.point, sizeof point.point, "passes=%d", passes);
    return point;
}

/* What is shown now: the mean of so many passes. */
static bool add_mean(struct results *results, const struct measure_desc *point,
                     struct renderer *renderer, const struct image *reference) {
    struct image mean;
    double noise = 100 * reference_noise(reference);
    if (!renderer_read_layers(renderer, &mean))
        return false;
    results_begin(results, point);
    bool ok = errors_add(results, &mean, reference, reference_names[REFERENCE_PATH]);
    double all = results_value(results, results->subject_count - 1, "relative-rmse", NULL);
    results_add(results, "noise", "", "%", noise);
    results_add(results, "error", reference_names[REFERENCE_PATH], "%",
                sqrt(fmax(all * all - noise * noise, 0)));
    image_free(&mean);
    return ok && results_commit(results);
}

int passes_subjects(int count) {
    int subjects = 0;
    for (int passes = 1; passes <= count; passes *= 2)
        subjects++;
    return subjects;
}

static bool add_means(struct results *results, const struct measure_desc *desc,
                      struct renderer *renderer, const struct image *reference, int count) {
    int next = 1, subjects = passes_subjects(count), added = 0;
    for (int pass = 1; next <= count; pass++) {
        struct measure_desc point = point_of(desc, next);
        renderer_add_pass(renderer, pass - 1);
        gl.Finish();
        results_tell_work(results, &point, (double)pass / count * subjects - added);
        if (pass < next)
            continue;
        if (!add_mean(results, &point, renderer, reference))
            return false;
        next *= 2;
        added++;
    }
    return true;
}

bool passes_measure(struct results *results, const struct measure_desc *desc,
                    const struct reference_desc *reference, int count) {
    struct renderer renderer;
    struct image exact;
    if (!reference_get(reference, desc, &exact))
        return false;
    bool ok = measure_start_mean(&renderer, desc);
    if (ok) {
        ok = add_means(results, desc, &renderer, &exact, count);
        renderer_free(&renderer);
    }
    image_free(&exact);
    return ok;
}
