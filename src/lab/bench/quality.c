/* manylight bench quality: whether --max-error is right, and as cheap as it can be. */
#include "lab/bench/bench.h"

#include "lab/measure/baseline.h"
#include "base/file/image_file.h"
#include "base/clock.h"
#include "metrics/layer.h"
#include "metrics/metric.h"
#include "quality/estimate.h"
#include "quality/traced.h"
#include "quality/quality.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

struct quality_check_desc {
    const struct measure_desc *measure; /* as quality_desc's, with settings */
    const char *const *texts;
    int text_count;
    const struct image *reference; /* of all pixels */
    int most_passes;
    bool estimates; /* only the ladder: each choice drawn once, and no times */
};

/* Settings that users might choose by hand. */
static const struct quality_choice others[] = {
    QUALITY_FRAME("gather.adaptive=0"),
    QUALITY_FRAME("path=maps"),
    QUALITY_FRAME("gather.interleave=4"),
    QUALITY_FRAME("lights.vpls=2048"),
    QUALITY_FRAME("picture.samples=16"),
    QUALITY_FRAME("path=traced"),
    QUALITY_FRAME("path=traced lights.vpls=256"),
    QUALITY_FRAME("path=traced lights.vpls=512"),
    QUALITY_FRAME("path=traced lights.vpls=512 gather.interleave=4 picture.samples=16"),
    {"", 1, "unshadowed", 0},
    {"", 1, "lightcuts", 0},
    {"", 1, "cluster-lights", 0},
};

static const double asked[] = {.02, .04, .08, .16, .3};

enum {
    OTHERS = sizeof others / sizeof *others,
    ASKED = sizeof asked / sizeof *asked,
    TRIED_MAX = QUALITY_CHOICES_MAX + OTHERS,
    TIMED = 2,       /* frames at least, and as many as take so long together: */
    TIMED_CPU = 150, /* ms */
};

/* A choice and its picture. */
struct tried {
    struct quality_choice choice;
    const struct technique *technique;
    struct image picture; /* of the ladder's */
    double error, ms, cpu;
};

struct check {
    const struct quality_check_desc *desc;
    struct results *results;
    struct estimate estimate;
    double asked;           /* now */
    struct image reference; /* its indirect layer, as far as it is covered */
    double noise;
    struct tried tried[TRIED_MAX];
    int count, ladder; /* the first ones are the ladder's */
};

static double without_noise(double error, double noise) {
    return sqrt(fmax(error * error - noise * noise, 0));
}

static bool measure_error(struct check *check, struct tried *tried) {
    struct image layer;
    if (!layer_extract_covered(&layer, &tried->picture, "indirect", check->desc->reference))
        return false;
    struct comparison comparison = {.test = &layer, .reference = &check->reference};
    double error = metric_measure(metric_find("relative-rmse"), &comparison, NULL);
    tried->error = without_noise(error, check->noise);
    image_free(&layer);
    return true;
}

/* --- drawing --- */

typedef bool measure_starter(struct renderer *renderer, const struct measure_desc *desc);

static bool measure_tried(const struct check *check, const struct tried *tried,
                          struct measure_desc *measure) {
    const struct quality_check_desc *desc = check->desc;
    *measure = *desc->measure;
    measure->technique = tried->technique;
    return quality_settings(&tried->choice, measure->technique, desc->texts, desc->text_count,
                            &measure->settings);
}

static bool start(struct check *check, const struct tried *tried, measure_starter *start_as,
                  struct renderer *renderer) {
    struct measure_desc measure;
    if (!measure_tried(check, tried, &measure) || !start_as(renderer, &measure))
        return false;
    renderer->timers.enabled = false;
    return true;
}

