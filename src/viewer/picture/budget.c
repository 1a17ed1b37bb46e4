#include "viewer/picture/budget.h"

#include <stdlib.h>

/* What the command line sets stays as it is. */
static void take_level(struct viewer *viewer) {
    struct settings *settings = &viewer->wish.settings;
    const struct text_list *given = viewer->desc.given;
    char *text = time_budget_settings(viewer->shown.budget.level);
    settings_assign(settings, text);
    for (int i = 0; given && i < given->count; i++)
        settings_assign(settings, given->items[i]);
    free(text);
    viewer->shown.is_new_level = true;
    viewer->shown.dirty = true;
}

void viewer_set_budget(struct viewer *viewer, float ms) {
    viewer->wish.budget = ms;
    time_budget_init(&viewer->shown.budget, (double)ms);
    if (ms > 0)
        take_level(viewer);
}

void viewer_follow_budget(struct viewer *viewer) {
    struct shown *shown = &viewer->shown;
    if (viewer->wish.budget <= 0 || shown->coarse)
        return;
    double ms = timer_ms(&shown->renderer.timers, "frame"); /* 0: not yet known */
    if (ms <= 0 || shown->is_new_level) {                   /* the first one compiles */
        shown->is_new_level &= ms <= 0;
        shown->dirty = true;
        return;
    }
    if (time_budget_add(&shown->budget, ms))
        take_level(viewer);
    shown->dirty |= !time_budget_holds(&shown->budget); /* at rest, too */
}
