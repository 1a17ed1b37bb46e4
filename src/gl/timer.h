/* Named, nested times of the passes of a frame.
 *
 * On a GPU: 64-bit timestamp queries in a ring of frames, read when they are ready, never a stall.
 * On software GL timer queries lie (llvmpipe defers the work), so there each timer is bracketed by
 * glFinish and the monotonic clock; that costs what the pipeline would have overlapped.
 */
#ifndef GL_TIMER_H
#define GL_TIMER_H

#include "gl/api.h"

#include <stdbool.h>

enum {
    TIMERS_MAX = 64,
    TIMER_PATH_SIZE = 80,
    TIMER_RING = 4,
    TIMER_DEPTH = 8,
    TIMER_SPANS_MAX = 512, /* begins and ends of one frame */
};

struct timer_result {
    char path[TIMER_PATH_SIZE]; /* "frame/clustered/basis" */
    int depth;                  /* 0 = the frame */
    double ms;                  /* of the last frame that has been read */
};

struct timers {
    bool enabled; /* else begin and end only mark debug groups */
    bool finish;  /* glFinish and clock, for software GL */
    struct timer_result results[TIMERS_MAX];
    int count;

    /* The frame being recorded. */
    struct timer_open {
        int timer, span;
    } stack[TIMER_DEPTH];
    int stack_size;
    double started[TIMERS_MAX], elapsed[TIMERS_MAX];
    struct timer_slot {
        GLuint queries[2 * TIMER_SPANS_MAX]; /* begin and end of each span */
        int timer_of[TIMER_SPANS_MAX];
        int span_count; /* in the order of their begins: the frame is the first */
        bool pending;
    } ring[TIMER_RING];
    int slot;
};

void timers_init(struct timers *timers, bool enabled, bool software);
void timers_free(struct timers *timers);

/* A frame begins with the first begin at depth 0 and ends with its end. Times of the same path
 * within one frame add up. What begins after TIMER_SPANS_MAX others goes untimed on a GPU. */
void timer_begin(struct timers *timers, const char *name);
void timer_end(struct timers *timers);

/* Waits until all recorded frames are in results. */
void timers_flush(struct timers *timers);

/* Milliseconds of the path, or 0. */
double timer_ms(const struct timers *timers, const char *path);

#endif
