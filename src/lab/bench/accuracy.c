/* manylight bench budget, curves: the error of the frame, step by step on the way from the
 * reference, and against M, K, N and the size of maps. */
#include "lab/bench/bench.h"

#include "lab/measure/errors.h"
#include "lab/measure/baseline.h"
#include "quality/picture.h"

#include <stdio.h>
#include <stdlib.h>

/* Names of the pictures that errors are measured against. */
#define AGAINST_BEFORE "step before"
#define AGAINST_REFERENCE "reference"
#define AGAINST_CENTERS "pixel centres"
#define AGAINST_RAYS "rays from the VPLs"

/* Standards of comparison. BEFORE is drawn with each picture, the others once. */
enum { BEFORE, REFERENCE, CENTERS, RAYS, STANDARDS };

static const char *const standard_names[STANDARDS] = {AGAINST_BEFORE, AGAINST_REFERENCE,
                                                      AGAINST_CENTERS, AGAINST_RAYS};

struct step {
    const char *name;
    const char *settings; /* over the desc's; NULL = paths are traced through pixels' centres */
    const char *values;   /* a sweep; NULL = none */
    unsigned against;     /* bits, 1 << standard */
    bool traced;          /* visibility by ray tracing */
};

/* --- the budget ------------------------------------------------------------------------------- */

/* Each pixel takes all that the pixels of an interleaving pattern take together. With EVERY_VPL
 * blocks of one pixel are as good as none: a lookup for each VAL, not for each of its VPLs. */
#define EVERY_VPL "interleave=1,near-samples=1024,blur-radius=0,samples=1"
#define MAP_PER_VPL "technique=instant-radiosity,"
#define MAP_PER_VAL "technique=clustered,path=maps,"

enum { ON_THE_WAY = 1U << BEFORE | 1U << REFERENCE };

static const struct step budget[] = {
    /* Traces paths through pixel centres only. */
    {"pixel centres", NULL, NULL, ON_THE_WAY, false},
    /* Few lights, and light near to them bounded. */
    {"all VPLs, ray-traced", MAP_PER_VPL "clamp=disk," EVERY_VPL, NULL, ON_THE_WAY, true},
    {"hard map per VPL", MAP_PER_VPL "clamp=disk," EVERY_VPL, NULL, ON_THE_WAY, false},
    /* Adds the near light that the clamp removed. */
    {"near field", MAP_PER_VPL EVERY_VPL, NULL, ON_THE_WAY, false},
    {"hard map per VAL", MAP_PER_VAL "visibility=hard,visibility-block=1," EVERY_VPL, NULL,
     ON_THE_WAY, false},
    {"soft map per VAL", MAP_PER_VAL "visibility-block=1," EVERY_VPL, NULL, ON_THE_WAY, false},
    {"visibility per block", MAP_PER_VAL EVERY_VPL, NULL, ON_THE_WAY, false},
    {"interleaved", MAP_PER_VAL "blur-radius=0,samples=1", NULL, ON_THE_WAY, false},
    {"blurred", MAP_PER_VAL "samples=1", NULL, ON_THE_WAY | 1U << CENTERS, false},
    {"antialiased: the frame by maps", MAP_PER_VAL, NULL, ON_THE_WAY, false},
    {.name = NULL},
};

/* --- the curves ------------------------------------------------------------------------------- */

/* No interleaving, no blocks but of one pixel, no blur, no near field, no edges: the visibility
 * alone. */
#define VISIBILITY_ALONE "clamp=disk,visibility-block=1,interleave=1,blur-radius=0,samples=1"
#define CSSM "technique=clustered,path=paper," VISIBILITY_ALONE
#define HARD "technique=clustered,path=maps,visibility=hard," VISIBILITY_ALONE
#define PCSS "technique=clustered,path=maps,visibility=pcss," VISIBILITY_ALONE

