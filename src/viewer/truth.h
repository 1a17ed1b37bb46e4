/* Traces the truth of a view in the background: the path tracer on spare threads, with a scene of its
 * own, so that the viewer may go on to another. */
#ifndef VIEWER_TRUTH_H
#define VIEWER_TRUTH_H

#include "base/image.h"
#include "viewer/session.h"

#include <pthread.h>
#include <stdatomic.h>

enum truth_state { TRUTH_NONE, TRUTH_TRACING, TRUTH_DONE, TRUTH_FAILED };

/* So far. */
struct truth_picture {
    struct image image;
    int samples;  /* a pixel */
    double noise; /* standard error of the indirect layer, RMS over mean */
};

/* Zeroed: nothing is traced. */
struct truth {
    pthread_t thread;
    atomic_int state; /* enum truth_state */
    atomic_bool cancelled;
    char *scene, *camera, *lights, *environment; /* the view */
    float turn, strength, time;
    char clip[CLIPS_TEXT_SIZE];
    int bounces, width, height;
    double noise;       /* to be reached */
    void (*wake)(void); /* called on the thread when there is something new */

    pthread_mutex_t lock; /* of all that follows */
    pthread_cond_t resumed;
    bool paused;
    struct truth_picture newest; /* that nobody has taken yet, or none */
    char message[512];
};

/* What to trace: a view, in the session's size. */
struct truth_view {
    const struct session *session;
    int bounces;
    double noise;
    void (*wake)(void);
};

/* In place of what is traced. Error: no thread. */
bool truth_start(struct truth *truth, const struct truth_view *view);

/* Ends what is traced, and waits for that: some milliseconds. Accepts a zeroed one. */
void truth_stop(struct truth *truth);

/* Whether truth_poll has something to tell. */
bool truth_has_news(struct truth *truth);

/* While times are taken nothing is to be traced but the rows that are begun. */
void truth_pause(struct truth *truth, bool paused);

/* The newest picture is then the caller's; without pixels: there is none since the last call.
 * TRUTH_DONE and TRUTH_FAILED are told once; of the latter error_get tells. */
enum truth_state truth_poll(struct truth *truth, struct truth_picture *newest);

#endif
