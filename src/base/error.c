#include "base/error.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { MESSAGE_SIZE = 2048 };

static _Thread_local char message[MESSAGE_SIZE];
static _Thread_local enum error_kind kind;

/* The arguments may point into the old message, so the new one is composed beside it. */
static void set(enum error_kind new_kind, const char *format, va_list args) {
    char composed[MESSAGE_SIZE];
    vsnprintf(composed, sizeof composed, format, args);
    memcpy(message, composed, sizeof message);
    kind = new_kind;
}

bool error_set(const char *format, ...) {
    va_list args;
    va_start(args, format);
    set(ERROR_OF_WORLD, format, args);
    va_end(args);
    return false;
}

bool error_set_memory(const char *format, ...) {
    va_list args;
    va_start(args, format);
    set(ERROR_OF_MEMORY, format, args);
    va_end(args);
    return false;
}

bool error_prefix(const char *format, ...) {
    char context[MESSAGE_SIZE], composed[2 * MESSAGE_SIZE + 2];
    va_list args;
    va_start(args, format);
    vsnprintf(context, sizeof context, format, args);
    va_end(args);
    snprintf(composed, sizeof composed, "%s: %s", context, message);
    composed[MESSAGE_SIZE - 1] = '\0';
    memcpy(message, composed, sizeof message);
    return false;
}

const char *error_get(void) {
    return message;
}

enum error_kind error_get_kind(void) {
    return kind;
}
