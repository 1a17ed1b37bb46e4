#include "lab/measure/timing.h"

#include "lab/measure/errors.h"
#include "lab/measure/baseline.h"
#include "base/clock.h"
#include "base/file/image_file.h"
#include "base/log.h"
#include "base/memory.h"
#include "gl/memory.h"
#include "inspect/aov.h"
#include "base/error.h"

#include <math.h>

/* The layers' first channels; noise: of what holds the share, the standard error. */
struct layers {
    int test, direct, unshadowed, visibility, noise;
};

static bool find_layer(const struct image *image, const char *name, int *first) {
    int channels[3];
    *first = 0;
    if (!image_find_layer(image, name, channels))
        return false;
    *first = channels[0];
    return true;
}

static bool find_noise(const struct image *reference, bool of_sky, int *channel) {
    const char *name = of_sky ? "standard_error.direct.Y" : "standard_error.visibility.Y";
    *channel = image_find_channel(reference, name);
    return *channel >= 0 || error_set("no channel %s", name);
}

/* Mean of three adjacent channels. */
static double grey(const struct image *image, int x, int y, int first) {
    const float *pixel = image_at(image, x, y) + first;
    return (double)(pixel[0] + pixel[1] + pixel[2]) / 3;
}

static double share_of(double light, double unshadowed) {
    return fmin(fmax(light / unshadowed, 0), 1);
}

static double brightest(const struct image *reference, int first) {
    double most = 0;
    for (int y = 0; y < reference->height; y++)
        for (int x = 0; x < reference->width; x++)
            most = fmax(most, grey(reference, x, y, first));
    return most;
}

struct sums {
    double squares, sum, noise_squares, count;
};

static void add(struct sums *sums, double off, double noise) {
    sums->squares += off * off;
    sums->noise_squares += noise * noise;
    sums->sum += off;
    sums->count++;
}

static double percent(double squares, double count) {
    return 100 * sqrt(fmax(squares, 0) / fmax(count, 1));
}

static double rms(const struct sums *sums) {
    return percent(sums->squares - sums->noise_squares, sums->count);
}

static void add_all(struct results *results, const struct sums *all, const struct sums *bright) {
    const char *against = reference_names[REFERENCE_SEEN];
    results_add(results, "visible-share", against, "%", rms(bright));
    results_add(results, "visible-bias", against, "%", 100 * bright->sum / fmax(bright->count, 1));
    results_add(results, "visible-share-all", against, "%", rms(all));
    results_add(results, "visible-noise", against, "%",
                percent(bright->noise_squares, bright->count));
}

/* Adds "visible-share" and "visible-bias": RMS and mean of the visible share minus the reference's,
 * in %. They are over pixels with at least a hundredth of the brightest unshadowed light.
 * "visible-share-all" is the RMS over all pixels with unshadowed light; a few pixels where facets
 * turn away are most of it. The noise of the reference, "visible-noise", is subtracted as squares.
 *
 * The share is direct light over unshadowed direct light. The reference's share is the tracer's
 * visibility; for a sky it is the tracer's direct light over the same. reference: with the layers
 * of path_tracer_desc.seen. Error: a layer is missing. */
static bool shares_add(struct results *results, const struct image *test,
                       const struct image *reference, bool of_sky) {
    struct layers at;
    struct sums all = {0}, bright = {0};
    if (!find_layer(test, "direct", &at.test) || !find_layer(reference, "direct", &at.direct) ||
        !find_layer(reference, "unshadowed", &at.unshadowed) ||
        !find_layer(reference, "visibility", &at.visibility) ||
        !find_noise(reference, of_sky, &at.noise))
        return error_prefix("visible share");
    double least = .01 * brightest(reference, at.unshadowed);
    for (int y = 0; y < reference->height; y++)
        for (int x = 0; x < reference->width; x++) {
            double unshadowed = grey(reference, x, y, at.unshadowed);
            if (!(unshadowed > 0))
                continue;
            double seen = of_sky ? share_of(grey(reference, x, y, at.direct), unshadowed)
                                 : grey(reference, x, y, at.visibility);
            double off = share_of(grey(test, x, y, at.test), unshadowed) - seen;
            double noise = (double)image_at(reference, x, y)[at.noise] / (of_sky ? unshadowed : 1);
            add(&all, off, noise);
            if (unshadowed >= least)
                add(&bright, off, noise);
        }
    add_all(results, &all, &bright);
    return true;
}

