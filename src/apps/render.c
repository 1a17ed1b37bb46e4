/* manylight render: pictures offscreen. */
#define _POSIX_C_SOURCE 200809L
#include "apps/background.h"
#include "apps/interrupt.h"
#include "apps/outputs.h"
#include "apps/render_options.h"
#include "apps/stats.h"
#include "apps/subcommands.h"

#include "base/clock.h"
#include "base/error.h"
#include "base/file/image_file.h"
#include "base/file/output_file.h"
#include "base/log.h"
#include "base/memory.h"
#include "base/phases.h"
#include "base/progress.h"
#include "gl/api.h"
#include "gl/cancel.h"
#include "gl/glsl.h"
#include "inspect/aov.h"
#include "quality/quality.h"
#include "quality/traced.h"
#include "renderer/about.h"
#include "scene/caustics.h"
#include "shared/composite.h"

#include <string.h>

/* Each frame of several needs files of its own. */
static bool check_name(const struct render_values *values, const char *name, int frame_count,
                       bool *is_float) {
    bool numbered = frame_name_is_numbered(name);
    if (!image_format_is_float(name, is_float))
        return false;
    if (output_file_is_stdout(name) && (values->frames || values->skip_existing))
        return error_set("-o -: standard output takes one picture, without --frames and "
                         "--skip-existing");
    if (!values->frames && numbered)
        return frame_name_refuse(name, "there is no --frames");
    if (values->frames && !frame_name_is_plain(name))
        return error_set("%s: its form of a frame's number is not known; #### and %%04d are", name);
    if (frame_count > 1 && !numbered)
        return error_set("%s: %d frames need #### or %%04d in the file's name", name, frame_count);
    return true;
}

static bool has_mean(const struct render_values *values) {
    return values->passes > 1 || values->first_pass > 0 ||
           (values->passes_given && !aov_needs_pass(values->aov));
}

/* Videos show the background as pictures of 8 bits do. */
static bool check_background(const struct render_values *values,
                             const struct background *background) {
    bool has_video = values->videos.paths.count > 0;
    if (has_video && background->kind == BACKGROUND_NONE)
        return error_set("--background none: %s cannot be transparent",
                         values->videos.paths.items[0]);
    return (has_video && background->kind == BACKGROUND_COLOUR) ||
           background_check(background, values->outputs.items, values->outputs.count);
}

/* What an option needs to have an effect. exr: how many outputs are of that format. */
static bool check_use(const struct render_values *values, int exr) {
    int all = values->outputs.count + values->videos.paths.count;
    return arguments_check_use(
        &values->common,
        (struct option_use[]){{"fps", values->frames, "--frames"},
                              {"camera time", !values->cameras, "pictures without --cameras"},
                              {"layer", exr < all, "formats of one layer; EXR holds all of them"},
                              {"aov", exr > 0, "formats that hold all layers: -o FILE.exr"},
                              {NULL}});
}

static bool check_outputs(const struct render_values *values, int frame_count) {
    bool is_float;
    int exr = 0;
    if (aov_needs_pass(values->aov) && has_mean(values))
        return error_set("aov: outputs of a technique are of one pass, and not of a mean");
    if (values->outputs.count + values->videos.paths.count == 0)
        return error_set("no output: -o FILE");
    if (!videos_check_use(&values->videos, values->frames, values->skip_existing) ||
        !outputs_use_format(values->outputs.items, values->outputs.count, values->format))
        return false;
    for (int i = 0; i < values->outputs.count; i++) {
        if (!check_name(values, values->outputs.items[i], frame_count, &is_float))
            return false;
        exr += image_name_holds_layers(values->outputs.items[i]);
    }
    return check_use(values, exr);
}

typedef bool visit_output(const struct render_values *values, struct renderer *renderer,
                          const char *path);

/* Visits the outputs of a frame, until one says false. */
static bool each_output(const struct render_values *values, struct renderer *renderer, int frame,
                        visit_output *visit) {
    bool ok = true;
    for (int i = 0; ok && i < values->outputs.count; i++) {
        char *path = frame_name(values->outputs.items[i], frame);
        ok = visit(values, renderer, path);
        free(path);
    }
    return ok;
}

