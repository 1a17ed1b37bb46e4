#define _DEFAULT_SOURCE
#include "base/file/folder.h"

#include "base/error.h"
#include "base/memory.h"

#include <errno.h>
#include <limits.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

char *folder_of_user(const char *variable, const char *below_home) {
    const char *folder = getenv(variable), *home = getenv("HOME");
    if (folder && *folder)
        return mem_printf("%s/manylight", folder);
    if (home && *home)
        return mem_printf("%s/%s/manylight", home, below_home);
    error_set("neither %s nor HOME is set", variable);
    return NULL;
}

/* "" where the system does not tell. */
static char *folder_of_binary(void) {
    char binary[PATH_MAX] = "";
    ssize_t length = readlink("/proc/self/exe", binary, sizeof binary - 1);
    binary[length > 0 ? length : 0] = '\0';
    char *slash = strrchr(binary, '/');
    return mem_printf("%.*s", slash ? (int)(slash + 1 - binary) : 0, binary);
}

char *folder_of_program(int n) {
    static const char *const below[] = {"", "../share/manylight/"};
    if (n == 0)
        return mem_strdup("");
    if (n > 2)
        return NULL;
    char *binary = folder_of_binary(), *folder = mem_printf("%s%s", binary, below[n - 1]);
    free(binary);
    return folder;
}

char *folder_find_own(const char *name) {
    for (int n = 0;; n++) {
        char *folder = folder_of_program(n);
        if (!folder)
            return mem_strdup(name);
        char *path = mem_printf("%s%s", folder, name);
        free(folder);
        if (access(path, R_OK) == 0)
            return path;
        free(path);
    }
}

char *path_of_user(const char *path) {
    bool begins_at_home = path[0] == '~' && (path[1] == '/' || path[1] == '\0');
    const char *home = begins_at_home ? getenv("HOME") : NULL;
    return home ? mem_printf("%s%s", home, path + 1) : mem_strdup(path);
}

const char *path_name(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
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
