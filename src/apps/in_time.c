#include "apps/in_time.h"

#include "base/clock.h"
#include "base/log.h"
#include "base/memory.h"
#include "quality/estimate.h"
#include "quality/quality.h"
#include "quality/traced.h"
#include "shared/composite.h"

#include <math.h>

/* Frames that the first one may take. */
enum { TRIES = 16 };

/* Casters are those of time 0, whenever they are made. What is new compiles in its first frame,
 * which tells no time. */
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

/* --- paths --- */

/* Samples of a pixel that a picture has at most. */
enum { TRACED_MOST = 256, TRACED_FEW = 4 };

static bool trace(const struct measure_desc *measure, bool hides_sky, int samples,
                  struct image *picture, double *ms) {
    double start = clock_ms();
    image_free(picture);
    bool ok = traced_render(measure, samples, hides_sky, NULL, picture);
    *ms = clock_ms() - start;
    return ok;
}

/* All samples but the first take alike. 0: not even that one is in time. */
static bool trace_in_time(const struct measure_desc *measure, bool hides_sky, double target,
                          struct image *picture, int *samples) {
    double one, few, all = 0;
    *samples = 0;
    if (!trace(measure, hides_sky, 1, picture, &one))
        return false;
    if (one > target)
        return true;
    if (!trace(measure, hides_sky, TRACED_FEW, picture, &few))
        return false;
    double each = fmax(fmin((few - one) / (TRACED_FEW - 1), few / TRACED_FEW), 1e-3);
    *samples = (int)fmin(1 + (target - one) / each, TRACED_MOST);
    return trace(measure, hides_sky, *samples, picture, &all);
}

static bool is_better(const struct measure_desc *measure, struct renderer *renderer,
                      const struct image *picture, bool *better) {
    struct estimate estimate;
    double frame, traced;
    bool ok = estimate_init(&estimate, measure, "") &&
              estimate_error(&estimate, renderer, INFINITY, &frame) &&
              estimate_picture_error(&estimate, picture, frame, &traced);
    *better = ok && traced < frame;
    if (ok)
        log_note("the frame errs %.1f %%, a path-traced picture %.1f %%", 100 * frame,
                 100 * traced);
    estimate_free(&estimate);
    return ok;
}

bool in_time_trace(const struct in_time *in_time, struct renderer *renderer,
                   const struct stage *stage, struct image *picture, int *samples) {
    const struct quality_choice given = QUALITY_FRAME("");
    struct measure_desc measure = measure_of(&renderer->desc, stage);
    bool hides_sky = renderer->desc.background.kind != BACKGROUND_SCENE, better = false;
    *samples = 0;
    bool ok = quality_settings(&given, measure.technique, in_time->texts->items,
                               in_time->texts->count, &measure.settings);
    if (ok && traced_is_possible(&measure))
        ok = trace_in_time(&measure, hides_sky, in_time->budget.target, picture, samples) &&
             (*samples == 0 || is_better(&measure, renderer, picture, &better));
    if (!better)
        *samples = 0;
    return ok;
}

char *in_time_describe(const struct in_time *in_time) {
    const struct time_budget *budget = &in_time->budget;
    char *settings = time_budget_settings(budget->level);
    char *text = mem_printf("level %d of %d: %s", budget->level, TIME_BUDGET_LEVELS - 1, settings);
    free(settings);
    return text;
}
