#include "base/memory.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void *checked(void *pointer, size_t count, size_t size) {
    if (pointer)
        return pointer;
    fprintf(stderr, "manylight: out of memory (%zu x %zu bytes)\n", count, size);
    abort();
}

void *mem_alloc(size_t count, size_t size) {
    if (count == 0 || size == 0)
        count = size = 1;
    return checked(calloc(count, size), count, size);
}

void *mem_resize(void *pointer, size_t count, size_t size) {
    if (count == 0 || size == 0)
        count = size = 1;
    void *resized = count > SIZE_MAX / size ? NULL : realloc(pointer, count * size);
    return checked(resized, count, size);
}

char *mem_strdup(const char *text) {
    size_t size = strlen(text) + 1;
    return memcpy(mem_alloc(size, 1), text, size);
}

char *mem_printf(const char *format, ...) {
    va_list args;
    va_start(args, format);
    int length = vsnprintf(NULL, 0, format, args);
    va_end(args);
    size_t size = length < 0 ? 1 : (size_t)length + 1;
    char *text = mem_alloc(size, 1);
    va_start(args, format);
    vsnprintf(text, size, format, args);
    va_end(args);
    return text;
}