static double frame_time(const struct render_values *values, int frame) {
    if (values->cameras)
        return values->views.items[frame].time;
    return (double)values->stage.time + frame / values->rate.fps;
}

static bool check_file(const struct render_values *values, struct renderer *renderer,
                       const char *path) {
    (void)values, (void)renderer;
    return output_file_check(path, NULL, 0);
}

static bool read_image(const struct render_values *values, struct renderer *renderer,
                       struct image *image) {
    if (values->traced > 0)
        *image = image_copy(&values->picture);
    else if (!renderer_read_layers(renderer, image) ||
             !aov_append(renderer, values->aov, &values->motion, image))
        return false;
    char traced[64];
    snprintf(traced, sizeof traced, "path, %d samples per pixel, denoised", values->traced);
    const struct about about = {.scene = values->stage.path,
                                .camera = values->stage.camera,
                                .technique =
                                    values->traced > 0 ? traced : renderer->technique->name,
                                .placed = &renderer->desc.camera,
                                .settings = &renderer->desc.settings,
                                .time = frame_time(values, values->progress->frame)};
    about_add(image, &about);
    if (has_mean(values)) {
        image->passes =
            mem_printf("%d..%d", values->first_pass, values->first_pass + values->passes - 1);
        image->weight = renderer_pass_weight(renderer);
    }
    return true;
}

static bool read_bitmap(const struct render_values *values, struct renderer *renderer,
                        struct bitmap *bitmap) {
    if (values->traced > 0)
        return traced_display(&values->picture, &renderer->desc, values->layer, bitmap);
    renderer_compose(renderer, values->layer);
    return renderer_read_display(renderer, bitmap);
}

static bool write_output(const struct render_values *values, struct renderer *renderer,
                         const char *path) {
    bool is_float, ok;
    if (!image_format_is_float(path, &is_float) || !scene_check_output(renderer->desc.scene, path))
        return false;
    if (is_float) {
        struct image image = {0};
        ok = read_image(values, renderer, &image) &&
             image_write_layer(&image, path, shown_layer_prefix(values->layer));
        image_free(&image);
    } else {
        struct bitmap bitmap;
        if (!read_bitmap(values, renderer, &bitmap))
            return false;
        bool transparent = renderer->desc.background.kind == BACKGROUND_NONE;
        ok = transparent ? bitmap_write_alpha(&bitmap, path) : bitmap_write(&bitmap, path);
        bitmap_free(&bitmap);
    }
    if (ok)
        progress_tell_file(values->progress, path);
    return ok;
}

static bool write_videos(struct render_values *values, struct renderer *renderer) {
    struct bitmap bitmap;
    if (values->videos.begun == 0)
        return true;
    if (!read_bitmap(values, renderer, &bitmap))
        return false;
    bool ok = videos_add(&values->videos, &bitmap);
    bitmap_free(&bitmap);
    return ok;
}

static bool is_there(const struct render_values *values, struct renderer *renderer,
                     const char *path) {
    (void)values;
    return output_is_there(path, renderer->desc.width, renderer->desc.height);
}

/* Frames that are done, and their progress. */
struct work {
    struct progress progress;
    int count, done, skipped; /* frames */
    bool stopped;             /* within a frame, which is not drawn to its end */
};

/* With `share` of the current frame. */
static double share_done(const struct work *work, double share) {
    return (work->done + share) / (work->count - work->skipped);
}

/* Waits for each pass: a GPU would take hundreds at once, and they are not done then. */
static void add_passes(const struct render_values *values, struct renderer *renderer,
                       struct work *work, int frame) {
    for (int i = 0; i < values->passes && !cancel_came(); i++) {
        char note[64] = "";
        renderer_add_pass(renderer, values->first_pass + i);
        gl.Finish();
        if (work->count > 1)
            snprintf(note, sizeof note, "frame %d, ", frame);
        size_t used = strlen(note);
        snprintf(note + used, sizeof note - used, "pass %d of %d", i + 1, values->passes);
        work->progress.pass = i + 1;
        progress_show(&work->progress, share_done(work, (i + 1.) / values->passes), note);
    }
}

