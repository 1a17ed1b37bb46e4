/* The subcommands by name. */
#ifndef APPS_SUBCOMMANDS_H
#define APPS_SUBCOMMANDS_H

struct subcommand {
    const char *name, *help;
    int (*run)(int argc, char **argv); /* apps/apps.h; NULL: this build is without it */
};

/* Ends with a row whose name is NULL. */
extern const struct subcommand subcommands[];

/* The row of that name, or NULL. */
const struct subcommand *subcommand_find(const char *name);

#endif
