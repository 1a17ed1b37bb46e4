#include "base/log.h"

#include <stdarg.h>
#include <stdio.h>

static enum log_level current_level = LOG_NORMAL;

void log_set_level(enum log_level level) {
    current_level = level;
}

enum log_level log_get_level(void) {
    return current_level;
}

static void print(const char *label, const char *format, va_list args) {
    fprintf(stderr, "manylight: %s", label);
    vfprintf(stderr, format, args);
    fputc('\n', stderr);
}

void log_detail(const char *format, ...) {
    if (current_level < LOG_VERBOSE)
        return;
    va_list args;
    va_start(args, format);
    print("", format, args);
    va_end(args);
}

void log_note(const char *format, ...) {
    if (current_level < LOG_NORMAL)
        return;
    va_list args;
    va_start(args, format);
    print("note: ", format, args);
    va_end(args);
}

void log_warning(const char *format, ...) {
    va_list args;
    va_start(args, format);
    print("warning: ", format, args);
    va_end(args);
}
