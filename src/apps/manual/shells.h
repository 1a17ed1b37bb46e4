/* Completions for shells: begin, each command, end. */
#ifndef APPS_MANUAL_SHELLS_H
#define APPS_MANUAL_SHELLS_H

#include "apps/manual/command.h"

#include <stdio.h>

struct shell_writer {
    const char *file; /* its usual name */
    void (*begin)(FILE *out);
    void (*command)(FILE *out, const struct command *command);
    void (*end)(FILE *out);
};

extern const struct shell_writer bash_writer, fish_writer, zsh_writer;

/* The command's name as a part of a function's: "bench_times". Static buffer. */
const char *shell_function_name(const struct command *command);

#endif
