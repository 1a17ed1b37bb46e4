#include "base/log.h"

#include "base/events.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static enum log_level current_level = LOG_NORMAL;
static _Thread_local bool is_silent;
static _Thread_local const struct log_sink *sink;
static log_listener *listening;
static void *listening_context;
static _Atomic bool has_line;

void log_set_level(enum log_level level) {
    current_level = level;
}

enum log_level log_get_level(void) {
    return current_level;
}

void log_tell_of_thread(bool tells) {
    is_silent = !tells;
}

void log_set_sink(const struct log_sink *new_sink) {
    sink = new_sink;
}

const struct log_sink *log_get_sink(void) {
    return sink;
}

void log_set_listener(log_listener *listener, void *context) {
    listening = listener;
    listening_context = context;
}

void log_show_line(const char *line) {
    if (line)
        fprintf(stderr, "\r%s\033[K", line);
    else if (has_line)
        fprintf(stderr, "\r\033[K");
    has_line = line;
}

/* To the thread's sink, or as an event, or as a line for people. */
static void print(enum log_kind kind, const char *format, va_list args) {
    static const char *const names[] = {"detail", "note", "warning"};
    if (sink || events_are_json()) {
        char message[4096];
        vsnprintf(message, sizeof message, format, args);
        if (sink)
            sink->tell(sink, kind, message);
        else
            event_tell(names[kind], message);
        return;
    }
    log_show_line(NULL);
    fprintf(stderr, "manylight: %s%s", kind == LOG_IS_DETAIL ? "" : names[kind],
            kind == LOG_IS_DETAIL ? "" : ": ");
    vfprintf(stderr, format, args);
    fputc('\n', stderr);
}

void log_detail(const char *format, ...) {
    va_list args;
    if (is_silent || (!sink && current_level < LOG_VERBOSE))
        return;
    va_start(args, format);
    print(LOG_IS_DETAIL, format, args);
    va_end(args);
}

static void tell(bool is_warning, const char *format, va_list args) {
    if (!listening || sink)
        return;
    char message[512];
    vsnprintf(message, sizeof message, format, args);
    listening(listening_context, is_warning, message);
}

void log_note(const char *format, ...) {
    va_list args;
    if (is_silent)
        return;
    va_start(args, format);
    if (sink || current_level >= LOG_NORMAL)
        print(LOG_IS_NOTE, format, args);
    va_end(args);
    va_start(args, format);
    tell(false, format, args);
    va_end(args);
}

void log_warning(const char *format, ...) {
    va_list args;
    if (is_silent)
        return;
    va_start(args, format);
    print(LOG_IS_WARNING, format, args);
    va_end(args);
    va_start(args, format);
    tell(true, format, args);
    va_end(args);
}
