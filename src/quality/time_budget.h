/* Chooses the settings of the next frame by the times of the last frames, for a target time.
 *
 * Levels lead from the fewest to the most samples. Each is a few percent slower than the one
 * before. They are interpolated between rows of settings on the front of error against time
 * (bench/PARSIMONY.md, bench/FRONTS.md). Measured times choose the level, so it depends on scene
 * and machine. */
#ifndef QUALITY_TIME_BUDGET_H
#define QUALITY_TIME_BUDGET_H

#include "renderer/settings.h"

enum { TIME_BUDGET_LEVELS = 41, TIME_BUDGET_SAMPLES = 3 };

struct time_budget {
    double target;                       /* ms */
    int level;                           /* level of the next frame */
    double samples[TIME_BUDGET_SAMPLES]; /* last times of this level, ms, in a ring */
    int count;                           /* times of this level so far */
    int before;                          /* previous level; -1: none */
    double before_ms;                    /* typical time of the previous level */
    double growth;                       /* growth of time per level, natural logarithm */
    bool settled;    /* a level holds or the search ended; steps are smaller then */
    int moves;       /* changes of level before settled */
    double first_ms; /* typical time of the first TIME_BUDGET_SAMPLES frames of this level */
    /* The last level that was too slow. It is retried after `wait` more frames, or when frames
     * become faster. patience: the last whole wait, doubled if the level is too slow again. */
    int too_slow, patience, wait;
};

/* Starts at the level of quality draft. target: ms. */
void time_budget_init(struct time_budget *budget, double target);

/* Adds the time of a frame of the level. Returns true if the level changed. */
bool time_budget_add(struct time_budget *budget, double ms);

/* True if frames of this level are near the target, or no level is nearer. */
bool time_budget_holds(const struct time_budget *budget);

/* Returns the level's settings as text for renderer_settings_assign. The caller frees it. */
char *time_budget_settings(int level);

#endif