static bool write_outputs(struct render_values *values, struct renderer *renderer, int frame) {
    return each_output(values, renderer, frame, write_output) && write_videos(values, renderer);
}

/* Paths make single pictures alone: a sequence would flicker by their noise. */
static bool may_trace(const struct render_values *values) {
    const struct technique_values *named = &values->technique;
    return !values->frames && !values->passes_given && values->first_pass == 0 && !values->aov &&
           !named->technique && !named->direct &&
           !quality_is_preset(named->settings.items, named->settings.count);
}

static bool render_frame(struct render_values *values, struct renderer *renderer,
                         struct stage *stage, struct work *work, int frame) {
    double time = frame_time(values, frame);
    bool ok = true;
    if (values->cameras)
        values->stage.camera = stage->camera_text = values->views.items[frame].camera;
    surface_motion_free(&values->motion);
    if (!stage_pose(stage, time) ||
        (surface_layers_move(values->aov) &&
         !stage_find_motion(stage, time, 1 / values->rate.fps, &values->motion)))
        return false;
    if (values->traced > 0)
        return traced_show(&renderer->desc, stage, values->traced, &work->progress,
                           &values->picture) &&
               write_outputs(values, renderer, frame);
    if (!stage_show(stage, renderer))
        return false;
    cancel_begin(interrupt_asked, NULL, CANCEL_INTERVAL);
    if (values->budget > 0)
        ok = in_time_render(&values->in_time, renderer, stage, time) &&
             (!may_trace(values) ||
              in_time_trace(&values->in_time, renderer, stage, &values->picture, &values->traced));
    else if (has_mean(values))
        add_passes(values, renderer, work, frame);
    else
        renderer_render(renderer);
    work->stopped = cancel_end();
    return ok && !work->stopped && write_outputs(values, renderer, frame);
}

static void tell_start(double picture_ms) {
    phase_add(PHASE_PICTURE, picture_ms);
    char *text = phases_text();
    log_detail("start: %s", text);
    free(text);
}

static bool render_frames(struct render_values *values, const struct frames *frames,
                          struct renderer *renderer, struct stage *stage) {
    struct work work = {.count = frames->count};
    bool ok = true;
    progress_start(&work.progress, "frames");
    work.progress.frame_count = frames->count;
    work.progress.pass_count = has_mean(values) ? values->passes : 0;
    values->progress = &work.progress;
    for (int i = 0; ok && i < frames->count; i++) {
        int frame = frames->numbers[i];
        work.stopped = interrupt_came();
        if (!work.stopped && values->skip_existing &&
            each_output(values, renderer, frame, is_there)) {
            work.skipped++;
            continue;
        }
        work.progress.frame = frame;
        work.progress.pass = 0;
        double start = clock_ms();
        ok = !work.stopped && render_frame(values, renderer, stage, &work, frame);
        if (work.stopped) {
            ok = error_set("stopped before frame %d: %d rendered, %d were there, %d are left%s",
                           frame, work.done, work.skipped, frames->count - i,
                           values->videos.begun ? "; there is no video" : " (--skip-existing)");
            break;
        }
        ok = ok || error_prefix("frame %d", frame);
        char note[32];
        snprintf(note, sizeof note, "frame %d", frame);
        if (work.done++ == 0)
            tell_start(start);
        if (ok)
            progress_show_step(&work.progress, share_done(&work, 0), note);
    }
    double seconds = progress_end(&work.progress);
    values->progress = NULL;
    if (ok && frames->count > 1)
        log_note("%d frames in %.1f s, %d were there", work.done, seconds, work.skipped);
    return ok;
}

/* Which quality was chosen, and why. */
static void print_choice(FILE *out, const struct render_values *values) {
    struct quality_choice named = quality_named((enum quality)values->quality);
    const struct quality_choice traced = QUALITY_TRACED(values->traced);
    char *text = values->max_error > 0 ? mem_strdup(values->choice)
                 : values->traced > 0  ? quality_describe(&traced)
                 : values->budget > 0  ? in_time_describe(&values->in_time)
                                       : quality_describe(&named);
    fprintf(out, "chosen ");
    if (values->budget > 0)
        fprintf(out, "by --budget %gms", (double)values->budget);
    else if (values->max_error > 0)
        fprintf(out, "by --max-error %g%%", 100 * (double)values->max_error);
    else
        fprintf(out, "by --quality %s", quality_names[values->quality]);
    fprintf(out, ": %s\n", text);
    free(text);
}

