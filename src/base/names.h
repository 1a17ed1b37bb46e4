/* Joins names for a sentence: "there are clustered, unshadowed". */
#ifndef BASE_NAMES_H
#define BASE_NAMES_H

#include <stddef.h>

/* Zeroed: empty. */
struct names {
    char text[1536];
    size_t length;
};

/* Appends a name, after a separator unless it is the first. Text that does not fit is cut. */
void names_add(struct names *names, const char *separator, const char *name);

#endif
