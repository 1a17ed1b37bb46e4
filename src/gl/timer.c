#define _POSIX_C_SOURCE 199309L
#include "gl/timer.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

static double now_ms(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec * 1e3 + (double)now.tv_nsec * 1e-6;
}

void timers_init(struct timers *timers, bool enabled, bool software) {
    *timers = (struct timers){.enabled = enabled, .finish = software};
    if (!enabled || software)
        return;
    for (int i = 0; i < TIMER_RING; i++)
        gl.CreateQueries(GL_TIMESTAMP, 2 * TIMERS_MAX, timers->ring[i].queries);
}

void timers_free(struct timers *timers) {
    for (int i = 0; i < TIMER_RING; i++)
        if (timers->ring[i].queries[0])
            gl.DeleteQueries(2 * TIMERS_MAX, timers->ring[i].queries);
    *timers = (struct timers){0};
}

static int find_or_add(struct timers *timers, const char *name) {
    char path[2 * TIMER_PATH_SIZE];
    int parent = timers->stack_size ? timers->stack[timers->stack_size - 1] : -1;
    snprintf(path, sizeof path, "%s%s%.60s", parent < 0 ? "" : timers->results[parent].path,
             parent < 0 ? "" : "/", name);
    for (int i = 0; i < timers->count; i++)
        if (strcmp(timers->results[i].path, path) == 0)
            return i;
    assert(timers->count < TIMERS_MAX && strlen(path) < TIMER_PATH_SIZE);
    struct timer_result *result = &timers->results[timers->count];
    memcpy(result->path, path, strlen(path) + 1);
    result->depth = timers->stack_size;
    return timers->count++;
}

/* Moves a slot's times into the results; false when they are not ready and wait is false. */
static bool read_slot(struct timers *timers, struct timer_slot *slot, bool wait) {
    if (!slot->pending)
        return true;
    int last = slot->used[slot->used_count - 1];
    GLint ready = 1;
    if (!wait)
        gl.GetQueryObjectiv(slot->queries[2 * last + 1], GL_QUERY_RESULT_AVAILABLE, &ready);
    if (!ready)
        return false;
    for (int i = 0; i < slot->used_count; i++) {
        int timer = slot->used[i];
        GLuint64 begin, end;
        gl.GetQueryObjectui64v(slot->queries[2 * timer], GL_QUERY_RESULT, &begin);
        gl.GetQueryObjectui64v(slot->queries[2 * timer + 1], GL_QUERY_RESULT, &end);
        timers->results[timer].ms = (double)(end - begin) * 1e-6;
    }
    slot->pending = false;
    return true;
}

static void begin_frame(struct timers *timers) {
    memset(timers->elapsed, 0, sizeof timers->elapsed);
    if (timers->finish)
        return;
    for (int i = 1; i <= TIMER_RING; i++)
        if (!read_slot(timers, &timers->ring[(timers->slot + i) % TIMER_RING], false))
            break;
    timers->slot = (timers->slot + 1) % TIMER_RING;
    struct timer_slot *slot = &timers->ring[timers->slot];
    read_slot(timers, slot, true); /* the ring is full: only now we wait */
    slot->used_count = 0;
}

void timer_begin(struct timers *timers, const char *name) {
    gl.PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name);
    if (!timers->enabled)
        return;
    if (timers->stack_size == 0)
        begin_frame(timers);
    assert(timers->stack_size < TIMER_DEPTH);
    int timer = find_or_add(timers, name);
    timers->stack[timers->stack_size++] = timer;
    if (timers->finish) {
        gl.Finish();
        timers->started[timer] = now_ms();
    } else {
        gl.QueryCounter(timers->ring[timers->slot].queries[2 * timer], GL_TIMESTAMP);
    }
}

static void end_frame(struct timers *timers) {
    if (timers->finish)
        for (int i = 0; i < timers->count; i++)
            timers->results[i].ms = timers->elapsed[i];
    else
        timers->ring[timers->slot].pending = true;
}

void timer_end(struct timers *timers) {
    if (timers->enabled) {
        int timer = timers->stack[--timers->stack_size];
        if (timers->finish) {
            gl.Finish();
            timers->elapsed[timer] += now_ms() - timers->started[timer];
        } else {
            struct timer_slot *slot = &timers->ring[timers->slot];
            gl.QueryCounter(slot->queries[2 * timer + 1], GL_TIMESTAMP);
            slot->used[slot->used_count++] = timer;
        }
        if (timers->stack_size == 0)
            end_frame(timers);
    }
    gl.PopDebugGroup();
}

void timers_flush(struct timers *timers) {
    if (!timers->enabled || timers->finish)
        return;
    for (int i = 1; i <= TIMER_RING; i++)
        read_slot(timers, &timers->ring[(timers->slot + i) % TIMER_RING], true);
}

double timer_ms(const struct timers *timers, const char *path) {
    for (int i = 0; i < timers->count; i++)
        if (strcmp(timers->results[i].path, path) == 0)
            return timers->results[i].ms;
    return 0;
}
