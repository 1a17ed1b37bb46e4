/* manylight report: a page on one scene, of how fast and how true each technique is there. */
#include "apps/apps.h"
#include "apps/arguments.h"
#include "apps/options.h"

#include "apps/bench/measure/clip.h"
#include "apps/bench/measure/timing.h"
#include "apps/report/page.h"
#include "base/file/output_file.h"
#include "base/log.h"
#include "base/memory.h"
#include "quality/picture.h"
#include "scene/animation.h"

#include <stdlib.h>
#include <string.h>

struct values {
    struct common_values common;
    struct context_desc context;
    struct stage_desc stage;
    struct text_list variants, settings;
    const char *output, *cache;
    int size[2], frames, flicker_frames;
    float noise, error;
};

#define VALUE(member) offsetof(struct values, member)

static const struct option options[] = {
    {"output", 'o', OPTION_TEXT, VALUE(output), .value_name = "FILE.html",
     .help = "page to write [report.html]"},
    {"size", 's', OPTION_SIZE, VALUE(size), 0, 1, 4096,
     .help = "size of the pictures, pixels [320 along the longer side]"},
    {"variant", 0, OPTION_LIST, VALUE(variants),
     .help = "variant to measure, listed below; repeatable [all of them]"},
    {"set", 0, OPTION_LIST, VALUE(settings), .value_name = "KEY=VALUE",
     .help = "setting of all variants (manylight render --help-all); repeatable"},
    {"noise", 0, OPTION_FLOAT, VALUE(noise), .03, 1e-4, 1, .value_name = "X%",
     .help = "noise of the path-traced reference: standard error over mean"},
    {"max-error", 0, OPTION_FLOAT, VALUE(error), .1, 0, 10, .value_name = "X%",
     .help = "limit for which the page tells what --max-error of render chooses; 0: not told"},
    {"frames", 0, OPTION_INT, VALUE(frames), 0, 0, 100000,
     .help = "number of timed frames; 0: 5 on software OpenGL, else 100"},
    {"flicker", 0, OPTION_INT, VALUE(flicker_frames), 6, 0, 1000, .value_name = "N",
     .help = "frames of the animation, if any, for flicker; 0: not measured"},
    {"cache", 0, OPTION_TEXT, VALUE(cache), .value_name = "DIR",
     .help = "folder of the reference [$XDG_CACHE_HOME/manylight]"},
    STAGE_OPTIONS(struct values, stage),
    SCENE_OPTION(struct values, stage.choice),
    CONTEXT_OPTIONS(struct values, context),
    {NULL},
};

static void print_variants(FILE *out, const void *values) {
    (void)values;
    variants_print(out);
}

static const struct arguments arguments = {
    .synopsis = "SCENE [OPTION ...]",
    .summary =
        "Writes a page that shows each technique and preset beside a path-traced reference: "
        "pictures,\n"
        "differences, error against time, times of passes, memory, flicker. The page needs no "
        "other\n"
        "file, no network and no script.",
    .options = options,
    .opens_scenes = true,
    .min_positional = 1,
    .max_positional = 1,
    .print_more = print_variants,
};

static bool add_subject(struct report *report, const struct values *values, const char *variant) {
    struct measure_desc desc = measure_default(report->stage, report->width, report->height);
    if (!variant_apply(&desc, variant) ||
        !measure_assign_all(&desc, values->settings.items, values->settings.count) ||
        !measure_check(&desc))
        return false;
    measure_list_add(&report->subjects, &desc);
    return true;
}

/* The presets, then the techniques; "fast" is the default technique. */
static bool add_all_subjects(struct report *report, const struct values *values) {
    static const char *const presets[] = {"draft", "fast", "traced", "maps", "paper"};
    bool ok = true;
    for (size_t i = 0; ok && i < sizeof presets / sizeof *presets; i++)
        ok = add_subject(report, values, presets[i]);
    for (int i = 0; ok && techniques[i]; i++)
        if (techniques[i] != technique_default)
            ok = add_subject(report, values, techniques[i]->name);
    return ok;
}

static bool add_subjects(struct report *report, const struct values *values) {
    bool ok = true;
    if (values->variants.count == 0)
        return add_all_subjects(report, values);
    for (int i = 0; ok && i < values->variants.count; i++)
        ok = add_subject(report, values, values->variants.items[i]);
    return ok;
}

