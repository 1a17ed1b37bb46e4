/* Measures named, nested times of the passes of a frame.
 *
 * On a GPU: 64-bit timestamp queries in a ring of frames, read when ready, without a stall. Timer
 * queries of software OpenGL are wrong, because llvmpipe defers the work. There each timer is
 * bracketed by glFinish and the monotonic clock, which prevents overlap of passes. */
#ifndef GL_TIMER_H
#define GL_TIMER_H

#include "gl/api.h"

#include <stdbool.h>

enum {
    TIMERS_MAX = 64,
    TIMER_PATH_SIZE = 80,
    TIMER_RING = 4,
    TIMER_DEPTH = 8,
    TIMER_SPANS_MAX = 512, /* maximum of timed spans in a frame */
};

struct timer_result {
    char path[TIMER_PATH_SIZE]; /* "frame/maps/basis" */
    int depth;                  /* 0: the frame */
    double ms;                  /* time in the last frame that was read */
};

struct timers {
    bool enabled; /* false: begin and end only mark debug groups */
    bool finish;  /* uses glFinish and the clock, for software OpenGL */
    struct timer_result results[TIMERS_MAX];
    int count;

    /* Frame being recorded. */
    struct timer_open {
        int timer, span;
    } stack[TIMER_DEPTH];
    int stack_size;
    double started[TIMERS_MAX], elapsed[TIMERS_MAX];
    struct timer_slot {
        GLuint queries[2 * TIMER_SPANS_MAX]; /* begin and end of each span */
        int timer_of[TIMER_SPANS_MAX];
        int span_count; /* ordered by begin; the frame is first */
        bool pending;
    } ring[TIMER_RING];
    int slot;
};

void timers_init(struct timers *timers, bool enabled, bool software);
void timers_free(struct timers *timers);

/* Begin and end a timer. The outermost pair is the frame. Times of the same path within a frame are
 * summed. On a GPU, spans after the first TIMER_SPANS_MAX of a frame are not timed. */
void timer_begin(struct timers *timers, const char *name);
void timer_end(struct timers *timers);

/* Waits until all recorded frames are in results. */
void timers_flush(struct timers *timers);

/* Returns milliseconds of the path, or 0. */
double timer_ms(const struct timers *timers, const char *path);

#endif
