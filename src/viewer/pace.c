#include "viewer/pace.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Passes whose cost goes with the lights; that of the others goes with the pixels. */
static bool goes_with_lights(const char *path) {
    static const char *const names[] = {"shadow map", "rsm",        "vpls",
                                        "near light", "clustering", "maps"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strstr(path, names[i]))
            return true;
    return false;
}

static void add_pass(struct pace *pace, const struct timer_result *result) {
    struct pace_pass *pass = pace->passes;
    while (pass < pace->passes + pace->pass_count && strcmp(pass->path, result->path) != 0)
        pass++;
    if (pass == pace->passes + pace->pass_count) {
        *pass = (struct pace_pass){.depth = result->depth};
        memcpy(pass->path, result->path, sizeof pass->path);
        pace->pass_count++;
    }
    pass->idle = result->ms <= 0;
    pass->kept = pass->idle && goes_with_lights(result->path);
    if (pass->idle)
        return;
    pass->ms[pass->next] = (float)result->ms;
    pass->next = (pass->next + 1) % PACE_MEDIAN;
    pass->count += pass->count < PACE_MEDIAN;
}

void pace_add(struct pace *pace, struct timers *timers, double pixels, double now) {
    double frame = timer_ms(timers, "frame"), by_pixel = 0;
    for (int i = 0; i < timers->count; i++) {
        add_pass(pace, &timers->results[i]);
        if (timers->results[i].depth == 1 && !goes_with_lights(timers->results[i].path))
            by_pixel += timers->results[i].ms;
    }
    pace->fixed_ms = fmax(frame - by_pixel, 0);
    pace->ms_per_pixel = by_pixel / pixels;
    if (pace->frame_count == PACE_HISTORY)
        memmove(pace->frame_ms, pace->frame_ms + 1, (PACE_HISTORY - 1) * sizeof *pace->frame_ms);
    else
        pace->frame_count++;
    pace->frame_ms[pace->frame_count - 1] = (float)frame;
    int ring = sizeof pace->shown / sizeof *pace->shown;
    pace->shown[pace->shown_count++ % ring] = now;
}

void pace_forget(struct pace *pace) {
    pace->pass_count = 0;
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
