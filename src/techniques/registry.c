#include "base/error.h"
#include "base/names.h"
#include "techniques/many_lights.h"

#include "parts.h"

#include <string.h>

/* TECHNIQUES of parts.h lists the folders beside this file; techniques of tests come by
 * MORE_TECHNIQUES. */
#ifndef MORE_TECHNIQUES
#define MORE_TECHNIQUES(X)
#endif

#define DECLARE(name) extern const struct technique name##_technique;
TECHNIQUES(DECLARE)
MORE_TECHNIQUES(DECLARE)

#define ENTER(name) &name##_technique,
const struct technique *const techniques[] = {MORE_TECHNIQUES(ENTER) TECHNIQUES(ENTER) NULL};

const struct technique *const technique_default = &clustered_technique, *const technique_baseline =
                                                                            &unshadowed_technique;

bool technique_check(const struct technique *technique, const struct settings *settings) {
    struct settings chosen = many_lights_chosen(settings, false);
    return !technique->check || technique->check(&chosen);
}

const struct technique *technique_find(const char *name) {
    struct names names = {0};
    if (!name)
        return technique_default;
    for (const struct technique *const *t = techniques; *t; t++) {
        if (strcmp((*t)->name, name) == 0)
            return *t;
        names_add(&names, ", ", (*t)->name);
    }
    error_set("no technique is called '%s' (there are %s)", name, names.text);
    return NULL;
}
