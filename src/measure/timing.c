#include "measure/timing.h"

#include "base/clock.h"
#include "base/log.h"
#include "base/memory.h"
#include "gl/memory.h"
#include "measure/errors.h"
#include "measure/rival.h"
#include "measure/shares.h"

#include <math.h>
#include <stdlib.h>

/* Of the difference between timers and clock, over the clock: above it something is wrong. */
static const double clock_tolerance = .2;

/* A subject at work. */
struct run {
    const struct measure_desc *desc;
    struct renderer renderer;
    double gpu_memory; /* MiB */
    float *samples;    /* a row of frames for each timer, the clock, and the CPU */
    int frames;
};

enum { CLOCK = TIMERS_MAX, CPU, ROWS };

static float *row_of(const struct run *run, int row) {
    return run->samples + (size_t)row * (size_t)run->frames;
}

static bool run_start(struct run *run, const struct measure_desc *desc, int frames) {
    size_t before = gpu_memory_total();
    *run = (struct run){.desc = desc, .frames = frames};
    run->samples = mem_alloc(ROWS * (size_t)frames, sizeof *run->samples);
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
static void take_sample(struct run *run, int at) {
    struct timers *timers = &run->renderer.timers;
    int burst = gl.software ? 1 : 8;
    renderer_render(&run->renderer);
    timers_flush(timers);
    for (int i = 0; i < timers->count; i++)
        row_of(run, i)[at] = (float)timers->results[i].ms;
    clock_frames(&run->renderer, burst, &row_of(run, CLOCK)[at], &row_of(run, CPU)[at]);
}

/* Timers that tell another story than the clock are not to be believed: drivers lie. */
static void check_clock(const struct run *run, double frame, double clock) {
    if (fabs(frame - clock) > clock_tolerance * clock)
        log_warning("%s, %s %s: the timers say %.3g ms a frame, the clock %.3g ms%s",
                    run->desc->stage->name, run->desc->variant, run->desc->point, frame, clock,
                    frame < clock ? " (the CPU is the slower one, or the timers lie)" : "");
}

/* first: the subject that the others are compared with. */
static void add_times(struct results *results, struct run *run, int first) {
    const struct timers *timers = &run->renderer.timers;
    struct summary clock = summary_of(row_of(run, CLOCK), run->frames);
    struct summary cpu = summary_of(row_of(run, CPU), run->frames);
    results_begin(results, run->desc);
    for (int i = 0; i < timers->count; i++) {
        struct summary pass = summary_of(row_of(run, i), run->frames);
        results_add_summary(results, timers->results[i].path, "", "ms", &pass);
        if (i == 0)
            check_clock(run, pass.value, clock.value);
    }
    results_add_summary(results, "clock", "", "ms", &clock);
    results_add_summary(results, "cpu", "", "ms", &cpu);
    results_add(results, "fps", "", "1/s", 1e3 / clock.value);
    results_add(results, "of-first", "", "1",
                clock.value / results_value(results, first, "clock", NULL));
    results_add(results, "gpu-memory", "", "MiB", run->gpu_memory);
}

static bool add_errors(struct results *results, struct run *run, const struct truth_desc *truth) {
    struct image frame = {0}, reference = {0};
    bool ok =
        truth->kind == TRUTH_NONE ||
        (truth_get(truth, run->desc, &reference) && renderer_read_layers(&run->renderer, &frame) &&
         (truth->kind == TRUTH_SEEN
              ? shares_add(results, &frame, &reference, run->desc->stage->emitters.sky)
              : errors_add(results, &frame, &reference, truth_names[truth->kind])));
    image_free(&frame);
    image_free(&reference);
    rival_add_ratios(results);
    return ok;
}

static bool measure_group(struct results *results, int first, struct run *runs,
                          const struct measure_desc *descs, int count,
                          const struct timing_desc *timing) {
    bool ok = true;
    int frames = timing->frames ? timing->frames : gl.software ? 5 : 100;
    int warm_up = timing->warm_up ? timing->warm_up : gl.software ? 1 : 10;
    for (int i = 0; i < count; i++) {
        if (!run_start(&runs[i], &descs[i], frames))
            return false;
        for (int frame = 0; frame < warm_up; frame++)
            renderer_render(&runs[i].renderer);
    }
    for (int round = 0; round < frames; round++)
        for (int i = 0; i < count; i++)
            take_sample(&runs[i], round);
    for (int i = 0; ok && i < count; i++) {
        add_times(results, &runs[i], first);
        ok = add_errors(results, &runs[i], &timing->truth);
    }
    return ok;
}

bool timing_measure(struct results *results, const struct measure_list *subjects,
                    const struct timing_desc *timing) {
    int base = results->subject_count;
    bool ok = true;
    for (int first = 0; ok && first < subjects->count; first += TIMING_GROUP) {
        int left = subjects->count - first, group = left < TIMING_GROUP ? left : TIMING_GROUP;
        struct run *runs = mem_alloc((size_t)group, sizeof *runs);
        ok = measure_group(results, base, runs, &subjects->items[first], group, timing);
        for (int i = 0; i < group; i++)
            run_free(&runs[i]);
        free(runs);
    }
    return ok;
}
