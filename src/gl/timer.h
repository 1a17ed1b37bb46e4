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

enum { TIMERS_MAX = 64, TIMER_PATH_SIZE = 80, TIMER_RING = 4, TIMER_DEPTH = 8 };

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
    int stack[TIMER_DEPTH], stack_size;
    double started[TIMERS_MAX], elapsed[TIMERS_MAX];
    struct timer_slot {
        GLuint queries[2 * TIMERS_MAX];
        int used[TIMERS_MAX]; /* timers recorded in this slot, by order of their end */
        int used_count;
        bool pending;
    } ring[TIMER_RING];
    int slot;
};

void timers_init(struct timers *timers, bool enabled, bool software);
void timers_free(struct timers *timers);

/* A frame begins with the first begin at depth 0 and ends with its end. The same path within one
 * frame may be timed once on a GPU; with finish its times add up. */
void timer_begin(struct timers *timers, const char *name);
void timer_end(struct timers *timers);

/* Waits until all recorded frames are in results. */
void timers_flush(struct timers *timers);

/* Milliseconds of the path, or 0. */
double timer_ms(const struct timers *timers, const char *path);

#endif
