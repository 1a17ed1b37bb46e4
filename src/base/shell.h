/* Words of a shell's command line. */
#ifndef BASE_SHELL_H
#define BASE_SHELL_H

/* The word as a POSIX shell takes it for one: in single quotes where it needs them; the caller frees it. */
char *shell_quote(const char *word);

#endif
