#include "measure/quality.h"

#include "base/log.h"
#include "base/memory.h"
#include "base/words.h"
#include "measure/estimate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *const quality_names[] = {"draft", "normal", "high", "final", NULL};

/* Of the VALs those that the light needs: eight in boxes, nearly all in halls. */
#define VALS_NEEDED "clustered.distortion=.085"

/* Each is on the front of error against CPU time in some of six scenes, and behind it in none of them by much
 * (bench/PARSIMONY.md). Cheapest first. */
static const struct quality_choice frames[] = {
    {"path=draft", 1},
    {"gather.detail=0 " VALS_NEEDED, 1},
    {VALS_NEEDED, 1},
    {"", 1},
    {"picture.samples=16", 1},
    {"gather.interleave=4 gather.detail=2", 1},
    {"path=fine", 1},
    {"gather.interleave=2 gather.detail=1 clustered.vals=60 picture.samples=16", 1},
    {"gather.interleave=2 gather.detail=1 clustered.vals=120 map.size=512 picture.samples=16", 1},
};

/* Fewer passes than that are worse than one of as much time. */
enum { FEWEST_PASSES = 4 };

struct quality_choice quality_named(enum quality quality) {
    /* As many passes as the final picture has bring a large scene below a tenth. */
    static const struct quality_choice qualities[] = {
        [QUALITY_DRAFT] = {"path=draft", 1},
        [QUALITY_NORMAL] = {"", 1},
        [QUALITY_HIGH] = {"path=fine", 1},
        [QUALITY_FINAL] = {"", 64},
    };
    return qualities[quality];
}

int quality_ladder(struct quality_choice choices[QUALITY_CHOICES_MAX], int most_passes) {
    int count = sizeof frames / sizeof *frames;
    struct quality_choice mean = quality_named(QUALITY_FINAL);
    memcpy(choices, frames, sizeof frames);
    for (mean.passes = FEWEST_PASSES; mean.passes <= most_passes; mean.passes *= 2)
        choices[count++] = mean;
    return count;
}

/* Half the error asked for adds an eighth to it, which is taken off; less than two percent takes longer than the
 * passes that would be saved. */
double quality_noise(double error) {
    return fmax(error / 2, .02);
}

char *quality_describe(const struct quality_choice *choice) {
    return choice->passes > 1 ? mem_printf("%d passes", choice->passes)
                              : mem_strdup(*choice->settings ? choice->settings : "the defaults");
}

static bool is_preset(const struct word *word) {
    return word->length > 5 && strncmp(word->at, "path=", 5) == 0;
}

bool quality_is_preset(const char *const *texts, int count) {
    for (int i = 0; i < count; i++)
        for (struct word word = {.at = texts[i]}; word_next(&word);)
            if (is_preset(&word))
                return true;
    return false;
}

bool quality_settings(const struct quality_choice *choice, const struct technique *technique,
                      const char *const *texts, int count, struct settings *settings) {
    const char *all[TEXT_LIST_MAX + 1] = {quality_is_preset(texts, count) ? "" : choice->settings};
    for (int i = 0; i < count; i++)
        all[i + 1] = texts[i];
    renderer_settings_init(settings);
    return renderer_settings_assign(settings, technique, all, count + 1) &&
           technique_check(technique, settings);
}

/* --- the ladder --- */

struct climb {
    const struct quality_desc *desc;
    struct measure_desc measure; /* with the settings of the choice at hand */
    struct estimate estimate;
    struct quality_found *best;
};

/* Takes the choice if it is better than the best so far; whether that is good enough. */
static bool take(struct climb *climb, const struct quality_choice *choice, double error) {
    char *what = quality_describe(choice);
    log_detail("%s errs %.1f %%", what, 100 * error);
    free(what);
    if (error < climb->best->error) {
        climb->best->choice = *choice;
        climb->best->error = error;
    }
    return climb->best->reached = climb->best->error <= climb->desc->error;
}

/* A technique need not have the preset, and what is given need not go with it: such a choice is none. */
static bool set(struct climb *climb, const struct quality_choice *choice) {
    const struct quality_desc *desc = climb->desc;
    return quality_settings(choice, climb->measure.technique, desc->texts, desc->text_count,
                            &climb->measure.settings);
}

static bool try_frame(struct climb *climb, const struct quality_choice *choice) {
    struct renderer renderer;
    double error = INFINITY;
    if (!measure_start(&renderer, &climb->measure))
        return false;
    renderer_render(&renderer);
    bool ok = estimate_error(&climb->estimate, &renderer, &error);
    renderer_free(&renderer);
    if (ok)
        take(climb, choice, error);
    return ok;
}

/* One mean that goes on: each number of passes adds to the one before. */
static bool try_passes(struct climb *climb) {
    struct renderer renderer;
    struct quality_choice choice = quality_named(QUALITY_FINAL);
    int done = 0;
    bool ok = measure_start(&renderer, &climb->measure), enough = false;
    if (!ok)
        return false;
    struct renderer_desc progressive = renderer.desc;
    progressive.progressive = true;
    ok = renderer_follow(&renderer, &progressive);
    for (choice.passes = FEWEST_PASSES; ok && !enough && choice.passes <= climb->desc->most_passes;
         choice.passes *= 2) {
        double error;
        while (done < choice.passes)
            renderer_add_pass(&renderer, done++);
        ok = estimate_error(&climb->estimate, &renderer, &error);
        enough = ok && take(climb, &choice, error);
    }
    renderer_free(&renderer);
    return ok;
}

/* Of a preset that is given there is one rung. */
static bool is_rung(struct climb *climb, const struct quality_choice *choice) {
    const struct quality_desc *desc = climb->desc;
    return (!*choice->settings || !quality_is_preset(desc->texts, desc->text_count)) &&
           set(climb, choice);
}

static bool climb_up(struct climb *climb) {
    struct quality_choice choices[QUALITY_CHOICES_MAX];
    const struct quality_choice final = quality_named(QUALITY_FINAL);
    int count = quality_ladder(choices, climb->desc->most_passes), i = 0;
    for (; i < count && choices[i].passes == 1 && !climb->best->reached; i++)
        if (is_rung(climb, &choices[i]) && !try_frame(climb, &choices[i]))
            return false;
    return climb->best->reached || i == count || (set(climb, &final) && try_passes(climb));
}

bool quality_find(const struct quality_desc *desc, struct quality_found *found) {
    const struct quality_choice normal = quality_named(QUALITY_NORMAL);
    struct climb climb = {.desc = desc, .measure = *desc->measure, .best = found};
    *found = (struct quality_found){normal, INFINITY, false};
    bool ok = set(&climb, &normal) &&
              estimate_init(&climb.estimate, &climb.measure, quality_noise(desc->error)) &&
              climb_up(&climb);
    estimate_free(&climb.estimate);
    return ok;
}