/* The least CPU time is least disturbed by other processes. */
static void time_frames(struct renderer *renderer, struct tried *tried) {
    double sum = 0;
    for (int i = 0; i < TIMED || sum < TIMED_CPU; i++) {
        gl.Finish();
        double clock = clock_ms(), cpu = clock_cpu_ms();
        renderer_render(renderer);
        gl.Finish();
        clock = clock_ms() - clock;
        cpu = clock_cpu_ms() - cpu;
        sum += cpu;
        tried->ms = i ? fmin(tried->ms, clock) : clock;
        tried->cpu = i ? fmin(tried->cpu, cpu) : cpu;
    }
}

static bool try_traced(struct check *check, struct tried *tried) {
    struct measure_desc measure;
    double clock = clock_ms(), cpu = clock_cpu_ms();
    if (!measure_tried(check, tried, &measure) ||
        !traced_render(&measure, tried->choice.samples, false, NULL, &tried->picture))
        return false;
    tried->ms = clock_ms() - clock;
    tried->cpu = clock_cpu_ms() - cpu;
    return measure_error(check, tried);
}

static bool try_frame(struct check *check, struct tried *tried) {
    struct renderer renderer;
    if (tried->choice.samples > 0)
        return try_traced(check, tried);
    if (!start(check, tried, measure_start, &renderer))
        return false;
    renderer_render(&renderer); /* compiles */
    if (!check->desc->estimates)
        time_frames(&renderer, tried);
    bool ok = renderer_read_layers(&renderer, &tried->picture) && measure_error(check, tried);
    renderer_free(&renderer);
    return ok;
}

/* One mean, at each number of passes on its way to the last. */
static bool try_means(struct check *check, struct tried *tried, int count) {
    struct renderer renderer;
    double ms = 0, cpu = 0;
    int done = 0;
    if (count == 0)
        return true;
    if (!start(check, tried, measure_start_mean, &renderer))
        return false;
    bool ok = true;
    for (int pass = 0; pass < 2; pass++) /* compiles */
        renderer_add_pass(&renderer, pass);
    for (int i = 0; ok && i < count; i++) {
        gl.Finish();
        ms -= clock_ms(), cpu -= clock_cpu_ms();
        while (done < tried[i].choice.passes)
            renderer_add_pass(&renderer, done++);
        gl.Finish();
        ms += clock_ms(), cpu += clock_cpu_ms();
        tried[i].ms = ms;
        tried[i].cpu = cpu;
        ok = renderer_read_layers(&renderer, &tried[i].picture) && measure_error(check, &tried[i]);
    }
    renderer_free(&renderer);
    return ok;
}

/* Given settings may not suit each technique, or paths. */
static void add_choice(struct check *check, const struct quality_choice *choice) {
    struct tried tried = {.choice = *choice,
                          .technique = quality_technique(choice, check->desc->measure->technique)};
    struct measure_desc measure;
    if (measure_tried(check, &tried, &measure) &&
        (choice->samples == 0 || traced_is_possible(&measure)))
        check->tried[check->count++] = tried;
}

static void list_choices(struct check *check) {
    struct quality_choice choices[QUALITY_CHOICES_MAX];
    int count = quality_ladder(choices, check->desc->most_passes);
    for (int i = 0; i < count; i++)
        add_choice(check, &choices[i]);
    check->ladder = check->count;
    for (int i = 0; i < OTHERS && !check->desc->estimates; i++)
        add_choice(check, &others[i]);
}

/* --- telling --- */

/* point NULL: as the choice is described. */
static struct measure_desc describe(const struct check *check, const struct tried *tried,
                                    const char *variant, const char *point) {
    struct measure_desc measure;
    char *what = quality_describe(&tried->choice);
    measure_tried(check, tried, &measure);
    snprintf(measure.variant, sizeof measure.variant, "%s", variant);
    snprintf(measure.point, sizeof measure.point, "%s", point ? point : what);
    free(what);
    return measure;
}

