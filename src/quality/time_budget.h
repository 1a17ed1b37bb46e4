/* Settings that take the time there is: from how long frames took, those of the next.
 *
 * Between fewest and most lie levels. Each is a few percent dearer than the one before. Levels are interpolated between
 * rows of settings on the front of error against time (bench/PARSIMONY.md, bench/FRONTS.md). Frames are drawn at one of them, and their times choose the next: the machine decides, not the
 * scene alone.
 */
#ifndef QUALITY_TIME_BUDGET_H
#define QUALITY_TIME_BUDGET_H

#include "renderer/settings.h"

enum { TIME_BUDGET_LEVELS = 41, TIME_BUDGET_SAMPLES = 3 };

struct time_budget {
    double target;                       /* ms */
    int level;                           /* of the next frame */
    double samples[TIME_BUDGET_SAMPLES]; /* of this level, ms: the last ones, in a ring */
    int count;                           /* of them, ever */
    int before;                          /* the level before; -1: there was none */
    double before_ms;
    double growth; /* of time, a level: natural logarithm */
    bool settled; /* a level holds, or none is found: from now on times are believed less readily */
    int moves;    /* from level to level, before that */
    double first_ms; /* of this level, as it was when it had been drawn so often */
    /* The last level that took too long, which is not tried again while there is something to wait for: frames,
     * more each time, or until they become faster. */
    int too_slow, patience, wait;
};

/* Starts at the draft's level; target in ms. */
void time_budget_init(struct time_budget *budget, double target);

/* After a frame of the level, which took so long. Whether the level is another one now. */
bool time_budget_add(struct time_budget *budget, double ms);

/* Whether frames of this level take what they may, or no level comes nearer. */
bool time_budget_holds(const struct time_budget *budget);

/* The level's settings, as renderer_settings_assign has them; the caller frees the text. */
char *time_budget_settings(int level);

#endif