/* Of the difference between timers and clock, over the clock: above it something is wrong. */
static const double clock_tolerance = .2;

/* What the rounds of a group may take before it takes in no further subject. */
static const double group_ms = 20e3;

/* A subject at work. */
struct run {
    const struct measure_desc *desc;
    struct renderer renderer;
    double gpu_memory; /* MiB */
    float *samples;    /* a row of frames for each timer, the clock, and the CPU */
    int frames;
    bool whole_frames;
};

enum { CLOCK = TIMERS_MAX, CPU, ROWS };

/* Subjects that take turns. */
struct group {
    struct results *results;
    struct run runs[TIMING_GROUP];
    int count, frames, warm_up;
    bool whole_frames;
    const char *picture;
};

static float *row_of(const struct run *run, int row) {
    return run->samples + (size_t)row * (size_t)run->frames;
}

static bool run_start(struct run *run, const struct measure_desc *desc, const struct group *group) {
    size_t before = gpu_memory_total();
    *run = (struct run){.desc = desc, .frames = group->frames, .whole_frames = group->whole_frames};
    run->samples = mem_alloc(ROWS * (size_t)run->frames, sizeof *run->samples);
    bool ok = measure_start(&run->renderer, desc);
    run->gpu_memory = (double)(gpu_memory_total() - before) / (1 << 20);
    return ok;
}

static void run_free(struct run *run) {
    renderer_free(&run->renderer);
    free(run->samples);
}

/* Milliseconds a frame, by the clock and of the CPU. */
static void clock_frames(struct renderer *renderer, int frames, float *clock, float *cpu) {
    renderer->timers.enabled = false;
    gl.Finish();
    double start = clock_ms(), cpu_start = clock_cpu_ms();
    for (int i = 0; i < frames; i++)
        renderer_render(renderer);
    gl.Finish();
    *clock = (float)((clock_ms() - start) / frames);
    *cpu = (float)((clock_cpu_ms() - cpu_start) / frames);
    renderer->timers.enabled = true;
}

/* Frames between two looks at the clock: more on a GPU, where one would be too short. */
static int burst(void) {
    return gl.software ? 1 : 8;
}

static void time_passes(struct run *run, int at) {
    struct timers *timers = &run->renderer.timers;
    renderer_render(&run->renderer);
    timers_flush(timers);
    for (int i = 0; i < timers->count; i++)
        row_of(run, i)[at] = (float)timers->results[i].ms;
}

static void take_sample(struct run *run, int at) {
    if (!run->whole_frames)
        time_passes(run, at);
    clock_frames(&run->renderer, burst(), &row_of(run, CLOCK)[at], &row_of(run, CPU)[at]);
}

/* Timers that tell another story than the clock are not to be believed: drivers lie. */
static void check_clock(const struct run *run, double frame, double clock) {
    if (fabs(frame - clock) > clock_tolerance * clock)
        log_warning("%s, %s %s: the timers say %.3g ms a frame, the clock %.3g ms%s",
                    run->desc->stage->name, run->desc->variant, run->desc->point, frame, clock,
                    frame < clock ? " (the CPU is the slower one, or the timers lie)" : "");
}

static void add_passes(struct results *results, const struct run *run, double clock) {
    const struct timers *timers = &run->renderer.timers;
    for (int i = 0; i < timers->count; i++) {
        struct summary pass = summary_of(row_of(run, i), run->frames);
        results_add_summary(results, timers->results[i].path, "", "ms", &pass);
        if (i == 0)
            check_clock(run, pass.value, clock);
    }
}

/* first: the subject that the others are compared with. */
static void add_times(struct results *results, struct run *run, int first) {
    struct summary clock = summary_of(row_of(run, CLOCK), run->frames);
    struct summary cpu = summary_of(row_of(run, CPU), run->frames);
    results_begin(results, run->desc);
    if (!run->whole_frames)
        add_passes(results, run, clock.value);
    results_add_summary(results, "clock", "", "ms", &clock);
    results_add_summary(results, "cpu", "", "ms", &cpu);
    results_add(results, "fps", "", "1/s", 1e3 / clock.value);
    results_add(results, "of-first", "", "1",
                clock.value / results_value(results, first, "clock", NULL));
    results_add(results, "gpu-memory", "", "MiB", run->gpu_memory);
}

