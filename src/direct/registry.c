#include "base/error.h"
#include "direct/direct.h"

#include <stdio.h>
#include <string.h>

/* A method is entered by its line here; those of tests come by MORE_METHODS. */
#define METHODS(X) X(hard)

#ifndef MORE_METHODS
#define MORE_METHODS(X)
#endif

#define DECLARE(name) extern const struct direct_method name##_direct;
METHODS(DECLARE)
MORE_METHODS(DECLARE)

#define ENTER(name) &name##_direct,
const struct direct_method *const direct_methods[] = {METHODS(ENTER) MORE_METHODS(ENTER) NULL};

const struct direct_method *const direct_default = &hard_direct;

const struct direct_method *direct_find(const char *name) {
    char names[256] = "";
    size_t used = 0;
    if (!name)
        return direct_default;
    for (const struct direct_method *const *d = direct_methods; *d; d++) {
        if (strcmp((*d)->name, name) == 0)
            return *d;
        if (used < sizeof names)
            used += (size_t)snprintf(names + used, sizeof names - used, "%s%s", used ? ", " : "",
                                     (*d)->name);
    }
    error_set("no direct light is called '%s' (there is %s)", name, names);
    return NULL;
}
