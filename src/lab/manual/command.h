/* A subcommand, or a mode of bench, as pages and completions describe it. */
#ifndef LAB_MANUAL_COMMAND_H
#define LAB_MANUAL_COMMAND_H

#include "apps/arguments.h"

struct command {
    const char *name; /* "render", "bench times" */
    const struct arguments *arguments;
    const struct option *table; /* with the common options */
    const void *values;         /* defaults, for print_more */
};

#endif