/* The frame again, as the first one also compiled; a path-traced picture has no passes. */
static void print_stats(const struct render_values *values, struct renderer *renderer) {
    FILE *out = outputs_table_stream(values->outputs.items, values->outputs.count);
    print_choice(out, values);
    if (values->traced > 0)
        return;
    renderer_render(renderer);
    stats_print(out, renderer);
}

static bool render(struct render_values *values, const struct frames *frames,
                   const struct renderer_desc *desc, struct stage *stage) {
    struct renderer renderer = {.desc = *desc}; /* all that a path-traced picture has of it */
    bool traced = values->traced > 0;
    if (!traced && !renderer_init(&renderer, desc))
        return false;
    bool ok = (traced || aov_check(&renderer, values->aov)) &&
              videos_begin(&values->videos, desc->width, desc->height, values->rate.text) &&
              render_frames(values, frames, &renderer, stage);
    ok = videos_end(&values->videos, ok) && ok;
    for (int i = 0; ok && i < values->videos.paths.count; i++)
        progress_tell_file(&(struct progress){.task = "frames"}, values->videos.paths.items[i]);
    if (ok && values->stats)
        print_stats(values, &renderer);
    if (!traced)
        renderer_free(&renderer);
    return ok;
}

/* Chooses by --max-error at frame 0, so that processes that share a sequence agree. */
static bool find_quality(struct render_values *values, struct renderer_desc *desc,
                         struct stage *stage) {
    const struct measure_desc measure = measure_of(desc, stage);
    const struct text_list *texts = &values->technique.settings;
    bool one_pass = values->passes > 0 || aov_needs_pass(values->aov);
    struct quality_found found;
    struct quality_desc wanted = {&measure,
                                  texts->items,
                                  texts->count,
                                  (double)values->max_error,
                                  one_pass ? 1 : QUALITY_MOST_PASSES,
                                  !one_pass && !values->technique.technique,
                                  may_trace(values)};
    if (!stage_pose(stage, (double)values->stage.time) || !quality_find(&wanted, &found))
        return false;
    char *what = quality_describe(&found.choice);
    values->choice = mem_printf("%s, which errs %.1f %%%s", what, 100 * found.error,
                                found.reached ? "" : "; nothing errs much less");
    (found.reached ? log_note : log_warning)("%s: %s", stage->name, values->choice);
    free(what);
    values->traced = found.choice.samples;
    values->picture = found.picture;
    if (values->passes == 0)
        values->passes = found.choice.passes;
    desc->progressive = has_mean(values);
    desc->technique = quality_technique(&found.choice, desc->technique);
    return quality_settings(&found.choice, desc->technique, texts->items, texts->count,
                            &desc->settings) &&
           stage_pose(stage, 0);
}

/* Files are checked before long work, of a sequence by its first frame. The stage begins at time 0,
 * whatever the frames: so all of them come out of the same renderer. */
static bool render_scene(struct render_values *values, const struct frames *frames,
                         struct renderer_desc *desc) {
    struct stage_desc at_0 = values->stage;
    struct stage stage;
    struct context *context;
    at_0.time = 0;
    double start = clock_ms();
    if (!each_output(values, NULL, frames->numbers[0], check_file) ||
        !videos_check(&values->videos) || !stage_init(&stage, &at_0))
        return false;
    phase_add(PHASE_SCENE, start);
    if (!view_list_check(&values->views, &stage.scene, values->cameras)) {
        stage_free(&stage);
        return false;
    }
    desc->keep_lights = values->cameras;
    if (!caustics_shown(&stage.scene, &desc->settings))
        caustics_note_straight(&stage.scene);
    desc->scene = &stage.scene;
    desc->geometry = &stage.geometry;
    desc->camera = stage.camera;
    if (values->size[0] == 0)
        stage_default_size(&stage, values->size);
    desc->width = values->size[0];
    desc->height = values->size[1];
    start = clock_ms();
    context = context_create(&values->context);
    phase_add(PHASE_CONTEXT, start);
    time_budget_init(&values->in_time.budget, (double)values->budget);
    bool ok = context && (values->max_error == 0 || find_quality(values, desc, &stage));
    desc->emitters = stage.emitters; /* which posing makes anew */
    ok = ok && render(values, frames, desc, &stage);
    context_free(context);
    stage_free(&stage);
    return ok;
}

