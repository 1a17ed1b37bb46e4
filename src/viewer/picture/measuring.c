#include "viewer/picture/measuring.h"

#include "base/error.h"
#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

bool measuring_is_slow(int metric) {
    return !metrics[metric].pixel_error;
}

static void *run(void *context) {
    struct measuring *measuring = context;
    const struct comparison comparison = {
        .test = &measuring->test,
        .reference = &measuring->reference,
        .pixels_per_degree = (float)DEFAULT_PIXELS_PER_DEGREE,
    };
    for (int i = 0; i < METRIC_COUNT && !atomic_load(&measuring->cancelled); i++)
        if (measuring_is_slow(i))
            measuring->values[i] = metric_measure(&metrics[i], &comparison,
                                                  i == measuring->map_of ? measuring->map : NULL);
    atomic_store(&measuring->state, MEASURING_DONE);
    measuring->wake();
    return NULL;
}

static void forget(struct measuring *measuring) {
    images_free(&measuring->test, &measuring->reference);
    free(measuring->map);
    *measuring = (struct measuring){0};
}

bool measuring_start(struct measuring *measuring, const struct comparison *comparison, int map_of,
                     void (*wake)(void)) {
    const struct image *reference = comparison->reference;
    measuring_stop(measuring);
    measuring->test = image_copy(comparison->test);
    measuring->reference = image_copy(reference);
    measuring->map_of = map_of;
    if (map_of >= 0)
        measuring->map =
            mem_alloc((size_t)reference->width * (size_t)reference->height, sizeof *measuring->map);
    measuring->wake = wake;
    atomic_store(&measuring->state, MEASURING_RUNS);
    if (pthread_create(&measuring->thread, NULL, run, measuring) == 0)
        return true;
    forget(measuring);
    return error_set("no thread can be started to measure FLIP");
}

bool measuring_has_news(struct measuring *measuring) {
    return atomic_load(&measuring->state) == MEASURING_DONE;
}

bool measuring_cancel(struct measuring *measuring) {
    bool runs = atomic_load(&measuring->state) != MEASURING_NONE;
    if (runs)
        atomic_store(&measuring->cancelled, true);
    return runs;
}

void measuring_stop(struct measuring *measuring) {
    if (atomic_load(&measuring->state) == MEASURING_NONE)
        return;
    atomic_store(&measuring->cancelled, true);
    pthread_join(measuring->thread, NULL);
    forget(measuring);
}
