#include "quality/quality.h"

#include "base/log.h"
#include "base/memory.h"
#include "base/words.h"
#include "quality/estimate.h"
#include "quality/traced.h"

#include <math.h>
#include <string.h>

const char *const quality_names[] = {"draft", "normal", "high", "final", NULL};

/* Cheapest first (bench/PARSIMONY.md). */
static const struct quality_choice frames[] = {
    QUALITY_FRAME("path=draft"),
    QUALITY_TRACED(8),
    QUALITY_FRAME("lights.vpls=128 gather.interleave=4 gather.adaptive=2"),
    QUALITY_FRAME(""),
    QUALITY_FRAME("gather.interleave=4 gather.adaptive=2"),
    {"picture.samples=16", 1, "cluster-lights", 0},
    QUALITY_FRAME("gather.interleave=2 gather.adaptive=1 picture.samples=16"),
    QUALITY_TRACED(16),
    QUALITY_FRAME("lights.vpls=1024 gather.interleave=2 gather.adaptive=1 picture.samples=16"),
    QUALITY_TRACED(64),
    QUALITY_TRACED(256),
};

/* Fewer passes than that are worse than one of as much time. */
enum { FEWEST_PASSES = 4 };

struct quality_choice quality_named(enum quality quality) {
    /* As many passes as the final picture has bring a large scene below a tenth. */
    static const struct quality_choice qualities[] = {
        [QUALITY_DRAFT] = QUALITY_FRAME("path=draft"),
        [QUALITY_NORMAL] = QUALITY_FRAME(""),
        [QUALITY_HIGH] = QUALITY_FRAME("path=high"),
        [QUALITY_FINAL] = {"", 64, NULL, 0},
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

char *quality_describe(const struct quality_choice *choice) {
    const char *settings = choice->settings, *technique = choice->technique;
    if (choice->passes > 1)
        return mem_printf("%d passes", choice->passes);
    if (choice->samples > 0)
        return mem_printf("%d path-traced samples, denoised", choice->samples);
    if (technique)
        return mem_printf("%s%s%s", technique, *settings ? " " : "", settings);
    return mem_strdup(*settings ? settings : "the defaults");
}

const struct technique *quality_technique(const struct quality_choice *choice,
                                          const struct technique *given) {
    return choice->technique ? technique_find(choice->technique) : given;
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
    const char *own = quality_is_preset(texts, count) ? "" : choice->settings;
    renderer_settings_init(settings);
    if (!renderer_settings_assign(settings, technique, &own, 1))
        return false;
    settings_forget_given(settings);
    return renderer_settings_assign(settings, technique, texts, count) &&
           technique_check(technique, settings);
}

/* --- the ladder --- */

/* What errs so much less is worth more time. */
static const double gain = .9;

struct climb {
    struct quality_choice choices[QUALITY_CHOICES_MAX];
    double errors[QUALITY_CHOICES_MAX]; /* of the first `tried` */
    int count, tried;
};

static double least_error(const struct climb *climb) {
    double least = INFINITY;
    for (int i = 0; i < climb->tried; i++)
        least = fmin(least, climb->errors[i]);
    return least;
}

/* Whether the mean that was estimated last errs hardly less than that of half its passes. */
static bool has_converged(const struct climb *climb) {
    int last = climb->tried - 1;
    return last > 0 && climb->choices[last - 1].passes > 1 &&
           climb->errors[last] > gain * climb->errors[last - 1];
}

static void settle(const struct climb *climb, double error, struct quality_found *found) {
    int last = climb->tried - 1, i = 0;
    double least = least_error(climb);
    found->reached = climb->errors[last] <= error;
    while (found->reached ? i < last : climb->errors[i] * gain > least)
        i++;
    found->choice = climb->choices[i];
    found->error = climb->errors[i];
}

bool quality_climb(double error, int most_passes, quality_teller *tell, void *user,
                   struct quality_found *found) {
    struct climb climb = {.tried = 0};
    bool ok = true, enough = false;
    climb.count = quality_ladder(climb.choices, most_passes);
    while (ok && !enough && climb.tried < climb.count) {
        const struct quality_choice *choice = &climb.choices[climb.tried];
        double *estimated = &climb.errors[climb.tried++];
        char *what = quality_describe(choice);
        ok = tell(user, choice, estimated);
        enough = *estimated <= error || has_converged(&climb);
        if (ok && !isinf(*estimated))
            log_note("%s errs %.1f %%", what, 100 * *estimated);
        free(what);
    }
    if (ok)
        settle(&climb, error, found);
    return ok;
}

/* --- telling by drawing --- */

struct draft {
    const struct quality_desc *desc;
    struct measure_desc measure;        /* with the settings of the choice at hand */
    struct estimate estimate, of_whole; /* of indirect light; of a picture, zeroed until needed */
    struct renderer mean;               /* of so many passes; zeroed before the first */
    int passes;
    struct image traced; /* with so many samples; zeroed before the first */
    int samples;
};

/* Means of passes take longer than paths that err as much, and are for where there are none. */
static bool takes_paths(const struct draft *draft, const struct quality_choice *choice) {
    bool traces = draft->desc->traces && traced_is_possible(&draft->measure);
    return choice->samples > 0 ? traces : choice->passes == 1 || !traces;
}

/* A technique need not have the preset, and what is given need not go with it. Of a preset that is
 * given there is one frame. */
static bool is_possible(struct draft *draft, const struct quality_choice *choice) {
    const struct quality_desc *desc = draft->desc;
    draft->measure.technique = quality_technique(choice, desc->measure->technique);
    return draft->measure.technique && (!choice->technique || desc->any_technique) &&
           (!*choice->settings || !quality_is_preset(desc->texts, desc->text_count)) &&
           quality_settings(choice, draft->measure.technique, desc->texts, desc->text_count,
                            &draft->measure.settings) &&
           takes_paths(draft, choice);
}

/* Direct and specular light have noise, too: the whole picture counts where it errs more. */
static bool tell_traced(struct draft *draft, int samples, double *error) {
    struct image *picture = &draft->traced;
    struct estimate *whole = &draft->of_whole;
    double asked = draft->desc->error, own = 0;
    image_free(picture);
    draft->samples = samples;
    bool ok = traced_render(&draft->measure, samples, false, NULL, picture) &&
              estimate_picture_error(&draft->estimate, picture, asked, error) &&
              (whole->layer || estimate_init(whole, &draft->measure, "")) &&
              estimate_picture_error(whole, picture, asked, &own);
    *error = fmax(*error, own);
    return ok;
}

static bool tell_frame(struct draft *draft, double *error) {
    struct renderer renderer;
    if (!measure_start(&renderer, &draft->measure))
        return false;
    renderer_render(&renderer);
    bool ok = estimate_error(&draft->estimate, &renderer, draft->desc->error, error);
    renderer_free(&renderer);
    return ok;
}

/* One mean that goes on: each number of passes adds to the one before. */
static bool tell_mean(struct draft *draft, int passes, double *error) {
    if (draft->passes == 0 && !measure_start_mean(&draft->mean, &draft->measure))
        return false;
    while (draft->passes < passes)
        renderer_add_pass(&draft->mean, draft->passes++);
    return estimate_error(&draft->estimate, &draft->mean, draft->desc->error, error);
}

static bool tell(void *user, const struct quality_choice *choice, double *error) {
    struct draft *draft = user;
    *error = INFINITY;
    return !is_possible(draft, choice) ||
           (choice->samples > 0  ? tell_traced(draft, choice->samples, error)
            : choice->passes > 1 ? tell_mean(draft, choice->passes, error)
                                 : tell_frame(draft, error));
}

bool quality_find(const struct quality_desc *desc, struct quality_found *found) {
    const struct quality_choice normal = quality_named(QUALITY_NORMAL);
    struct draft draft = {.desc = desc, .measure = *desc->measure};
    *found = (struct quality_found){.choice = normal, .error = INFINITY};
    bool ok = is_possible(&draft, &normal) &&
              estimate_init(&draft.estimate, &draft.measure, "indirect") &&
              quality_climb(desc->error, desc->most_passes, tell, &draft, found);
    if (ok && found->choice.samples == draft.samples)
        found->picture = draft.traced;
    else
        image_free(&draft.traced);
    renderer_free(&draft.mean);
    estimate_free(&draft.estimate);
    estimate_free(&draft.of_whole);
    return ok;
}
