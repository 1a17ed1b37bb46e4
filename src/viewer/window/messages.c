#include "viewer/window/messages.h"

#include "base/log.h"
#include "viewer/window/window.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* Of notes, errors and results. */
static const double note_seconds = 8, error_seconds = 24, result_seconds = 60;

static void add(struct messages *messages, enum ui_tone tone, double lasts, const char *format,
                va_list args) {
    pthread_mutex_lock(&messages->lock);
    if (messages->count == MESSAGES_MAX) {
        messages->count--;
        memmove(messages->items, messages->items + 1,
                (size_t)messages->count * sizeof *messages->items);
    }
    struct message *message = &messages->items[messages->count++];
    message->tone = tone;
    message->time = window_time();
    message->lasts = lasts;
    vsnprintf(message->text, sizeof message->text, format, args);
    pthread_mutex_unlock(&messages->lock);
}

static void on_log(void *context, bool is_warning, const char *text) {
    messages_add(context, is_warning ? UI_WARNING : UI_NORMAL, "%s", text);
}

void messages_init(struct messages *messages) {
    messages->count = 0;
    pthread_mutex_init(&messages->lock, NULL);
    log_set_listener(on_log, messages);
}

void messages_free(struct messages *messages) {
    log_set_listener(NULL, NULL);
    pthread_mutex_destroy(&messages->lock);
}

void messages_add(struct messages *messages, enum ui_tone tone, const char *format, ...) {
    va_list args;
    va_start(args, format);
    add(messages, tone, tone == UI_ERROR ? error_seconds : note_seconds, format, args);
    va_end(args);
}

void messages_add_result(struct messages *messages, const char *format, ...) {
    va_list args;
    va_start(args, format);
    add(messages, UI_NORMAL, result_seconds, format, args);
    va_end(args);
}

void messages_forget_errors(struct messages *messages) {
    int kept = 0;
    pthread_mutex_lock(&messages->lock);
    for (int i = 0; i < messages->count; i++)
        if (messages->items[i].tone != UI_ERROR)
            messages->items[kept++] = messages->items[i];
    messages->count = kept;
    pthread_mutex_unlock(&messages->lock);
}

int messages_recent(struct messages *messages, struct message recent[MESSAGES_SHOWN]) {
    const double now = window_time();
    int count = 0;
    pthread_mutex_lock(&messages->lock);
    for (int i = 0; i < messages->count; i++) {
        const struct message *message = &messages->items[i];
        if (now - message->time > message->lasts)
            continue;
        if (count == MESSAGES_SHOWN) {
            count--;
            memmove(recent, recent + 1, (size_t)count * sizeof *recent);
        }
        recent[count++] = *message;
    }
    pthread_mutex_unlock(&messages->lock);
    return count;
}
