/* Strictness and allowed folders for reading scenes: --strict and --root. */
#ifndef SCENE_READ_RULES_H
#define SCENE_READ_RULES_H

#include <stdbool.h>

/* Sets the rules of the whole program. strict: defects are errors instead of repaired with a note.
 * root: folder of all files that a scene may name. NULL: the parent of the scene's folder. Error:
 * root is not a folder. */
bool read_rules_set(bool strict, const char *root);

bool read_rules_are_strict(void);

/* Returns the root without links. NULL: each scene has its own. */
const char *read_rules_root(void);

/* Rules of one thread, in place of the program's. read_rules_use sets them until its next call;
 * NULL ends them. Error: that of read_rules_set. */
struct read_rules {
    bool strict;
    char *root; /* without links; the caller frees it */
};
bool read_rules_init(struct read_rules *rules, bool strict, const char *root);
void read_rules_use(const struct read_rules *rules);

#endif