#define OF_VALS "vals=2,4,8,16,30,60,120,1024"
#define OF_TERMS "terms=1,2,4,8,16"
#define OF_MAPS "map-size=64,128,256,512"
#define OF_VPLS "vpls=64,128,256,512,1024,2048,4096"

static const struct step curves[] = {
    {"CSSM", CSSM, OF_VALS, 1U << RAYS, false},
    {"PCSS", PCSS, OF_VALS, 1U << RAYS, false},
    {"hard", HARD, OF_VALS, 1U << RAYS, false},
    {"CSSM", CSSM, OF_TERMS, 1U << RAYS, false},
    {"CSSM", CSSM, OF_MAPS, 1U << RAYS, false},
    {"PCSS", PCSS, OF_MAPS, 1U << RAYS, false},
    {"hard", HARD, OF_MAPS, 1U << RAYS, false},
    {"the frame", "technique=clustered,samples=1", OF_VPLS, 1U << CENTERS, false},
    {"the paper's frame", "technique=clustered,path=paper,samples=1", OF_VPLS, 1U << CENTERS,
     false},
    {"all VPLs by rays", HARD, OF_VPLS, 1U << CENTERS, true},
    {.name = NULL},
};

/* --- measuring -------------------------------------------------------------------------------- */

struct run {
    struct results *results;
    const struct measure_desc *desc;
    const struct reference_desc *reference;
    struct image standards[STANDARDS]; /* those made so far */
};

static bool trace_centers(const struct run *run, const struct measure_desc *desc,
                          struct image *image) {
    return reference_get(
        &(struct reference_desc){REFERENCE_CENTERS, run->reference->cache, run->reference->noise},
        desc, image);
}

static bool draw(const struct run *run, const struct step *step, const struct measure_desc *desc,
                 struct image *image) {
    return !step->settings ? trace_centers(run, desc, image)
           : step->traced  ? picture_trace(desc, NULL, image)
                           : picture_render(desc, image);
}

/* Makes a standard unless it exists. */
static bool need(struct run *run, int standard) {
    struct image *image = &run->standards[standard];
    struct measure_desc exact = *run->desc;
    return image->pixels || (standard == REFERENCE ? reference_get(run->reference, run->desc, image)
                             : standard == CENTERS ? trace_centers(run, run->desc, image)
                                                   : measure_assign(&exact, HARD) &&
                                                         picture_trace(&exact, NULL, image));
}

static bool add_errors(struct run *run, unsigned against, const struct image *picture) {
    bool ok = true;
    for (int i = 0; ok && i < STANDARDS; i++) {
        int standard = i == BEFORE && !run->standards[BEFORE].pixels ? REFERENCE : i;
        if (against >> i & 1)
            ok = need(run, standard) &&
                 errors_add(run->results, picture, &run->standards[standard], standard_names[i]);
    }
    return ok;
}

static bool measure_picture(struct run *run, const struct step *step,
                            const struct measure_desc *desc) {
    struct image picture = {0};
    results_tell_work(run->results, desc, 0);
    bool ok = draw(run, step, desc, &picture);
    if (ok) {
        results_begin(run->results, desc);
        ok = add_errors(run, step->against, &picture) && results_commit(run->results);
    }
    image_free(&run->standards[BEFORE]);
    run->standards[BEFORE] = picture;
    return ok;
}

/* The list is to be freed. */
static bool list_points(const struct measure_desc *all, const struct step *step,
                        struct measure_list *points) {
    struct measure_desc desc = *all;
    *points = (struct measure_list){0};
    snprintf(desc.variant, sizeof desc.variant, "%s", step->name);
    bool ok = measure_assign(&desc, step->settings);
    measure_list_add(points, &desc);
    return ok && (!step->values || measure_vary(points, step->values));
}

static bool measure_step(struct run *run, const struct step *step) {
    struct measure_list points;
    bool ok = list_points(run->desc, step, &points);
    for (int i = 0; ok && i < points.count; i++)
        ok = measure_picture(run, step, &points.items[i]);
    free(points.items);
    return ok;
}

