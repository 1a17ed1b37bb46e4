/* Traces the reference of a view in the background, on spare threads and with its own scene, so
 * that the viewer may open another. */
#ifndef VIEWER_REFERENCE_TRACER_H
#define VIEWER_REFERENCE_TRACER_H

#include "base/image.h"
#include "viewer/scene/session.h"

#include <pthread.h>
#include <stdatomic.h>

enum reference_tracer_state { TRACER_NONE, TRACER_TRACING, TRACER_DONE, TRACER_FAILED };

/* The picture traced so far */
struct traced_picture {
    struct image image;
    int samples;  /* per pixel */
    double noise; /* standard error of the indirect layer, RMS over mean */
};

/* A tracer. Zeroed: nothing is traced. */
struct reference_tracer {
    pthread_t thread;
    atomic_int state; /* enum reference_tracer_state */
    atomic_bool cancelled;
    char *scene;
    float punctual_scale;
    struct session session; /* the view */
    int bounces;
    double noise;       /* target: relative standard error of the indirect layer */
    void (*wake)(void); /* called on the thread on news */

    pthread_mutex_t lock; /* guards the members below */
    pthread_cond_t resumed;
    bool paused;
    struct traced_picture newest; /* not taken yet; without pixels: none */
    char message[512];
};

/* A view to trace, at the session's size */
struct traced_view {
    const struct session *session;
    int bounces;
    double noise;
    void (*wake)(void);
    float punctual_scale; /* of the opened scene */
};

/* Traces a view in place of the one before. Error: no thread. */
bool reference_tracer_start(struct reference_tracer *tracer, const struct traced_view *view);

/* Ends the tracing and waits some milliseconds for it. Accepts a zeroed tracer. */
void reference_tracer_stop(struct reference_tracer *tracer);

/* Returns true if reference_tracer_poll has news. */
bool reference_tracer_has_news(struct reference_tracer *tracer);

/* Pauses or resumes. While paused, only begun rows are traced, so that times of frames are
 * right. */
void reference_tracer_pause(struct reference_tracer *tracer, bool paused);

/* Moves the newest picture to the caller; without pixels: none since the last call. Returns the
 * state; TRACER_DONE and TRACER_FAILED once, the latter with an error. */
enum reference_tracer_state reference_tracer_poll(struct reference_tracer *tracer,
                                                  struct traced_picture *newest);

#endif
