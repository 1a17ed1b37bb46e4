/* Handles what all subcommands share: --help on stdout, common options, usage errors on stderr,
 * exit status. */
#ifndef APPS_ARGUMENTS_H
#define APPS_ARGUMENTS_H

#include "base/option.h"

#include <stdbool.h>
#include <stdio.h>

enum status { STATUS_OK, STATUS_FAILED, STATUS_USAGE };

/* First member of each subcommand's struct of values. */
struct common_values {
    bool help, help_all, quiet, verbose;
    int progress; /* index into progress_names */
    bool strict;  /* strict and root: scene/read_rules.h */
    const char *root;
    struct text_list given; /* names of the options on the command line */
};

struct arguments {
    const char *synopsis;         /* "SCENE -o FILE [OPTION ...]" */
    const char *summary;          /* a line or more, without the last line feed */
    const struct option *options; /* its own rows, without the common ones */
    int min_positional, max_positional;
    bool opens_scenes;   /* has --strict and --root, too */
    bool shows_progress; /* has --progress, too */
    /* Prints the end of --help and --help-all, which may depend on other options. NULL: nothing. */
    void (*print_more)(FILE *out, const void *values);
};

/* Sets defaults, parses, and sets the log level by --quiet and --verbose. positional has room
 * for max_positional; those not given are NULL. Returns false if the subcommand ends with
 * *status: after --help, or after a usage error, which it prints. */
bool arguments_parse(const struct arguments *arguments, void *values, int argc, char **argv,
                     const char **positional, int *positional_count, int *status);

/* Options that apply only together with another one. */
struct option_use {
    const char *options; /* names, separated by spaces */
    bool applies;        /* the other option is given */
    const char *place;   /* name of the other option, for example "--frames" */
};

/* Refuses options that are given and do not apply. A row of NULL ends the table. Error: names
 * the option and the one that it needs. */
bool arguments_check_use(const struct common_values *common, const struct option_use *uses);

/* Returns true for --help, --help-all and -h. */
bool arguments_is_help(const char *argument);

/* Prints the current error as "manylight NAME: MESSAGE" on stderr. arguments_fail returns
 * STATUS_FAILED, arguments_misuse STATUS_USAGE. */
int arguments_fail(const char *name);
int arguments_misuse(const char *name);

#endif
