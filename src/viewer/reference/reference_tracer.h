/* Traces the reference of a view in the background: the path tracer on spare threads, with a scene
 * of its own, so that the viewer may go on to another. */
#ifndef VIEWER_REFERENCE_TRACER_H
#define VIEWER_REFERENCE_TRACER_H

#include "base/image.h"
#include "viewer/scene/session.h"

#include <pthread.h>
#include <stdatomic.h>

enum reference_tracer_state { TRACER_NONE, TRACER_TRACING, TRACER_DONE, TRACER_FAILED };

/* So far. */
struct traced_picture {
    struct image image;
    int samples;  /* a pixel */
    double noise; /* standard error of the indirect layer, RMS over mean */
};

/* Zeroed: nothing is traced. */
struct reference_tracer {
    pthread_t thread;
    atomic_int state; /* enum reference_tracer_state */
    atomic_bool cancelled;
    char *scene;
    float punctual_scale;
    struct session session; /* the view */
    int bounces;
    double noise;       /* to be reached */
    void (*wake)(void); /* called on the thread when there is something new */

    pthread_mutex_t lock; /* of all that follows */
    pthread_cond_t resumed;
    bool paused;
    struct traced_picture newest; /* that nobody has taken yet, or none */
    char message[512];
};

/* What to trace: a view, in the session's size. */
struct traced_view {
    const struct session *session;
    int bounces;
    double noise;
    void (*wake)(void);
    float punctual_scale; /* that the scene was opened with */
};

/* In place of what is traced. Error: no thread. */
bool reference_tracer_start(struct reference_tracer *tracer, const struct traced_view *view);

/* Ends what is traced, and waits for that: some milliseconds. Accepts a zeroed one. */
void reference_tracer_stop(struct reference_tracer *tracer);

/* Whether reference_tracer_poll has something to tell. */
bool reference_tracer_has_news(struct reference_tracer *tracer);

/* While times are taken nothing is to be traced but the rows that are begun. */
void reference_tracer_pause(struct reference_tracer *tracer, bool paused);

/* The newest picture is then the caller's; without pixels: there is none since the last call.
 * TRACER_DONE and TRACER_FAILED are returned once; of the latter error_get tells. */
enum reference_tracer_state reference_tracer_poll(struct reference_tracer *tracer,
                                                  struct traced_picture *newest);

#endif