static void begin(struct check *check, const struct tried *tried,
                  const struct measure_desc *measure) {
    results_begin(check->results, measure);
    results_add(check->results, "error", reference_names[REFERENCE_PATH], "%", 100 * tried->error);
    if (!check->desc->estimates) {
        results_add(check->results, "clock", "", "ms", tried->ms);
        results_add(check->results, "cpu", "", "ms", tried->cpu);
    }
}

/* CPU time of the fastest choice with at most this error. */
static double fastest(const struct check *check, double error) {
    double least = INFINITY;
    for (int i = 0; i < check->count; i++)
        if (check->tried[i].error <= error)
            least = fmin(least, check->tried[i].cpu);
    return least;
}

/* NULL: the choice does not suit the given settings. */
static struct tried *find(struct check *check, const struct quality_choice *choice) {
    for (struct tried *tried = check->tried; tried < &check->tried[check->ladder]; tried++)
        if (tried->choice.settings == choice->settings && tried->choice.passes == choice->passes &&
            tried->choice.technique == choice->technique &&
            tried->choice.samples == choice->samples)
            return tried;
    return NULL;
}

static bool tell_of_picture(void *user, const struct quality_choice *choice, double *error) {
    struct check *check = user;
    struct tried *tried = find(check, choice);
    *error = INFINITY;
    return !tried || estimate_picture_error(&check->estimate, &tried->picture, check->asked, error);
}

static bool add_asked(struct check *check, double error, const struct quality_found *found,
                      const struct measure_desc *measure) {
    const struct tried *chosen = find(check, &found->choice);
    begin(check, chosen, measure);
    results_add(check->results, "told", "", "%", 100 * found->error);
    results_add(check->results, "of-asked", "", "1", chosen->error / error);
    results_add(check->results, "of-fastest", "", "1", chosen->cpu / fastest(check, chosen->error));
    return results_commit(check->results);
}

/* Always estimates, because each picture improves later estimates. */
static bool ask(struct check *check, double error) {
    struct quality_found found;
    char point[32];
    check->asked = error;
    if (!quality_climb(error, check->desc->most_passes, tell_of_picture, check, &found))
        return false;
    snprintf(point, sizeof point, "error=%g%%", 100 * error);
    struct measure_desc measure = describe(check, find(check, &found.choice), "automatic", point);
    return add_asked(check, error, &found, &measure);
}

static struct measure_desc describe_tried(const struct check *check, int i) {
    const char *camera = check->desc->measure->stage->camera_text;
    const char *rung = check->desc->estimates && camera ? camera : "ladder";
    return describe(check, &check->tried[i], i < check->ladder ? rung : "fixed", NULL);
}

/* The ladder's as if any were good enough. */
static bool add_tried(struct check *check, int i) {
    struct measure_desc measure = describe_tried(check, i);
    struct tried *tried = &check->tried[i];
    double estimated;
    if (i < check->ladder &&
        !estimate_picture_error(&check->estimate, &tried->picture, INFINITY, &estimated))
        return false;
    begin(check, tried, &measure);
    if (i < check->ladder)
        results_add(check->results, "told", "", "%", 100 * estimated);
    return results_commit(check->results);
}

/* --- all --- */

/* Number of choices drawn together; means of the ladder count as one. */
static int count_at(const struct check *check, int i) {
    bool is_mean = i < check->ladder && check->tried[i].choice.passes > 1;
    return is_mean ? check->ladder - i : 1;
}

static bool try_at(struct check *check, int i, int count) {
    struct tried *tried = &check->tried[i];
    struct measure_desc measure = describe_tried(check, i);
    results_tell_work(check->results, &measure, 0);
    bool ok = count > 1 || tried->choice.passes > 1 ? try_means(check, tried, count)
                                                    : try_frame(check, tried);
    for (int k = i; ok && k < i + count; k++)
        ok = add_tried(check, k);
    if (i >= check->ladder)
        image_free(&tried->picture);
    return ok;
}

