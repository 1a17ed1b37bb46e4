#include "base/log.h"

#include "base/events.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static enum log_level current_level = LOG_NORMAL;
static _Thread_local bool is_silent;
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

static void send(const char *event, const char *format, va_list args) {
    char message[4096];
    vsnprintf(message, sizeof message, format, args);
    event_tell(event, message);
}

static void print(const char *event, const char *format, va_list args) {
    if (events_are_json()) {
        send(event, format, args);
        return;
    }
    log_show_line(NULL);
    bool is_detail = strcmp(event, "detail") == 0;
    fprintf(stderr, "manylight: %s%s", is_detail ? "" : event, is_detail ? "" : ": ");
    vfprintf(stderr, format, args);
    fputc('\n', stderr);
}

void log_detail(const char *format, ...) {
    if (is_silent || current_level < LOG_VERBOSE)
        return;
    va_list args;
    va_start(args, format);
    print("detail", format, args);
    va_end(args);
}

static void tell(bool is_warning, const char *format, va_list args) {
    if (!listening)
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
    if (current_level >= LOG_NORMAL)
        print("note", format, args);
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
    print("warning", format, args);
    va_end(args);
    va_start(args, format);
    tell(true, format, args);
    va_end(args);
}
