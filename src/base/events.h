/* What stderr tells of a run, as events for programs: one JSON object a line, in place of notes, errors and progress as
 * text. docs/user/02-rendering.md lists the events and their fields.
 *
 *     struct event event;
 *     event_begin(&event, "file");
 *     event_add_text(&event, "file", path);
 *     event_send(&event);
 */
#ifndef BASE_EVENTS_H
#define BASE_EVENTS_H

#include <stdbool.h>
#include <stdio.h>

/* Of the whole process, from then on. */
void events_choose_json(void);
bool events_are_json(void);

struct event {
    FILE *stream;
    char *data;
    size_t size;
};

void event_begin(struct event *event, const char *name);
void event_add_text(struct event *event, const char *key, const char *text);
void event_add_number(struct event *event, const char *key, double number); /* not finite: null */

/* Writes the line at once, whatever other threads write. */
void event_send(struct event *event);

/* An event that has a text alone. */
void event_tell(const char *name, const char *text);

#endif
