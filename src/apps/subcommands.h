/* The subcommands by name. */
#ifndef APPS_SUBCOMMANDS_H
#define APPS_SUBCOMMANDS_H

#include <stdbool.h>

struct subcommand {
    const char *name, *help;
    int (*run)(int argc, char **argv); /* apps/apps.h */
};

/* Ends with a row whose name is NULL. */
extern const struct subcommand subcommands[];

/* Whether this build is without it; run then says so. */
bool subcommand_is_missing(const struct subcommand *subcommand);

/* The row of that name, or NULL. */
const struct subcommand *subcommand_find(const char *name);

#endif