/* Everything that the arguments alone can get wrong. */
static bool check(const struct values *values) {
    struct report tried = {.width = 8, .height = 8};
    bool ok = add_subjects(&tried, values);
    free(tried.subjects.items);
    return ok;
}

static void choose_size(struct report *report, const struct values *values) {
    const int longer = 320;
    int size[2];
    stage_default_size(report->stage, size);
    double scale = (double)longer / (size[0] > size[1] ? size[0] : size[1]);
    report->width = values->size[0] ? values->size[0] : (int)(size[0] * scale + .5);
    report->height = values->size[0] ? values->size[1] : (int)(size[1] * scale + .5);
}

static bool measure_times(struct report *report, const struct values *values) {
    struct timing_desc timing = {
        .frames = values->frames,
        .reference = {REFERENCE_PATH, values->cache, (double)values->noise}};
    results_set_stage(&report->results, report->stage);
    log_note("times and errors of %d variants", report->subjects.count);
    if (!timing_measure(&report->results, &report->subjects, &timing) ||
        !reference_get(&timing.reference, &report->subjects.items[0], &report->reference))
        return false;
    report->noise = reference_noise(&report->reference);
    return true;
}

static bool take_pictures(struct report *report) {
    bool ok = true;
    log_note("pictures");
    report->pictures = mem_alloc((size_t)report->subjects.count, sizeof *report->pictures);
    for (int i = 0; ok && i < report->subjects.count; i++)
        ok = picture_render(&report->subjects.items[i], &report->pictures[i]);
    return ok;
}

static bool find_choice(struct report *report, const struct values *values) {
    struct measure_desc desc = measure_default(report->stage, report->width, report->height);
    report->asked = (double)values->error;
    if (report->asked <= 0)
        return true;
    log_note("what --max-error chooses");
    return measure_assign_all(&desc, values->settings.items, values->settings.count) &&
           quality_find(&(struct quality_desc){.measure = &desc,
                                               .texts = values->settings.items,
                                               .text_count = values->settings.count,
                                               .error = report->asked,
                                               .most_passes = 1,
                                               .any_technique = true},
                        &report->found);
}

/* The stage is at another time afterwards. */
static bool measure_flicker(struct report *report, struct stage *stage,
                            const struct values *values) {
    struct clip_desc clip = {.stage = stage,
                             .subjects = &report->subjects,
                             .frames = values->flicker_frames,
                             .all_vpls = measure_default(stage, report->width, report->height)};
    report->flicker_frames = values->flicker_frames;
    if (clip.frames < 2 || !(scene_duration(&stage->scene) > 0))
        return true;
    log_note("flicker over %d frames", clip.frames);
    return variant_apply(&clip.all_vpls, reference_vpls) && clip_measure(&report->flicker, &clip);
}

static bool write_page(const struct report *report, const char *path) {
    struct output_text text;
    output_text_init(&text);
    if (page_print(text.stream, report))
        return output_text_end(&text, path);
    output_text_free(&text);
    return false;
}

static void report_free(struct report *report) {
    for (int i = 0; report->pictures && i < report->subjects.count; i++)
        image_free(&report->pictures[i]);
    mem_free(report->pictures, report->subjects.items);
    image_free(&report->reference);
    results_free(&report->results);
    results_free(&report->flicker);
}

static bool make_report(struct stage *stage, const struct values *values, const char *output) {
    struct report report = {.path = values->stage.path, .stage = stage};
    choose_size(&report, values);
    bool ok = add_subjects(&report, values) && measure_times(&report, values) &&
              take_pictures(&report) && find_choice(&report, values) &&
              measure_flicker(&report, stage, values) && write_page(&report, output);
    if (ok)
        log_note("%s is written", output);
    report_free(&report);
    return ok;
}

int app_report(int argc, char **argv) {
    struct values values = {0};
    struct stage stage;
    int count, status;
    if (!arguments_parse(&arguments, &values, argc, argv, &values.stage.path, &count, &status))
        return status;
    if (!check(&values))
        return arguments_misuse(argv[0]);
    const char *output = values.output ? values.output : "report.html";
    if (!output_file_check(output, &values.stage.path, 1) || !stage_init(&stage, &values.stage))
        return arguments_fail(argv[0]);
    struct context *context = context_create(&values.context);
    bool ok = context && make_report(&stage, &values, output);
    context_free(context);
    stage_free(&stage);
    return ok ? STATUS_OK : arguments_fail(argv[0]);
}