static bool try_all(struct check *check) {
    bool ok = true;
    for (int i = 0, count; ok && i < check->count; i += count) {
        count = count_at(check, i);
        ok = try_at(check, i, count);
    }
    for (int i = 0; ok && !check->desc->estimates && i < ASKED; i++)
        ok = ask(check, asked[i]);
    return ok;
}

static int quality_check_subjects(const struct quality_check_desc *desc) {
    struct check check = {.desc = desc};
    list_choices(&check);
    return check.count + (desc->estimates ? 0 : ASKED);
}

/* Draws each choice of the quality ladder, in the order in which the program comes, and fixed
 * settings and techniques beside it. Each is a subject, of variant "ladder" or "fixed". It has
 * "error", the relative RMSE of the indirect layer as far as pixels are covered, without the
 * reference's noise. It has "clock" and "cpu", and of the ladder "told", the estimated error.
 *
 * Then each error that may be asked for ("error=8%") is a subject of variant "automatic", with what
 * the ladder's choice has. Its "told" is the error that was estimated. "of-asked" is its error over
 * the one asked for. "of-fastest" is its CPU time over that of the fastest that errs no more. With
 * estimates alone, the variant is the camera, if one is named. Error: of a renderer or
 * the tracer. */
static bool quality_check(struct results *results, const struct quality_check_desc *desc) {
    struct check check = {
        .desc = desc, .results = results, .noise = reference_noise_covered(desc->reference)};
    list_choices(&check);
    bool ok =
        layer_extract_covered(&check.reference, desc->reference, "indirect", desc->reference) &&
        estimate_init(&check.estimate, desc->measure, "indirect") && try_all(&check);
    for (int i = 0; i < check.count; i++)
        image_free(&check.tried[i].picture);
    estimate_free(&check.estimate);
    image_free(&check.reference);
    return ok;
}

static bool check_scene(struct bench *bench, const struct measure_desc *measure) {
    const struct bench_values *values = &bench->values;
    struct reference_desc desc = bench_reference(bench, REFERENCE_PATH);
    struct image reference;
    bool ok = values->reference_file ? image_read(&reference, values->reference_file)
                                     : reference_get(&desc, measure, &reference);
    if (!ok)
        return false;
    struct quality_check_desc checked = {measure,    values->settings.items, values->settings.count,
                                         &reference, values->passes,         values->estimates};
    bench_expect(bench,
                 quality_check_subjects(&checked) + (values->tracer ? BASELINE_SUBJECTS : 0));
    ok = quality_check(&bench->results, &checked);
    image_free(&reference);
    return ok;
}

static bool measure(struct bench *bench, const struct measure_list *subjects) {
    struct reference_desc reference = bench_reference(bench, REFERENCE_PATH);
    bool ok = true;
    for (int i = 0; ok && i < subjects->count; i++)
        ok = check_scene(bench, &subjects->items[i]) &&
             (!bench->values.tracer ||
              baseline_measure(&bench->results, &subjects->items[i], &reference,
                               reference_names[reference.kind]));
    return ok;
}

const struct bench_mode bench_quality = {
    .name = "quality",
    .help =
        "render --max-error: estimated against measured errors, times against the fastest\n"
        "Draws each choice of --max-error, and fixed settings for comparison. Then prints for 2,\n"
        "4, 8, 16 and 30 %: the choice, its estimated error, its error without the noise of the\n"
        "reference, that error over the limit, and its CPU time over that of the fastest choice\n"
        "within the limit. Without SCENE: the paper's four scenes.",
    .options =
        "size set camera light noise cache passes estimates reference-file tracer" BENCH_CONTEXT,
    .measure = measure,
    .tables = {{"--max-error",
                {{"estimated %", "told", NULL},
                 {"error %", "error", NULL},
                 {"of asked", "of-asked", NULL},
                 {"CPU ms", "cpu", NULL},
                 {"of fastest", "of-fastest", NULL}}}},
};
