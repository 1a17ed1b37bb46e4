/* Hands on the events of a window, in their order, by turns. A key that is pressed and released
 * during one slow frame is pressed in one turn and released in a later one. Each press keeps the
 * modifiers of its time, so nothing is lost or typed with a wrong modifier. */
#ifndef VIEWER_WINDOW_EVENTS_H
#define VIEWER_WINDOW_EVENTS_H

#include <stdbool.h>

enum { EVENTS_OF_TURN = 32 }; /* at most */

struct event {
    enum event_kind { EVENT_KEY, EVENT_TEXT, EVENT_BUTTON, EVENT_CURSOR, EVENT_SCROLL } kind;
    int code; /* key, button or character of the system */
    int modifiers;
    bool down;
    double x, y; /* place of the cursor, or steps of the wheel */
};

/* A queue. Zeroed: empty. */
struct events {
    struct event *items;
    int count, capacity;
};

/* Adds an event. Merges it with the last one if both are of the cursor or the wheel. */
void events_add(struct events *events, const struct event *event);

/* Returns how many of the first events make one turn, at least one if there is any. The cursor
 * moves to one place; a button or the wheel comes alone, after the cursor; keys come together,
 * each once and none after one that is pressed, and text after them. events_drop removes them. */
int events_of_turn(const struct events *events);
void events_drop(struct events *events, int count);

void events_free(struct events *events);

#endif
