/* Text that grows at its end, in amortised linear time. */
#ifndef BASE_TEXT_H
#define BASE_TEXT_H

#include <stddef.h>

/* Zeroed: empty, with data NULL. Otherwise data ends in a zero that length does not count. The
 * caller frees data. */
struct text {
    char *data;
    size_t length, capacity;
};

void text_append(struct text *text, const void *bytes, size_t size);
void text_print(struct text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
