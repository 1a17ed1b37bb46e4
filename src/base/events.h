/* Writes events to stderr for other programs: one JSON object a line, in place of notes, errors and
 * progress as text. docs/user/02-rendering.md lists the events and their fields.
 *
 *     struct event event;
 *     event_begin(&event, "file");
 *     json_text(&event.json, "file", path);
 *     event_send(&event);
 */
#ifndef BASE_EVENTS_H
#define BASE_EVENTS_H

#include "base/json.h"

/* Selects JSON events for the whole process from this call on. */
void events_choose_json(void);
bool events_are_json(void);

struct event {
    struct json json; /* receives the members */
    char *data;
    size_t size;
};

void event_begin(struct event *event, const char *name);

/* Writes the event as one line in one call, so lines of threads do not mix. */
void event_send(struct event *event);

/* Sends an event with the member "text" only. */
void event_tell(const char *name, const char *text);

/* Writes an error without allocating memory, as an event or as a line of text. The text must need
 * no escapes. */
void event_tell_last(const char *text);

#endif
