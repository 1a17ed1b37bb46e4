#define _XOPEN_SOURCE 700
#include "scene/read_rules.h"

#include "base/error.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static struct read_rules of_program;
static _Thread_local const struct read_rules *of_thread;

bool read_rules_init(struct read_rules *rules, bool strict, const char *root) {
    struct stat status;
    char *real = root ? realpath(root, NULL) : NULL;
    if (root && !real)
        return error_set("%s: %s", root, strerror(errno));
    if (real && (stat(real, &status) != 0 || !S_ISDIR(status.st_mode))) {
        free(real);
        return error_set("%s: not a folder", root);
    }
    *rules = (struct read_rules){strict, real};
    return true;
}

bool read_rules_set(bool strict, const char *root) {
    struct read_rules rules;
    if (!read_rules_init(&rules, strict, root))
        return false;
    free(of_program.root);
    of_program = rules;
    return true;
}

void read_rules_use(const struct read_rules *rules) {
    of_thread = rules;
}

static const struct read_rules *present(void) {
    return of_thread ? of_thread : &of_program;
}

bool read_rules_are_strict(void) {
    return present()->strict;
}

const char *read_rules_root(void) {
    return present()->root;
}
