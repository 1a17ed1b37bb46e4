#include "base/error.h"
#include "base/names.h"
#include "direct/direct.h"

#include <string.h>

/* A method is entered by its line here; those of tests come by MORE_METHODS. */
#define METHODS(X) X(hard) X(pcss) X(samples) X(vssm) X(msm) X(cssm)

#ifndef MORE_METHODS
#define MORE_METHODS(X)
#endif

#define DECLARE(name) extern const struct direct_method name##_direct;
METHODS(DECLARE)
MORE_METHODS(DECLARE)

#define ENTER(name) &name##_direct,
const struct direct_method *const direct_methods[] = {METHODS(ENTER) MORE_METHODS(ENTER) NULL};

const struct direct_method *direct_for(const struct emitters *emitters) {
    for (int i = 0; i < emitters->count; i++)
        if (emitter_shape(&emitters->items[i]) != EMITTER_IS_POINT)
            return &pcss_direct;
    return &hard_direct;
}

const struct direct_method *direct_find(const char *name) {
    struct names names = {0};
    for (const struct direct_method *const *d = direct_methods; *d; d++) {
        if (strcmp((*d)->name, name) == 0)
            return *d;
        names_add(&names, ", ", (*d)->name);
    }
    error_set("no direct light is called '%s' (there is %s)", name, names.text);
    return NULL;
}
