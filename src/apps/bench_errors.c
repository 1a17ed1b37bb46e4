#include "apps/bench_errors.h"

#include "base/error.h"
#include "metrics/layer.h"
#include "metrics/metric.h"

/* A metric that is named here exists. */
static double measure(const char *metric, const struct image *test, const struct image *reference) {
    return metric_measure(metric_find(metric),
                          &(struct comparison){.test = test,
                                               .reference = reference,
                                               .pixels_per_degree = DEFAULT_PIXELS_PER_DEGREE},
                          NULL);
}

static bool extract(const struct image *test, const struct image *reference, const char *layer,
                    struct image layers[2]) {
    return (layer_extract(&layers[0], test, layer) || error_prefix("frame")) &&
           (layer_extract(&layers[1], reference, layer) || error_prefix("reference"));
}

bool bench_errors_between(const struct image *test, const struct image *reference,
                          struct bench_errors *errors) {
    struct image indirect[2] = {{0}}, beauty[2] = {{0}};
    bool ok = extract(test, reference, "indirect", indirect) &&
              extract(test, reference, "beauty", beauty);
    if (ok)
        *errors = (struct bench_errors){
            .measured = true,
            .relative_rmse = measure("relative-rmse", &indirect[0], &indirect[1]),
            .relative_bias = measure("relative-bias", &indirect[0], &indirect[1]),
            .gradient = measure("gradient", &indirect[0], &indirect[1]),
            .ldr_flip = measure("ldr-flip", &beauty[0], &beauty[1]),
        };
    for (int i = 0; i < 2; i++) {
        image_free(&indirect[i]);
        image_free(&beauty[i]);
    }
    return ok;
}

bool bench_errors_of_frame(struct renderer *renderer, const struct image *reference,
                           struct bench_errors *errors) {
    struct image frame = {0};
    bool ok =
        renderer_read_layers(renderer, &frame) && bench_errors_between(&frame, reference, errors);
    image_free(&frame);
    return ok;
}
