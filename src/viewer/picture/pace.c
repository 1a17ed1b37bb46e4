#include "viewer/picture/pace.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Passes whose cost goes with the lights; that of the others goes with the pixels. */
static bool goes_with_lights(const char *path) {
    static const char *const names[] = {"shadow map", "rsm",  "vpls", "near light",
                                        "clustering", "maps", "tree"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strstr(path, names[i]))
            return true;
    return false;
}

/* The pass of a timer, which is made after another one where it is new. */
static struct pace_pass *find_pass(struct pace *pace, const struct timer_result *result,
                                   const struct pace_pass *before) {
    struct pace_pass *pass = pace->passes, *end = pace->passes + pace->pass_count;
    while (pass < end && strcmp(pass->path, result->path) != 0)
        pass++;
    if (pass < end)
        return pass;
    pass = before ? pace->passes + (before - pace->passes) + 1 : pace->passes;
    memmove(pass + 1, pass, (size_t)(end - pass) * sizeof *pass);
    *pass = (struct pace_pass){.depth = result->depth};
    memcpy(pass->path, result->path, sizeof pass->path);
    pace->pass_count++;
    return pass;
}

static void add_time(struct pace *pace, struct pace_pass *pass, const struct timer_result *result) {
    pass->idle = result->ms <= 0;
    pass->kept = pass->idle && goes_with_lights(result->path);
    pass->history[pace->frame_count - 1] = (float)result->ms;
    if (pass->idle)
        return;
    pass->ms[pass->next] = (float)result->ms;
    pass->next = (pass->next + 1) % PACE_MEDIAN;
    pass->count += pass->count < PACE_MEDIAN;
}

static void forget_oldest(float history[PACE_HISTORY]) {
    memmove(history, history + 1, (PACE_HISTORY - 1) * sizeof *history);
    history[PACE_HISTORY - 1] = 0;
}

/* Room for a frame in all that is drawn over time. */
static void add_frame(struct pace *pace, float ms, float pixels) {
    bool full = pace->frame_count == PACE_HISTORY;
    if (full) {
        forget_oldest(pace->frame_ms);
        forget_oldest(pace->frame_pixels);
    }
    for (int i = 0; full && i < pace->pass_count; i++)
        forget_oldest(pace->passes[i].history);
    pace->frame_count += !full;
    pace->frame_ms[pace->frame_count - 1] = ms;
    pace->frame_pixels[pace->frame_count - 1] = pixels;
}

void pace_add(struct pace *pace, struct timers *timers, double pixels, double now) {
    double frame = timer_ms(timers, "frame"), by_pixel = 0;
    struct pace_pass *pass = NULL;
    add_frame(pace, (float)frame, (float)pixels);
    for (int i = 0; i < timers->count; i++) {
        pass = find_pass(pace, &timers->results[i], pass);
        add_time(pace, pass, &timers->results[i]);
        if (timers->results[i].depth == 1 && !goes_with_lights(timers->results[i].path))
            by_pixel += timers->results[i].ms;
    }
    pace->fixed_ms = fmax(frame - by_pixel, 0);
    pace->ms_per_pixel = by_pixel / pixels;
    int ring = sizeof pace->shown / sizeof *pace->shown;
    pace->shown[pace->shown_count++ % ring] = now;
}

void pace_forget(struct pace *pace) {
    pace->pass_count = 0;
}

void pace_begin_medians(struct pace *pace) {
    for (int i = 0; i < pace->pass_count; i++)
        pace->passes[i].count = pace->passes[i].next = 0;
}

static int ascending(const void *a, const void *b) {
    const float *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

float pace_median(const struct pace_pass *pass) {
    float sorted[PACE_MEDIAN];
    memcpy(sorted, pass->ms, sizeof sorted);
    qsort(sorted, (size_t)pass->count, sizeof *sorted, ascending);
    return pass->count ? sorted[(pass->count - 1) / 2] : 0;
}

double pace_fps(const struct pace *pace, double now) {
    int ring = sizeof pace->shown / sizeof *pace->shown, count = 0;
    double first = now;
    for (int i = 0; i < ring && i < pace->shown_count; i++)
        if (now - pace->shown[i] < 1.5) {
            count++;
            first = fmin(first, pace->shown[i]);
        }
    return count > 1 && now > first ? (count - 1) / (now - first) : 0;
}

double pace_scale(const struct pace *pace, double full_pixels, double target_ms) {
    double full_ms = pace->ms_per_pixel * full_pixels;
    /* Where the lights alone take longer than that, few pixels gain little. */
    double left = fmax(target_ms - pace->fixed_ms, fmax(target_ms, pace->fixed_ms) / 2);
    if (full_ms <= left)
        return 1;
    /* Few steps, so that the size does not change at every frame. */
    double scale = sqrt(left / full_ms);
    return scale > .5 ? .5 : scale > 1.0 / 3 ? 1.0 / 3 : .25;
}
