/* Writes the completions for bash: the beginning, each command, the end. */
#ifndef LAB_MANUAL_BASH_H
#define LAB_MANUAL_BASH_H

#include "lab/manual/man_page.h"

void bash_begin(FILE *out);
void bash_write_command(FILE *out, const struct command *command);
void bash_end(FILE *out);

#endif
