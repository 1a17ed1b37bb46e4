/* Words of a shell's command line. */
#ifndef BASE_SHELL_H
#define BASE_SHELL_H

#include <stdbool.h>

/* The word as a POSIX shell takes it for one: in single quotes where it needs them; the caller frees it. */
char *shell_quote(const char *word);

/* Whether a shell finds the program. */
bool shell_has(const char *program);

/* A word that starts this program again: its name where a shell finds it by that, else its path; the caller frees it. */
char *shell_own_program(void);

#endif
