/* What stderr tells of a run, as events for programs: one JSON object a line, in place of notes, errors and progress as
 * text. docs/user/02-rendering.md lists the events and their fields.
 *
 *     struct event event;
 *     event_begin(&event, "file");
 *     json_text(&event.json, "file", path);
 *     event_send(&event);
 */
#ifndef BASE_EVENTS_H
#define BASE_EVENTS_H

#include "base/json.h"

/* Of the whole process, from then on. */
void events_choose_json(void);
bool events_are_json(void);

struct event {
    struct json json; /* gets the members */
    char *data;
    size_t size;
};

void event_begin(struct event *event, const char *name);

/* Writes the line at once, whatever other threads write. */
void event_send(struct event *event);

/* An event that has a text alone. */
void event_tell(const char *name, const char *text);

/* An error without memory, as an event or as a line for people. The text needs no escapes. */
void event_tell_last(const char *text);

#endif