/* A choice has one reason. */
static bool check_choice(const struct render_values *values) {
    bool named = values->quality != QUALITY_NORMAL, by_error = values->max_error > 0;
    if (named && by_error)
        return error_set("--quality and --max-error exclude each other");
    if (by_error && values->cameras)
        return error_set("--max-error excludes --cameras: views may err by more than the first");
    if (values->budget > 0 && (named || by_error || has_mean(values)))
        return error_set("--budget excludes --quality, --max-error and --passes");
    const struct text_list *texts = &values->technique.settings;
    return values->budget == 0 || !quality_is_preset(texts->items, texts->count) ||
           error_set("--budget excludes path=, which sets what it would choose");
}

/* Checks before anything is opened; --max-error and --budget start as the normal quality. */
static bool resolve(struct render_values *values, const struct frames *frames,
                    struct renderer_desc *desc) {
    const struct technique_values *named = &values->technique;
    struct quality_choice choice = quality_named((enum quality)values->quality);
    if (!check_choice(values))
        return false;
    videos_take(&values->videos, &values->outputs);
    values->passes_given = values->passes > 0;
    if (values->passes == 0 && values->max_error == 0)
        values->passes = choice.passes;
    desc->progressive = has_mean(values);
    desc->timed = values->stats || values->budget > 0;
    values->in_time.texts = &named->settings;
    return frame_rate_parse(&values->rate, values->fps ? values->fps : "25") &&
           check_outputs(values, frames->count) &&
           background_parse(&desc->background, values->background) &&
           check_background(values, &desc->background) &&
           technique_values_resolve(named, &desc->technique, &desc->direct, &desc->settings) &&
           quality_settings(&choice, desc->technique, named->settings.items, named->settings.count,
                            &desc->settings);
}

/* Frames are those of --frames; without it all views of --cameras. */
static bool parse_frames(struct render_values *values, struct frames *frames) {
    if (values->cameras && !values->frames)
        values->frames = values->views.all;
    if (!frames_parse(frames, values->frames ? values->frames : "0"))
        return false;
    for (int i = 0; values->cameras && i < frames->count; i++)
        if (frames->numbers[i] < 0 || frames->numbers[i] >= values->views.count)
            return error_set("--frames: there is no view %d in %s, which has %d",
                             frames->numbers[i], values->cameras, values->views.count);
    return true;
}

int app_render(int argc, char **argv) {
    struct render_values values = {0};
    struct frames frames = {0};
    int count, status;
    if (!arguments_parse(&render_arguments, &values, argc, argv, &values.stage.path, &count,
                         &status))
        return status;
    struct renderer_desc desc = {0};
    if (values.cameras && !view_list_read(&values.views, values.cameras))
        return arguments_fail(argv[0]);
    if (!parse_frames(&values, &frames) || !resolve(&values, &frames, &desc)) {
        view_list_free(&values.views);
        frames_free(&frames);
        return arguments_misuse(argv[0]);
    }
    glsl_set_folder(values.glsl);
    bool is_sequence = frames.count > 1;
    if (is_sequence)
        interrupts_hold();
    bool ok = render_scene(&values, &frames, &desc);
    frames_free(&frames);
    free(values.choice);
    image_free(&values.picture);
    surface_motion_free(&values.motion);
    view_list_free(&values.views);
    if (ok)
        return STATUS_OK;
    status = arguments_fail(argv[0]);
    if (is_sequence)
        interrupts_release();
    return status;
}
