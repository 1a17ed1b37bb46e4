/* How fast frames come: times per pass over the last ones, and at which size to render while things
 * move. */
#ifndef VIEWER_PACE_H
#define VIEWER_PACE_H

#include "gl/timer.h"

#include <stdio.h>

enum { PACE_HISTORY = 240, PACE_MEDIAN = 15 };

struct pace {
    /* Frames that were rendered, oldest first. */
    float frame_ms[PACE_HISTORY];
    float frame_pixels[PACE_HISTORY];
    int frame_count;

    /* The last times of each timer, in a ring; in the order in which they run. */
    struct pace_pass {
        char path[TIMER_PATH_SIZE];
        int depth;
        bool idle; /* in the last frame */
        bool kept; /* and what it made before was used */
        float ms[PACE_MEDIAN];
        int count, next;
        float history[PACE_HISTORY]; /* of the frames above; 0 = it did not run */
    } passes[TIMERS_MAX];
    int pass_count;

    double shown[32]; /* when the last pictures were shown, in a ring */
    int shown_count;

    /* What a frame of the full size takes: a share that goes with the pixels, and one that does
     * not. */
    double fixed_ms, ms_per_pixel;
    double last_motion; /* time */
};

/* After each rendered frame of so many pixels. */
void pace_add(struct pace *pace, struct timers *timers, double pixels, double now);

/* Other passes. */
void pace_forget(struct pace *pace);

/* The same passes, but other times: of another size. */
void pace_begin_medians(struct pace *pace);

/* Median milliseconds of a pass over the last frames. */
float pace_median(const struct pace_pass *pass);

/* A line a frame, the oldest first: its pixels, and what it and each of its passes took. */
void pace_print_csv(const struct pace *pace, FILE *file);

/* Pictures per second; 0 while there are none. */
double pace_fps(const struct pace *pace, double now);

/* The share of width and height, 1 or less, at which a frame takes about so many milliseconds. */
double pace_scale(const struct pace *pace, double full_pixels, double target_ms);

#endif
