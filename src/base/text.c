#include "base/text.h"

#include "base/memory.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static void make_room(struct text *text, size_t size) {
    if (text->length + size < text->capacity)
        return;
    text->capacity = 2 * (text->length + size + 1);
    text->data = mem_resize(text->data, text->capacity, 1);
}

void text_append(struct text *text, const void *bytes, size_t size) {
    make_room(text, size);
    if (size) /* bytes may be NULL then */
        memcpy(text->data + text->length, bytes, size);
    text->length += size;
    text->data[text->length] = '\0';
}

void text_print(struct text *text, const char *format, ...) {
    va_list args;
    va_start(args, format);
    int length = vsnprintf(NULL, 0, format, args);
    va_end(args);
    size_t size = length < 0 ? 0 : (size_t)length;
    make_room(text, size);
    va_start(args, format);
    vsnprintf(text->data + text->length, size + 1, format, args);
    va_end(args);
    text->length += size;
}
