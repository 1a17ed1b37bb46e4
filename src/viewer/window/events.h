/* Hands on the events of a window, in their order, by turns. A key that is pressed and released
 * during one slow frame is pressed in one turn and released in a later one. Each press keeps the
 * modifiers of its time, so nothing is lost or typed with a wrong modifier. */
#ifndef VIEWER_WINDOW_EVENTS_H
#define VIEWER_WINDOW_EVENTS_H

#include <stdbool.h>

enum { EVENTS_OF_TURN = 32 }; /* at most */

struct event {
    enum event_kind { EVENT_KEY, EVENT_TEXT, EVENT_BUTTON, EVENT_CURSOR, EVENT_SCROLL } kind;
    int code; /* the key, button or character, as the system has it */
    int modifiers;
    bool down;
    double x, y; /* of the cursor, or by how much was scrolled */
};

/* Zeroed: none. */
struct events {
    struct event *items;
    int count, capacity;
};

/* Cursor and wheel go on where the last event was theirs, too. */
void events_add(struct events *events, const struct event *event);

/* How many of the first belong to one turn, at least one where there is one: the cursor goes to one
 * place; a button, or the wheel, comes alone, when the cursor is known to be there; keys come
 * together, each once and none after one that is pressed, and text after them. events_drop lets
 * them go. */
int events_of_turn(const struct events *events);
void events_drop(struct events *events, int count);

void events_free(struct events *events);

#endif
