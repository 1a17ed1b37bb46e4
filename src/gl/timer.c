#include "gl/timer.h"

#include "base/clock.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

void timers_init(struct timers *timers, bool enabled, bool software) {
    *timers = (struct timers){.enabled = enabled, .finish = software};
    if (!enabled || software)
        return;
    for (int i = 0; i < TIMER_RING; i++)
        gl.CreateQueries(GL_TIMESTAMP, 2 * TIMER_SPANS_MAX, timers->ring[i].queries);
}

void timers_free(struct timers *timers) {
    for (int i = 0; i < TIMER_RING; i++)
        if (timers->ring[i].queries[0])
            gl.DeleteQueries(2 * TIMER_SPANS_MAX, timers->ring[i].queries);
    *timers = (struct timers){0};
}

static int find_or_add(struct timers *timers, const char *name) {
    char path[2 * TIMER_PATH_SIZE];
    int parent = timers->stack_size ? timers->stack[timers->stack_size - 1].timer : -1;
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
    GLint ready = 1;
    if (!wait) /* the frame itself ends last */
        gl.GetQueryObjectiv(slot->queries[1], GL_QUERY_RESULT_AVAILABLE, &ready);
    if (!ready)
        return false;
    for (int i = 0; i < timers->count; i++)
        timers->results[i].ms = 0;
    for (int i = 0; i < slot->span_count; i++) {
        GLuint64 begin, end;
        gl.GetQueryObjectui64v(slot->queries[2 * i], GL_QUERY_RESULT, &begin);
        gl.GetQueryObjectui64v(slot->queries[2 * i + 1], GL_QUERY_RESULT, &end);
        timers->results[slot->timer_of[i]].ms += (double)(end - begin) * 1e-6;
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
    slot->span_count = 0;
}

/* Where the slot has room, the next span, begun; else -1. */
static int begin_span(struct timer_slot *slot, int timer) {
    if (slot->span_count == TIMER_SPANS_MAX)
        return -1;
    gl.QueryCounter(slot->queries[2 * slot->span_count], GL_TIMESTAMP);
    slot->timer_of[slot->span_count] = timer;
    return slot->span_count++;
}

void timer_begin(struct timers *timers, const char *name) {
    gl.PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name);
    if (!timers->enabled)
        return;
    if (timers->stack_size == 0)
        begin_frame(timers);
    assert(timers->stack_size < TIMER_DEPTH);
    struct timer_open open = {find_or_add(timers, name), -1};
    if (timers->finish) {
        gl.Finish();
        timers->started[open.timer] = clock_ms();
    } else {
        open.span = begin_span(&timers->ring[timers->slot], open.timer);
    }
    timers->stack[timers->stack_size++] = open;
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
        struct timer_open open = timers->stack[--timers->stack_size];
        if (timers->finish) {
            gl.Finish();
            timers->elapsed[open.timer] += clock_ms() - timers->started[open.timer];
        } else if (open.span >= 0) {
            gl.QueryCounter(timers->ring[timers->slot].queries[2 * open.span + 1], GL_TIMESTAMP);
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
