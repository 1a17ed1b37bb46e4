#include "apps/bench_measure.h"

#include "base/clock.h"
#include "base/error.h"
#include "base/log.h"
#include "base/memory.h"
#include "gl/memory.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of the difference between timers and clock, over the clock: above it something is wrong. */
static const double clock_tolerance = .2;

struct bench_protocol bench_protocol_of(bool software) {
    return (struct bench_protocol){
        .warm_up = software ? 1 : 10,
        .frames = software ? 5 : 100,
        .burst = software ? 1 : 8,
        .software = software,
    };
}

bool bench_case_start(struct renderer *renderer, const struct bench_case *prepared,
                      const struct stage *stage, bool software) {
    struct renderer_desc desc = {
        .width = prepared->width,
        .height = prepared->height,
        .technique = prepared->technique,
        .settings = prepared->settings,
        .scene = &stage->scene,
        .geometry = &stage->geometry,
        .light = stage->emitters.items[0],
        .camera = stage->camera,
        .timed = true,
        .software = software,
    };
    *renderer = (struct renderer){0};
    return (technique_check(prepared->technique, &prepared->settings) &&
            renderer_init(renderer, &desc)) ||
           error_prefix("%s, %s %s", prepared->scene, prepared->series, prepared->label);
}

/* The samples of one case: a row of frames per timer, and the clock. */
struct samples {
    float *timers[TIMERS_MAX], *wall;
    int taken;
};

static void samples_init(struct samples *samples, int frames) {
    for (int i = 0; i < TIMERS_MAX; i++)
        samples->timers[i] = mem_alloc((size_t)frames, sizeof(float));
    samples->wall = mem_alloc((size_t)frames, sizeof(float));
    samples->taken = 0;
}

static void samples_free(struct samples *samples) {
    for (int i = 0; i < TIMERS_MAX; i++)
        free(samples->timers[i]);
    free(samples->wall);
}

static double clocked_frames(struct renderer *renderer, int frames) {
    renderer->timers.enabled = false;
    gl.Finish();
    double start = clock_ms();
    for (int i = 0; i < frames; i++)
        renderer_render(renderer);
    gl.Finish();
    double ms = (clock_ms() - start) / frames;
    renderer->timers.enabled = true;
    return ms;
}

static void take_sample(struct renderer *renderer, struct samples *samples, int burst) {
    renderer_render(renderer);
    timers_flush(&renderer->timers);
    int at = samples->taken++;
    for (int i = 0; i < renderer->timers.count; i++)
        samples->timers[i][at] = (float)renderer->timers.results[i].ms;
    samples->wall[at] = (float)clocked_frames(renderer, burst);
}

static void summarise(struct bench_case *measured, const struct renderer *renderer,
                      struct samples *samples) {
    measured->pass_count = renderer->timers.count;
    for (int i = 0; i < measured->pass_count; i++) {
        struct bench_pass *pass = &measured->passes[i];
        memcpy(pass->path, renderer->timers.results[i].path, sizeof pass->path);
        pass->depth = renderer->timers.results[i].depth;
        pass->ms = summary_of(samples->timers[i], samples->taken);
    }
    measured->wall_ms = summary_of(samples->wall, samples->taken);
}

/* Timers that tell another story than the clock are not to be believed: drivers lie. */
static void check_clock(const struct bench_case *measured) {
    double frame = bench_frame_ms(measured), wall = measured->wall_ms.median;
    if (fabs(frame - wall) > clock_tolerance * wall)
        log_warning("%s, %s%s%s: the timers say %.3g ms a frame, the clock %.3g ms%s",
                    measured->scene, measured->series, *measured->label ? " " : "", measured->label,
                    frame, wall,
                    frame < wall ? " (the CPU is the slower one, or the timers lie)" : "");
}

static bool start_all(struct renderer *renderers, struct bench_case *cases, int count,
                      const struct stage *stage, const struct bench_protocol *protocol) {
    for (int i = 0; i < count; i++) {
        size_t before = gpu_memory_total();
        if (!bench_case_start(&renderers[i], &cases[i], stage, protocol->software))
            return false;
        cases[i].faces = geometry_triangle_count(&stage->geometry);
        cases[i].gpu_memory = (double)(gpu_memory_total() - before) / (1 << 20);
        for (int frame = 0; frame < protocol->warm_up; frame++)
            clocked_frames(&renderers[i], 1);
    }
    return true;
}

static bool measure_all(struct renderer *renderers, struct bench_case *cases, int count,
                        const struct bench_protocol *protocol) {
    struct samples samples[BENCH_GROUP];
    for (int i = 0; i < count; i++)
        samples_init(&samples[i], protocol->frames);
    for (int round = 0; round < protocol->frames; round++)
        for (int i = 0; i < count; i++)
            take_sample(&renderers[i], &samples[i], protocol->burst);
    bool ok = true;
    for (int i = 0; i < count; i++) {
        summarise(&cases[i], &renderers[i], &samples[i]);
        samples_free(&samples[i]);
        check_clock(&cases[i]);
        ok = ok &&
             (!protocol->inspect || protocol->inspect(protocol->user, &cases[i], &renderers[i]));
    }
    return ok;
}

bool bench_measure(struct bench_case *cases, int count, const struct stage *stage,
                   const struct bench_protocol *protocol) {
    assert(count <= BENCH_GROUP && protocol->frames > 0);
    struct renderer *renderers = mem_alloc((size_t)count, sizeof *renderers);
    bool ok = start_all(renderers, cases, count, stage, protocol) &&
              measure_all(renderers, cases, count, protocol);
    for (int i = 0; i < count; i++)
        if (renderers[i].technique)
            renderer_free(&renderers[i]);
    free(renderers);
    return ok;
}
