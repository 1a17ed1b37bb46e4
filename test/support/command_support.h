/* What tests share that run the program, or lines of the shell, and read what these print. */
#ifndef TEST_COMMAND_SUPPORT_H
#define TEST_COMMAND_SUPPORT_H

#include "support.h"

/* What the last command printed, on stdout and stderr together. */
extern char output[1 << 16];

/* Runs the program with these arguments; its exit status. */
int run_program(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Runs a line of the shell, with the test's own folder for each @ and the program for a % that is a
 * word, both from the root; prints it with what comes, and returns its exit status. */
int run_line(const char *line);

/* Fails unless the line ends with that status. */
void expect(int status, const char *line);

/* Fails unless `BINARY COMMAND ARGUMENTS` does. */
void expect_command(int status, const char *command, const char *arguments);

/* Fails unless the last command printed the text. */
void expect_text(const char *text);

/* How often the first text has the second. */
int count_text(const char *where, const char *text);

/* Fails unless the first text has the second. */
void expect_in(const char *where, const char *text);

/* Skips the test of another build than the one that is installed. */
void need_default_build(void);

#endif
