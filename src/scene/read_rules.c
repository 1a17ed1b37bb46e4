#define _XOPEN_SOURCE 700
#include "scene/read_rules.h"

#include "base/error.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static bool is_strict;
static char *root_folder;

bool read_rules_set(bool strict, const char *root) {
    struct stat status;
    char *real = root ? realpath(root, NULL) : NULL;
    if (root && !real)
        return error_set("%s: %s", root, strerror(errno));
    if (real && (stat(real, &status) != 0 || !S_ISDIR(status.st_mode))) {
        free(real);
        return error_set("%s: not a folder", root);
    }
    is_strict = strict;
    free(root_folder);
    root_folder = real;
    return true;
}

bool read_rules_are_strict(void) {
    return is_strict;
}

const char *read_rules_root(void) {
    return root_folder;
}
