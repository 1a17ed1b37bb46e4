#include "lab/measure/baseline.h"

#include "base/clock.h"
#include "lab/measure/errors.h"
#include "quality/picture.h"
#include "scene/material.h"
#include "scene/medium.h"

#include <stdio.h>

/* Samples a pixel: from the fewest there are to where a technique's second is far behind. */
enum { COUNTS = BASELINE_SUBJECTS };
static const int sample_counts[COUNTS] = {1, 2, 4, 8, 16};

static bool trace(struct results *results, struct measure_desc *desc, int bounces, int samples,
                  const struct reference_desc *reference, const char *against,
                  const struct image *exact) {
    const struct material_settings *surface =
        settings_of(struct material_settings, &desc->settings, &material_part);
    struct image image;
    struct path_tracer_desc tracer = {
        .width = desc->width,
        .height = desc->height,
        .bounces = bounces,
        .samples = samples,
        .materials = surface->materials,
        .medium = medium_of(&desc->stage->scene, &desc->settings, desc->stage->geometry.radius),
        .centers = reference->kind == REFERENCE_CENTERS,
        .denoise = true};
    snprintf(desc->point, sizeof desc->point, "spp=%d", samples);
    results_tell_work(results, desc, 0);
    double clock = clock_ms(), cpu = clock_cpu_ms();
    if (!picture_trace_paths(desc->stage, &tracer, &image, NULL))
        return false;
    results_begin(results, desc);
    results_add(results, "clock", "", "ms", clock_ms() - clock);
    results_add(results, "cpu", "", "ms", clock_cpu_ms() - cpu);
    bool ok = errors_add(results, &image, exact, against);
    image_free(&image);
    return ok && results_commit(results);
}

bool baseline_measure(struct results *results, const struct measure_desc *desc,
                      const struct reference_desc *reference, const char *against) {
    struct measure_desc baseline = measure_default(desc->stage, desc->width, desc->height);
    struct image exact;
    settings_copy(&baseline.settings, &desc->settings, &material_part);
    settings_copy(&baseline.settings, &desc->settings, &medium_part);
    bool ok = reference_get(reference, desc, &exact);
    baseline.technique = NULL;
    snprintf(baseline.variant, sizeof baseline.variant, "denoised tracer");
    for (int i = 0; ok && i < COUNTS; i++)
        ok = trace(results, &baseline, measure_bounces(desc), sample_counts[i], reference, against,
                   &exact);
    image_free(&exact);
    return ok;
}

static void add_ratio(struct results *results, const char *name, const char *error) {
    int own = results->subject_count - 1, count = 0;
    const struct result *has = results_find(results, own, error, NULL);
    double cpu[COUNTS], errors[COUNTS];
    for (int i = 0; i < own && count < COUNTS; i++) {
        const struct subject *baseline = &results->subjects[i];
        if (baseline->desc.technique || !subject_is_beside(baseline, &results->subjects[own]))
            continue;
        cpu[count] = results_value(results, i, "cpu", NULL);
        errors[count++] = results_value(results, i, error, NULL);
    }
    if (count > 0 && has)
        results_add(results, name, "", "x",
                    log_interpolate(cpu, errors, count, has->figure.value) /
                        results_value(results, own, "cpu", NULL));
}

void baseline_add_ratios(struct results *results) {
    if (!gl.software)
        return;
    add_ratio(results, "baseline-at-rmse", "relative-rmse");
    add_ratio(results, "baseline-at-flip", "ldr-flip");
}
