#include "base/names.h"

#include <stdio.h>

void names_add(struct names *names, const char *separator, const char *name) {
    if (names->length < sizeof names->text)
        names->length +=
            (size_t)snprintf(names->text + names->length, sizeof names->text - names->length,
                             "%s%s", names->length ? separator : "", name);
}
