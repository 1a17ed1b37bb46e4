/* Former names of settings, which are accepted for one release. */
#ifndef BASE_OLD_NAMES_H
#define BASE_OLD_NAMES_H

/* The full name that the setting of that name has, which a note tells once; the last word of a former name suffices. Error,
 * and NULL: there is no such setting, or it is constant. */
const char *old_name_follow(const char *name);

#endif
