/* Keeps times per pass of the last frames, and chooses the size of frames while things move. */
#ifndef VIEWER_PACE_H
#define VIEWER_PACE_H

#include "gl/timer.h"

enum { PACE_HISTORY = 240, PACE_MEDIAN = 15 };

struct pace {
    /* Rendered frames, oldest first. */
    float frame_ms[PACE_HISTORY];
    float frame_pixels[PACE_HISTORY];
    int frame_count;

    /* The last times of each timer in a ring, in the order of passes. */
    struct pace_pass {
        char path[TIMER_PATH_SIZE];
        int depth;
        bool idle; /* did not run in the last frame */
        bool kept; /* its earlier result was used */
        float ms[PACE_MEDIAN];
        int count, next;
        float history[PACE_HISTORY]; /* ms of the frames above; 0: did not run */
    } passes[TIMERS_MAX];
    int pass_count;

    double shown[32]; /* times of the last shown pictures, in a ring, seconds */
    int shown_count;

    /* Time of a full-size frame: a part per pixel, and a fixed part. */
    double fixed_ms, ms_per_pixel;
    double last_motion; /* seconds */
};

/* Adds a rendered frame of `pixels` pixels at time `now`, seconds. */
void pace_add(struct pace *pace, struct timers *timers, double pixels, double now);

/* Forgets all passes, because other passes follow. */
void pace_forget(struct pace *pace);

/* Forgets the times, because frames have another size. */
void pace_begin_medians(struct pace *pace);

/* Returns the median time of a pass over the last frames, ms. */
float pace_median(const struct pace_pass *pass);

/* Returns pictures per second. 0: none yet. */
double pace_fps(const struct pace *pace, double now);

/* Returns the factor of width and height, at most 1, at which a frame takes about target_ms. */
double pace_scale(const struct pace *pace, double full_pixels, double target_ms);

#endif
