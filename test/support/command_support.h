/* What tests share that run the program, or lines of the shell, and read what these print. */
#ifndef TEST_COMMAND_SUPPORT_H
#define TEST_COMMAND_SUPPORT_H

#include "support.h"

/* What the last command printed, on stdout and stderr together. */
extern char output[1 << 16];

/* Runs a line of the shell, with the test's own folder for each @ and the program for a % that is a
 * word, both from the root; prints it with what comes, and returns its exit status. */
int run_line(const char *line);

/* Fails unless the line ends with that status. */
void expect(int status, const char *line);

/* Fails unless `BINARY COMMAND ARGUMENTS` does. */
void expect_command(int status, const char *command, const char *arguments);

/* Fails unless the last command printed the text. */
void expect_text(const char *text);

/* Fails unless `BINARY COMMAND ARGUMENTS` ends so, with a message that has the words, for each row
 * of these two up to one without. */
void expect_refusals(int status, const char *command, const char *const (*rows)[2]);

/* How often the first text has the second. */
int count_text(const char *where, const char *text);

/* Fails unless the first text has the second. */
void expect_in(const char *where, const char *text);

#define BUILD "${MANYLIGHT_BUILD:-build}"

/* Begins a line of the shell that calls $PYTHON with the Python module of a folder. A library of
 * AddressSanitizer wants to be loaded first, and Python leaves memory at its end. */
#define WITH_MODULE(folder)                                                                        \
    "PYTHON=$(test/python/find); export PYTHON PYTHONPATH=" folder                                 \
    " ASAN_OPTIONS=detect_leaks=0 LD_PRELOAD=$(ldd " folder                                        \
    "/manylight/libmanylight.so.0 | awk '/libasan/ { print $3 }'); "

/* Set-up of a program: builds the module for the library that is there, where it can be built. */
int build_module(void **state);

/* Skips the test where it cannot be built. */
void need_module(void);

/* Skips the test of another build than the one that is installed. */
void need_default_build(void);

#endif
