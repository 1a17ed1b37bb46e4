#define _POSIX_C_SOURCE 200809L
#include "base/events.h"

#include "base/json.h"

#include <stdlib.h>

static bool json;

void events_choose_json(void) {
    json = true;
}

bool events_are_json(void) {
    return json;
}

void event_begin(struct event *event, const char *name) {
    *event = (struct event){0};
    event->stream = open_memstream(&event->data, &event->size);
    if (!event->stream)
        return; /* out of memory: work goes on without the event */
    fprintf(event->stream, "{\"event\": ");
    json_print_text(event->stream, name);
}

static void add_key(struct event *event, const char *key) {
    fprintf(event->stream, ", ");
    json_print_text(event->stream, key);
    fprintf(event->stream, ": ");
}

void event_add_text(struct event *event, const char *key, const char *text) {
    if (!event->stream)
        return;
    add_key(event, key);
    json_print_text(event->stream, text);
}

void event_add_number(struct event *event, const char *key, double number) {
    if (!event->stream)
        return;
    add_key(event, key);
    json_print_number(event->stream, number);
}

void event_send(struct event *event) {
    if (!event->stream)
        return;
    fprintf(event->stream, "}\n");
    if (fclose(event->stream) == 0)
        fputs(event->data, stderr);
    free(event->data);
    *event = (struct event){0};
}

void event_tell(const char *name, const char *text) {
    struct event event;
    event_begin(&event, name);
    event_add_text(&event, "text", text);
    event_send(&event);
}
