/* How strictly the files of scenes are read, and from where: --strict and --root. */
#ifndef SCENE_READ_RULES_H
#define SCENE_READ_RULES_H

#include <stdbool.h>

/* For the whole program. strict: a defect that is mended with a note else is an error. root: the folder
 * below which all files lie that a scene names; NULL = the parent of the scene's folder. Error: root is
 * no folder. */
bool read_rules_set(bool strict, const char *root);

bool read_rules_are_strict(void);

/* The root without links; NULL = each scene has its own. */
const char *read_rules_root(void);

/* Rules of a thread alone, in place of the program's: until the next call, with NULL. Error: as of read_rules_set. */
struct read_rules {
    bool strict;
    char *root; /* without links; free() frees */
};
bool read_rules_init(struct read_rules *rules, bool strict, const char *root);
void read_rules_use(const struct read_rules *rules);

#endif
