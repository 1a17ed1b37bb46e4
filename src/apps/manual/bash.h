/* Writes the completions for bash: the beginning, each command, the end. */
#ifndef APPS_MANUAL_BASH_H
#define APPS_MANUAL_BASH_H

#include "apps/manual/command.h"

#include <stdio.h>

void bash_begin(FILE *out);
void bash_write_command(FILE *out, const struct command *command);
void bash_end(FILE *out);

#endif