static bool compare(struct results *results, struct run *run, enum reference_kind kind,
                    struct image *frame, const struct image *exact) {
    if (kind == REFERENCE_SEEN)
        return shares_add(results, frame, exact, run->desc->stage->emitters.sky);
    if (kind == REFERENCE_AO)
        return aov_append(&run->renderer, "ao", NULL, frame) &&
               errors_add_ao(results, frame, exact, reference_names[kind]);
    return errors_add(results, frame, exact, reference_names[kind]);
}

static bool add_errors(struct results *results, struct run *run,
                       const struct reference_desc *reference) {
    struct image frame = {0}, exact = {0};
    bool ok = reference->kind == REFERENCE_NONE ||
              (reference_get(reference, run->desc, &exact) &&
               renderer_read_layers(&run->renderer, &frame) &&
               compare(results, run, reference->kind, &frame, &exact));
    images_free(&frame, &exact);
    baseline_add_ratios(results);
    return ok;
}

static bool write_picture(struct renderer *renderer, const char *path) {
    struct image frame = {0};
    bool ok = renderer_read_layers(renderer, &frame) && image_write(&frame, path);
    image_free(&frame);
    return ok;
}

/* Adds what its rounds will take, by its last frame. */
static bool join(struct group *group, const struct measure_desc *desc, double *ms) {
    struct run *run = &group->runs[group->count++];
    double start = 0;
    results_tell_work(group->results, desc, 0);
    if (!run_start(run, desc, group))
        return false;
    for (int frame = 0; frame < group->warm_up; frame++) {
        start = clock_ms();
        renderer_render(&run->renderer);
        gl.Finish();
        if (frame == 0 && group->picture && !write_picture(&run->renderer, group->picture))
            return false;
    }
    *ms += (clock_ms() - start) * (!group->whole_frames + burst()) * group->frames;
    return true;
}

/* What is slow has few beside it, as the rows of all come at the end of the rounds: who ends a run
 * loses no more. */
static bool gather(struct group *group, const struct measure_desc *descs, int count) {
    double ms = 0;
    bool ok = true;
    while (ok && group->count < count && group->count < TIMING_GROUP &&
           (group->count < TIMING_GROUP_LEAST || ms < group_ms))
        ok = join(group, &descs[group->count], &ms);
    return ok;
}

static void take_rounds(struct group *group) {
    for (int round = 0; round < group->frames; round++)
        for (int i = 0; i < group->count; i++) {
            double rounds = round + (double)i / group->count;
            results_tell_work(group->results, group->runs[i].desc,
                              rounds / group->frames * group->count);
            take_sample(&group->runs[i], round);
        }
}

/* Returns how many subjects were measured; 0: an error. */
static int measure_group(struct results *results, int first, const struct measure_desc *descs,
                         int count, const struct timing_desc *timing) {
    struct group group = {
        .results = results,
        .frames = timing->frames ? timing->frames
                  : gl.software  ? 5
                                 : 100,
        .warm_up = timing->warm_up ? timing->warm_up
                   : gl.software   ? 1
                                   : 10,
        .whole_frames = timing->whole_frames,
        .picture = timing->picture,
    };
    bool ok = gather(&group, descs, count);
    if (ok)
        take_rounds(&group);
    for (int i = 0; i < group.count; i++) {
        if (ok) {
            add_times(results, &group.runs[i], first);
            ok = add_errors(results, &group.runs[i], &timing->reference) && results_commit(results);
        }
        run_free(&group.runs[i]);
    }
    return ok ? group.count : 0;
}

bool timing_measure(struct results *results, const struct measure_list *subjects,
                    const struct timing_desc *timing) {
    int base = results->subject_count;
    for (int i = 0, count; i < subjects->count; i += count) {
        count = measure_group(results, base, &subjects->items[i], subjects->count - i, timing);
        if (count == 0)
            return false;
    }
    return true;
}
