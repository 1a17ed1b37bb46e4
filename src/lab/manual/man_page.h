/* Pages for man(1) in roff, from the tables that --help prints. */
#ifndef LAB_MANUAL_MAN_PAGE_H
#define LAB_MANUAL_MAN_PAGE_H

#include "apps/arguments.h"

#include <stdio.h>

/* A subcommand, or a mode of bench. */
struct command {
    const char *name; /* "render", "bench times" */
    const struct arguments *arguments;
    const struct option *table; /* with the common options */
    const void *values;         /* defaults, for print_more */
};

/* Of the program: manylight(1). */
void man_page_write_overview(FILE *out);

/* The page's first part, of a subcommand: its name, and what it does. */
void man_page_begin(FILE *out, const char *name, const char *help);

/* Synopsis, description and options. The page of render has all settings, too. Modes of bench
 * follow each other. */
void man_page_write_command(FILE *out, const struct command *command);
void man_page_end(FILE *out, const char *name);

#endif
