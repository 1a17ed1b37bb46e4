#include "viewer/window/events.h"

#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

static bool goes_on(struct event *last, const struct event *event) {
    if (last->kind != event->kind)
        return false;
    if (event->kind == EVENT_CURSOR)
        *last = *event;
    if (event->kind == EVENT_SCROLL)
        last->y += event->y;
    return event->kind == EVENT_CURSOR || event->kind == EVENT_SCROLL;
}

void events_add(struct events *events, const struct event *event) {
    if (events->count > 0 && goes_on(&events->items[events->count - 1], event))
        return;
    if (events->count == events->capacity) {
        events->capacity = events->capacity ? 2 * events->capacity : 64;
        events->items = mem_resize(events->items, (size_t)events->capacity, sizeof *events->items);
    }
    events->items[events->count++] = *event;
}

/* Whether the n-th comes too late for the turn of those before it. */
static bool is_late(const struct events *events, int n) {
    const struct event *event = &events->items[n];
    if (event->kind != EVENT_KEY && event->kind != EVENT_TEXT)
        return true;
    for (int i = 0; i < n; i++) {
        const struct event *before = &events->items[i];
        if (before->kind != EVENT_KEY && before->kind != event->kind)
            return true;
        if (before->kind == EVENT_KEY && event->kind == EVENT_KEY &&
            (before->down || before->code == event->code))
            return true;
    }
    return false;
}

int events_of_turn(const struct events *events) {
    int count = events->count > 0;
    while (count < events->count && count < EVENTS_OF_TURN && !is_late(events, count))
        count++;
    return count;
}

void events_drop(struct events *events, int count) {
    if (count == 0)
        return;
    events->count -= count;
    memmove(events->items, events->items + count, (size_t)events->count * sizeof *events->items);
}

void events_free(struct events *events) {
    free(events->items);
    *events = (struct events){0};
}
