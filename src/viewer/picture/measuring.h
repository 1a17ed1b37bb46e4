/* Measures the difference of two pictures in the background, by slow metrics of neighbourhoods
 * (FLIP). */
#ifndef VIEWER_MEASURING_H
#define VIEWER_MEASURING_H

#include "metrics/metric.h"

#include <pthread.h>
#include <stdatomic.h>

enum measuring_state { MEASURING_NONE, MEASURING_RUNS, MEASURING_DONE };

/* A measurement. Zeroed: none. */
struct measuring {
    pthread_t thread;
    atomic_int state; /* enum measuring_state */
    atomic_bool cancelled;
    struct image test, reference;
    int map_of;         /* index of the metric whose error per pixel is wanted; -1: none */
    void (*wake)(void); /* called on the thread at the end */

    /* Valid once it is done. */
    double values[METRIC_COUNT]; /* only of metrics with measuring_is_slow */
    float *map;                  /* error per pixel, height x width; NULL: none */
};

bool measuring_is_slow(int metric);

/* Copies both pictures, which have one size, and measures them in place of earlier ones. Error:
 * no thread. */
bool measuring_start(struct measuring *measuring, const struct comparison *comparison, int map_of,
                     void (*wake)(void));

/* Returns true if results wait; take them, then call measuring_stop. */
bool measuring_has_news(struct measuring *measuring);

/* Cancels after the current metric. Returns true if there was something to cancel. */
bool measuring_cancel(struct measuring *measuring);

/* Waits for the current metric and frees everything. Accepts a zeroed struct. */
void measuring_stop(struct measuring *measuring);

#endif
