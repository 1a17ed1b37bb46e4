/* Frames in the time that they may take. */
#ifndef APPS_IN_TIME_H
#define APPS_IN_TIME_H

#include "base/option.h"
#include "quality/time_budget.h"
#include "renderer/stage.h"

struct in_time {
    struct time_budget budget;
    const struct text_list *texts; /* settings that are given, and win */
    bool started;
    int level; /* that the renderer has, where started */
};

/* Draws the stage, posed at that time, at the budget's level, and lets the budget choose the next
 * one's by how long that took. The first frame is drawn until it takes what it may. The renderer is
 * of the stage, and timed. Error: of the settings or the renderer, which must then be freed. */
bool in_time_render(struct in_time *in_time, struct renderer *renderer, struct stage *stage,
                    double time);

/* Path-traces the stage in the time of a frame, and gives the samples per pixel where the picture
 * then errs less than the renderer's; 0: it does not, or traced_is_possible says no. Error: the
 * tracer's or the renderer's. */
bool in_time_trace(const struct in_time *in_time, struct renderer *renderer,
                   const struct stage *stage, struct image *picture, int *samples);

/* "level 31 of 40: lights.vpls=...", of the next frame; the caller frees it. */
char *in_time_describe(const struct in_time *in_time);

#endif
