#define _XOPEN_SOURCE 700
#include "base/shell.h"

#include "base/memory.h"
#include "base/text.h"

#include <limits.h>
#include <string.h>
#include <unistd.h>

/* A single quote closes, escapes and opens. */
char *shell_quote(const char *word) {
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                "_-+=./,:@%";
    struct text quoted = {0};
    if (*word && word[strspn(word, plain)] == '\0')
        return mem_strdup(word);
    text_append(&quoted, "'", 1);
    for (const char *c = word; *c; c++)
        text_append(&quoted, *c == '\'' ? "'\\''" : c, *c == '\'' ? 4 : 1);
    text_append(&quoted, "'", 1);
    return quoted.data;
}

/* Where a shell finds the program; the caller frees it. NULL: nowhere. */
static char *find(const char *program) {
    char *path = mem_strdup(getenv("PATH") ? getenv("PATH") : ""), *rest = NULL, *found = NULL;
    for (char *folder = strtok_r(path, ":", &rest); folder && !found;
         folder = strtok_r(NULL, ":", &rest)) {
        char *file = mem_printf("%s/%s", folder, program);
        if (access(file, X_OK) == 0)
            found = file;
        else
            free(file);
    }
    free(path);
    return found;
}

bool shell_has(const char *program) {
    char *path = find(program);
    bool has = path;
    free(path);
    return has;
}

char *shell_own_program(void) {
    static const char name[] = "manylight";
    char own[PATH_MAX] = "", *found = find(name);
    char *whole = found ? realpath(found, NULL) : NULL;
    ssize_t length = readlink("/proc/self/exe", own, sizeof own - 1);
    bool by_name = length <= 0 || (whole && strcmp(whole, own) == 0);
    mem_free(found, whole);
    return by_name ? mem_strdup(name) : shell_quote(own);
}
