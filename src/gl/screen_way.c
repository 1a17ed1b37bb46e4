/* How screen passes run: told, or timed. */
#include "base/clock.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/screen.h"

#include <math.h>
#include <stdatomic.h>

const char *const screen_way_names[] = {"auto", "fragment", "compute", NULL};

/* A setting of the process, so that what one context compiles others may take. */
static atomic_int chosen = SCREEN_AUTO;

/* What a thread times now: other threads make programs and masks meanwhile, all of which must run
 * in one way. */
static _Thread_local enum screen_way timed = SCREEN_AUTO;

void screen_set_way(enum screen_way way) {
    atomic_store(&chosen, (int)way);
}

/* Chips that rasterise with a small part of themselves take many times as long; of two that are
 * equal the one with fewer barriers is better. */
static const double least_gain = .9;

enum { PROBE_SIZE = 512, PROBE_TRIES = 5 };

/* The first try may compile. Timer queries of software OpenGL leave out what it defers. */
static double time_pass(const struct pass_state *state) {
    double least = HUGE_VAL;
    for (int i = 0; i < PROBE_TRIES; i++) {
        gl.Finish();
        double start = clock_ms();
        pass_set_state(state);
        pass_draw_fullscreen(1);
        gl.Finish();
        least = fmin(least, clock_ms() - start);
    }
    return least;
}

/* Milliseconds; infinite where it does not run. */
static double time_way(enum screen_way way, GLuint framebuffer) {
    struct pass_state state = {.name = "screen probe",
                               .framebuffer = framebuffer,
                               .width = PROBE_SIZE,
                               .height = PROBE_SIZE};
    double time = HUGE_VAL;
    timed = way;
    if (program_init(&state.program,
                     &(struct program_desc){.screen = {.body = "screen_probe.frag"}}))
        time = time_pass(&state);
    program_free(&state.program);
    timed = SCREEN_AUTO;
    return time;
}

bool screen_time_ways(struct screen_times *times) {
    struct texture target = {0};
    GLuint framebuffer = 0;
    *times = (struct screen_times){HUGE_VAL, HUGE_VAL};
    bool ok = texture_init(&target, &(struct texture_desc){.label = "screen probe",
                                                           .format = GL_RGBA32F,
                                                           .width = PROBE_SIZE,
                                                           .height = PROBE_SIZE}) &&
              framebuffer_init(&framebuffer, &(struct framebuffer_desc){.label = "screen probe",
                                                                        .colors = {&target}});
    if (ok) {
        times->drawn = time_way(SCREEN_FRAGMENT, framebuffer);
        times->dispatched = time_way(SCREEN_COMPUTE, framebuffer);
    }
    framebuffer_free(&framebuffer);
    texture_free(&target);
    return ok;
}

/* A CPU has no part that only one of both uses: there the rasteriser is the faster one, and its
 * compiler is what timing would cost. */
static enum screen_way faster_way(void) {
    struct screen_times times;
    if (gl.software || !screen_time_ways(&times))
        return SCREEN_FRAGMENT;
    return times.dispatched < least_gain * times.drawn ? SCREEN_COMPUTE : SCREEN_FRAGMENT;
}

/* Of threads that time at once the first decides. */
enum screen_way screen_way(void) {
    int undecided = SCREEN_AUTO;
    if (timed != SCREEN_AUTO)
        return timed;
    if (atomic_load(&chosen) == SCREEN_AUTO)
        atomic_compare_exchange_strong(&chosen, &undecided, (int)faster_way());
    return (enum screen_way)atomic_load(&chosen);
}
