/* Measures how far two pictures are apart by the metrics that look at neighbourhoods (FLIP), which
 * take their time, in the background. */
#ifndef VIEWER_MEASURING_H
#define VIEWER_MEASURING_H

#include "metrics/metric.h"

#include <pthread.h>
#include <stdatomic.h>

enum measuring_state { MEASURING_NONE, MEASURING_RUNS, MEASURING_DONE };

/* Zeroed: nothing is measured. */
struct measuring {
    pthread_t thread;
    atomic_int state; /* enum measuring_state */
    atomic_bool cancelled;
    struct image test, reference;
    int map_of;         /* of metrics, whose errors are wanted of each pixel, too; -1 = none */
    void (*wake)(void); /* called on the thread when it is done */

    /* Once it is done. */
    double values[METRIC_COUNT]; /* of those that measuring_is_slow tells */
    float *map;                  /* NULL = none; height x width */
};

bool measuring_is_slow(int metric);

/* In place of what is measured: copies of the pictures, of one size. Error: no thread. */
bool measuring_start(struct measuring *measuring, const struct comparison *comparison, int map_of,
                     void (*wake)(void));

/* Whether it is done, and has not been taken: then measuring_stop follows. */
bool measuring_has_news(struct measuring *measuring);

/* Lets it end after the metric at hand; whether there was something to end. */
bool measuring_cancel(struct measuring *measuring);

/* Waits for the metric at hand; all is freed. Accepts a zeroed one. */
void measuring_stop(struct measuring *measuring);

#endif
