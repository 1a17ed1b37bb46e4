/* Names in a row, for a sentence: "there are clustered, unshadowed". */
#ifndef BASE_NAMES_H
#define BASE_NAMES_H

#include <stddef.h>

/* Zeroed: none. */
struct names {
    char text[1536];
    size_t length;
};

/* Adds one, behind a separator unless it is the first. What no longer fits is cut off. */
void names_add(struct names *names, const char *separator, const char *name);

#endif
