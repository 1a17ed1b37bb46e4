/* Renders frames within --budget. */
#ifndef APPS_IN_TIME_H
#define APPS_IN_TIME_H

#include "base/option.h"
#include "quality/time_budget.h"
#include "renderer/stage.h"

struct in_time {
    struct time_budget budget;
    const struct text_list *texts; /* settings of --set, which override the budget */
    bool started;
    int level; /* of the renderer, if started */
};

/* Renders the stage, posed at `time` (seconds), at the budget's level, then chooses the next
 * level from the time it took. Repeats the first frame until it fits the budget. The renderer
 * draws the stage and has timers. Error: of settings or renderer; the caller must then free the
 * renderer. */
bool in_time_render(struct in_time *in_time, struct renderer *renderer, struct stage *stage,
                    double time);

/* Path-traces the stage in the time of one frame. Writes the samples per pixel if the picture
 * then errs less than the renderer's, else 0; also 0 if traced_is_possible refuses. Error: the
 * tracer's or the renderer's. */
bool in_time_trace(const struct in_time *in_time, struct renderer *renderer,
                   const struct stage *stage, struct image *picture, int *samples);

/* Describes the next frame: "level 31 of 40: lights.vpls=...". The caller frees the text. */
char *in_time_describe(const struct in_time *in_time);

#endif
