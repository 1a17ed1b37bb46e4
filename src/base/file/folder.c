#define _POSIX_C_SOURCE 200809L
#include "base/file/folder.h"

#include "base/error.h"
#include "base/memory.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

char *folder_of_user(const char *variable, const char *below_home) {
    const char *folder = getenv(variable), *home = getenv("HOME");
    if (folder && *folder)
        return mem_printf("%s/manylight", folder);
    if (home && *home)
        return mem_printf("%s/%s/manylight", home, below_home);
    error_set("neither %s nor HOME is set", variable);
    return NULL;
}

char *path_of_user(const char *path) {
    bool begins_at_home = path[0] == '~' && (path[1] == '/' || path[1] == '\0');
    const char *home = begins_at_home ? getenv("HOME") : NULL;
    return home ? mem_printf("%s%s", home, path + 1) : mem_strdup(path);
}

bool folder_make_for(const char *file_path) {
    char *path = mem_strdup(file_path);
    bool ok = true;
    for (char *slash = strchr(path + 1, '/'); slash && ok; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        ok = mkdir(path, 0777) == 0 || errno == EEXIST ||
             error_set("cannot make folder %s: %s", path, strerror(errno));
        *slash = '/';
    }
    free(path);
    return ok;
}
