#include "apps/in_time.h"

#include "base/log.h"
#include "base/memory.h"
#include "quality/quality.h"
#include "techniques/many_lights.h"

#include <stdlib.h>

/* Frames that the first one may take. */
enum { TRIES = 16 };

/* Casters are those of time 0, whenever they are made. What is new compiles in its first frame, which tells no
 * time. */
static bool take_level(const struct in_time *in_time, struct renderer *renderer,
                       struct stage *stage, double time) {
    struct renderer_desc desc = renderer->desc;
    char *text = time_budget_settings(in_time->budget.level);
    struct quality_choice choice = QUALITY_FRAME(text);
    bool ok = quality_settings(&choice, desc.technique, in_time->texts->items,
                               in_time->texts->count, &desc.settings) &&
              stage_pose(stage, 0) && renderer_follow(renderer, &desc) && stage_pose(stage, time) &&
              stage_show(stage, renderer);
    free(text);
    if (ok)
        renderer_render(renderer);
    return ok;
}

static void render_once(struct in_time *in_time, struct renderer *renderer) {
    int level = in_time->budget.level;
    renderer_render(renderer);
    timers_flush(&renderer->timers);
    double ms = timer_ms(&renderer->timers, "frame");
    time_budget_add(&in_time->budget, ms);
    log_detail("level %d: %.1f ms", level, ms);
}

bool in_time_render(struct in_time *in_time, struct renderer *renderer, struct stage *stage,
                    double time) {
    int tries = in_time->started ? 1 : TRIES;
    time_budget_allow_rays(&in_time->budget,
                           many_lights_may_trace(&stage->scene, &stage->geometry));
    for (bool holds = false; !holds && tries > 0; tries--) {
        bool taken = in_time->started && in_time->level == in_time->budget.level;
        if (!taken && !take_level(in_time, renderer, stage, time))
            return false;
        in_time->started = true;
        in_time->level = in_time->budget.level;
        render_once(in_time, renderer);
        holds = in_time->level == in_time->budget.level && time_budget_holds(&in_time->budget);
    }
    return true;
}

char *in_time_describe(const struct in_time *in_time) {
    const struct time_budget *budget = &in_time->budget;
    char *settings = time_budget_settings(budget->level);
    char *text = mem_printf("level %d of %d: %s", budget->level, TIME_BUDGET_LEVELS - 1, settings);
    free(settings);
    return text;
}
