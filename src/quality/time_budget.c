#include "quality/time_budget.h"

#include "base/memory.h"

#include <math.h>

/* --- levels --- */

/* Between two rows, numbers go from one to the other by ratio; choices are the lower row's
 * (bench/FRONTS.md). */
static const struct row {
    int level;
    struct {
        int vpls, near_samples, rsm;
    } numbers;
    struct {
        int interleave, adaptive, samples;
    } choices;
} rows[] = {
    {0, {64, 64, 128}, {8, 0, 1}},      {6, {256, 256, 384}, {8, 0, 8}},
    {8, {256, 512, 512}, {8, 0, 12}},                                        /* near draft */
    {13, {512, 1024, 512}, {8, 4, 12}}, {15, {512, 1024, 512}, {8, 3, 12}},  /* the defaults */
    {21, {512, 1024, 512}, {8, 2, 12}}, {29, {1024, 1024, 512}, {8, 2, 16}}, /* near high */
    {30, {640, 1024, 512}, {4, 2, 16}}, {34, {1024, 1024, 512}, {4, 2, 16}},
    {35, {512, 1024, 512}, {2, 1, 16}}, {TIME_BUDGET_LEVELS - 1, {1024, 1024, 512}, {2, 1, 16}},
};

/* The last row that begins at the level or before, but the very last. */
static const struct row *row_of(int level) {
    const struct row *row = rows, *last = rows + sizeof rows / sizeof *rows - 2;
    while (row < last && row[1].level <= level)
        row++;
    return row;
}

static int between(int low, int high, double share) {
    return (int)lround(low * pow((double)high / low, share));
}

char *time_budget_settings(int level) {
    const struct row *a = row_of(level), *b = a + 1;
    double share = (double)(level - a->level) / (b->level - a->level);
    const struct row *lower = level >= b->level ? b : a;
    return mem_printf("lights.vpls=%d lights.rsm-size=%d gather.near-samples=%d "
                      "gather.interleave=%d gather.adaptive=%d gather.adaptive-factor=1 "
                      "picture.samples=%d",
                      between(a->numbers.vpls, b->numbers.vpls, share),
                      between(a->numbers.rsm, b->numbers.rsm, share),
                      between(a->numbers.near_samples, b->numbers.near_samples, share),
                      lower->choices.interleave, lower->choices.adaptive, lower->choices.samples);
}

/* --- the choice of one --- */

/* A frame may take so much more than the target, and so much less before a dearer level is tried;
 * logarithms of ratios. */
static const double above = .05, below = -.09;

/* What is aimed at, likewise. */
static const double aim = -.02;

/* Beyond that, one frame is enough to tell. */
static const double clear = .2;

/* By so much frames of a level must become faster before what was too slow is tried again. */
static const double changed = .15;

/* Of a level, as long as none has been measured; and between which bounds it may lie. */
static const double growth_usual = .06, growth_least = .02, growth_most = .25;

/* So far off, what had settled is looked for anew. */
static const double unsettled = .6;

enum {
    SEARCH_MOVES = 5,
    STEP_MOST = 24,
    STEP_SETTLED = 6,
    LEVEL_FIRST = 8,
    PATIENCE_FIRST = 12,
    PATIENCE_MOST = 400
};

static double clamped(double value, double least, double most) {
    return fmin(fmax(value, least), most);
}

void time_budget_init(struct time_budget *budget, double target) {
    *budget = (struct time_budget){.target = target,
                                   .level = LEVEL_FIRST,
                                   .before = -1,
                                   .growth = growth_usual,
                                   .too_slow = TIME_BUDGET_LEVELS,
                                   .patience = PATIENCE_FIRST};
}

/* The middle one of the last three; of fewer the last, as one frame in three may be disturbed. */
static double typical(const struct time_budget *budget) {
    const double *s = budget->samples;
    if (budget->count < TIME_BUDGET_SAMPLES)
        return s[budget->count - 1];
    return fmax(fmin(s[0], s[1]), fmin(fmax(s[0], s[1]), s[2]));
}

static double off_target(const struct time_budget *budget) {
    return log(typical(budget) / budget->target);
}

/* How dear a level is, from the last two that were measured. */
static void learn_growth(struct time_budget *budget, double ms) {
    if (budget->before < 0 || budget->level == budget->before)
        return;
    double growth = log(ms / budget->before_ms) / (budget->level - budget->before);
    budget->growth = clamped(growth, growth_least, growth_most);
}

/* What was too slow once need not be so for ever: scenes change. */
static void note_slow(struct time_budget *budget) {
    bool again = budget->level == budget->too_slow;
    int longer = 2 * budget->patience < PATIENCE_MOST ? 2 * budget->patience : PATIENCE_MOST;
    budget->patience = again ? longer : PATIENCE_FIRST;
    budget->wait = budget->patience;
    budget->too_slow = budget->level;
}

static void wait_for_slow(struct time_budget *budget) {
    if (budget->count == TIME_BUDGET_SAMPLES)
        budget->first_ms = typical(budget);
    bool faster =
        budget->count > TIME_BUDGET_SAMPLES && log(typical(budget) / budget->first_ms) < -changed;
    budget->wait = faster || budget->wait == 0 ? 0 : budget->wait - 1;
}

/* The level that takes what is aimed at, by the growth. */
static int wanted_level(const struct time_budget *budget) {
    int most = budget->settled ? STEP_SETTLED : STEP_MOST;
    double may_grow = (aim - off_target(budget)) / budget->growth;
    int level = budget->level, last = TIME_BUDGET_LEVELS - 1;
    while (level < last && level - budget->level < most && level + 1 - budget->level <= may_grow)
        level++;
    while (level > 0 && budget->level - level < most && level - budget->level > may_grow)
        level--;
    int top = budget->wait > 0 && budget->too_slow <= last ? budget->too_slow - 1 : last;
    level = level < top ? level : top;
    return level > 0 ? level : 0;
}

static bool is_within(double off) {
    return off <= above && off >= below;
}

/* It is looked for anew where all of the last frames were far off on one side. */
static void settle(struct time_budget *budget, double off) {
    bool far_above = true, far_below = true;
    for (int i = 0; i < TIME_BUDGET_SAMPLES; i++) {
        far_above &= log(budget->samples[i] / budget->target) > unsettled;
        far_below &= log(budget->samples[i] / budget->target) < -unsettled;
    }
    budget->settled = !far_above && !far_below && (budget->settled || is_within(off));
    if (far_above || far_below)
        budget->moves = 0;
}

bool time_budget_add(struct time_budget *budget, double ms) {
    budget->samples[budget->count++ % TIME_BUDGET_SAMPLES] = ms;
    if (budget->count == 1)
        learn_growth(budget, ms);
    wait_for_slow(budget);
    double off = off_target(budget);
    bool all = budget->count >= TIME_BUDGET_SAMPLES;
    bool clear_enough = all || (!budget->settled && fabs(off) > clear);
    if (all)
        settle(budget, off);
    if (is_within(off) || !clear_enough)
        return false;
    if (off > above)
        note_slow(budget);
    int level = wanted_level(budget);
    if (level == budget->level)
        return false;
    budget->before = budget->level;
    budget->before_ms = typical(budget);
    budget->level = level;
    budget->count = 0;
    budget->settled |= ++budget->moves >= SEARCH_MOVES;
    return true;
}

bool time_budget_holds(const struct time_budget *budget) {
    return budget->count > 0 &&
           (is_within(off_target(budget)) || wanted_level(budget) == budget->level);
}
