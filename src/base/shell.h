/* Words of a shell's command line. */
#ifndef BASE_SHELL_H
#define BASE_SHELL_H

#include <stdbool.h>

/* Returns the text as one word of a POSIX shell, in single quotes if needed. The caller frees
 * it. */
char *shell_quote(const char *word);

/* True if a shell finds the program in PATH. */
bool shell_has(const char *program);

/* Returns a word that starts this program again: its name if PATH finds it, else its path. The
 * caller frees it. */
char *shell_own_program(void);

#endif
