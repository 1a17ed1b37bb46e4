#include "gl/api.h"

#include "base/error.h"

#include <stddef.h>
#include <string.h>

_Thread_local struct gl_api gl;

/* Name and place of each member, in the order of the list. */
static const struct entry {
    const char *name;
    size_t offset;
} entries[] = {
#define GL_ENTRY(type, name) {"gl" #name, offsetof(struct gl_api, name)},
    GL_FUNCTIONS(GL_ENTRY)
#undef GL_ENTRY
};

bool gl_api_load(struct gl_api *api, void *(*getproc)(const char *name)) {
    for (size_t i = 0; i < sizeof entries / sizeof *entries; i++) {
        void *function = getproc(entries[i].name);
        if (!function)
            return error_set("no function %s", entries[i].name);
        memcpy((char *)api + entries[i].offset, &function, sizeof function);
    }
    return true;
}

bool gl_has_extension(const struct gl_api *api, const char *name) {
    GLint count = 0;
    api->GetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLuint i = 0; i < (GLuint)count; i++)
        if (strcmp((const char *)api->GetStringi(GL_EXTENSIONS, i), name) == 0)
            return true;
    return false;
}