static bool measure_steps(struct run *run, const struct step *steps) {
    bool ok = true;
    for (const struct step *step = steps; ok && step->name; step++)
        ok = measure_step(run, step);
    for (int i = 0; i < STANDARDS; i++)
        image_free(&run->standards[i]);
    return ok;
}

/* Measures where the error of a frame comes from, by single steps from the reference to the frame.
 * Adds a subject for each step, named by the step, with its errors against the reference and
 * against the step before. The last step before antialiasing also has errors against pixel centres;
 * the first has the reference's "noise". desc: size and settings of all steps. Error: of the
 * reference or a picture. */
static bool budget_measure(struct results *results, const struct measure_desc *desc,
                           const struct reference_desc *reference) {
    struct run run = {.results = results, .desc = desc, .reference = reference};
    struct measure_desc exact = *desc;
    snprintf(exact.variant, sizeof exact.variant, "the reference");
    if (!need(&run, REFERENCE))
        return false;
    results_begin(results, &exact);
    results_add(results, "noise", "", "%", 100 * reference_noise(&run.standards[REFERENCE]));
    return results_commit(results) && measure_steps(&run, budget);
}

static int budget_subjects(void) {
    return sizeof budget / sizeof *budget; /* its end stands for the reference */
}

static int curves_subjects(const struct measure_desc *desc) {
    int count = 0;
    for (const struct step *step = curves; step->name; step++) {
        struct measure_list points;
        count += list_points(desc, step, &points) ? points.count : 0;
        free(points.items);
    }
    return count;
}

/* Errors along one setting at a time, as in the paper's Fig. 10: M, K and the size of maps against
 * ray-traced visibility from the same VPLs, N against the reference through pixel centres. Adds a
 * subject for each value of each curve: the curve's name is the variant, "vals=8" the point. */
static bool curves_measure(struct results *results, const struct measure_desc *desc,
                           const struct reference_desc *reference) {
    struct run run = {.results = results, .desc = desc, .reference = reference};
    return measure_steps(&run, curves);
}

static bool measure_budget(struct bench *bench, const struct measure_list *subjects) {
    struct reference_desc reference = bench_reference(bench, REFERENCE_PATH);
    bench_expect(bench, budget_subjects() + (bench->values.tracer ? BASELINE_SUBJECTS : 0));
    return budget_measure(&bench->results, subjects->items, &reference) &&
           (!bench->values.tracer ||
            baseline_measure(&bench->results, subjects->items, &reference, AGAINST_REFERENCE));
}

static bool measure_curves(struct bench *bench, const struct measure_list *subjects) {
    struct reference_desc reference = bench_reference(bench, REFERENCE_CENTERS);
    bench_expect(bench, curves_subjects(subjects->items));
    return curves_measure(&bench->results, subjects->items, &reference);
}

const struct bench_mode bench_budget = {
    .name = "budget",
    .help = "errors of a frame, approximation by approximation, from the reference on\n"
            "Each step changes one thing. Without SCENE: the paper's four scenes.",
    .options = "size set tracer noise cache" BENCH_CONTEXT,
    .measure = measure_budget,
    .tables = {{"each step alone, against the one before", {ERROR_COLUMNS(AGAINST_BEFORE)}},
               {"against the reference",
                {ERROR_COLUMNS(AGAINST_REFERENCE), {"its noise", "noise", NULL}}},
               {"but for edges: against the reference through pixels' centres",
                {ERROR_COLUMNS(AGAINST_CENTERS)}}},
};

const struct bench_mode bench_curves = {
    .name = "curves",
    .help =
        "errors over M, K, N and the map size, as in the paper's Fig. 10\n"
        "N is compared with the path tracer, the others with ray-traced visibility of the same\n"
        "VPLs. Without SCENE: the paper's four scenes.",
    .options = "size set noise cache" BENCH_CONTEXT,
    .measure = measure_curves,
    .tables = {{"errors along one setting", {ERROR_COLUMNS(NULL)}}},
};
