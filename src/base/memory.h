/* CPU memory. Running out of it aborts with a message, so callers need no check. free() frees. */
#ifndef BASE_MEMORY_H
#define BASE_MEMORY_H

#include <stddef.h>

/* count elements of size bytes each, zeroed; a valid pointer even for 0 bytes. */
void *mem_alloc(size_t count, size_t size);

/* Grows or shrinks; new bytes are not zeroed. */
void *mem_resize(void *pointer, size_t count, size_t size);

char *mem_strdup(const char *text);
char *mem_printf(const char *format, ...) __attribute__((format(printf, 1, 2)));

#endif
