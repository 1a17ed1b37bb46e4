#define _POSIX_C_SOURCE 200809L
#include "base/events.h"

#include <stdlib.h>

static bool chosen;

void events_choose_json(void) {
    chosen = true;
}

bool events_are_json(void) {
    return chosen;
}

void event_begin(struct event *event, const char *name) {
    *event = (struct event){0};
    event->json.out = open_memstream(&event->data, &event->size); /* without memory, no event */
    json_open(&event->json, NULL, "{");
    json_text(&event->json, "event", name);
}

void event_send(struct event *event) {
    json_close(&event->json, "}");
    if (event->json.out && fclose(event->json.out) == 0)
        fputs(event->data, stderr);
    free(event->data);
    *event = (struct event){0};
}

void event_tell(const char *name, const char *text) {
    struct event event;
    event_begin(&event, name);
    json_text(&event.json, "text", text);
    event_send(&event);
}

void event_tell_last(const char *text) {
    fprintf(stderr, chosen ? "{\"event\": \"error\", \"text\": \"%s\"}\n" : "%s\n", text);
}
