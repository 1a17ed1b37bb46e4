/* What every subcommand does alike with its command line: --help on stdout, the options that all
 * have, usage errors on stderr, and the exit status.
 *
 *     struct values { struct common_values common; int size[2]; };
 *
 *     int app_render(int argc, char **argv) {
 *         struct values values = {0};
 *         const char *scene;
 *         int status, count;
 *         if (!arguments_parse(&arguments, &values, argc, argv, &scene, &count, &status))
 *             return status;
 *         ...
 *         return ok ? STATUS_OK : arguments_fail(argv[0]);
 *     }
 */
#ifndef APPS_ARGUMENTS_H
#define APPS_ARGUMENTS_H

#include "base/option.h"

#include <stdbool.h>
#include <stdio.h>

enum status { STATUS_OK, STATUS_FAILED, STATUS_USAGE };

/* The first member of each subcommand's struct of values. */
struct common_values {
    bool help, help_all, quiet, verbose;
    int progress; /* an index of progress_names */
    bool strict;  /* this and root: of scene/read_rules.h */
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
    /* The end of --help and --help-all, which may depend on other options; NULL = nothing. */
    void (*print_more)(FILE *out, const void *values);
};

/* Sets values to their defaults, parses, and sets the log level by --quiet and --verbose. The
 * positional array has room for max_positional; those not given are NULL. False: the subcommand is
 * over and returns *status, after --help has been printed or a usage error. */
bool arguments_parse(const struct arguments *arguments, void *values, int argc, char **argv,
                     const char **positional, int *positional_count, int *status);

/* Options that have an effect at a place alone. */
struct option_use {
    const char *options; /* words */
    bool applies;        /* whether this command line has the place */
    const char *place;   /* "--frames" */
};

/* Refuses options that are given and do not apply; the table ends with a NULL. Error: names the
 * option and its place. */
bool arguments_check_use(const struct common_values *common, const struct option_use *uses);

/* In place of each subcommand's run, until it is NULL again: gets the arguments, with the common
 * options in the table, and defaults as values. */
typedef void arguments_reader(void *user, const char *name, const struct arguments *arguments,
                              const struct option *table, const void *values);
void arguments_set_reader(arguments_reader *reader, void *user);

/* --help, --help-all or -h. */
bool arguments_is_help(const char *argument);

/* Prints the present error as "manylight NAME: MESSAGE" on stderr; returns STATUS_FAILED, or
 * STATUS_USAGE where the arguments are at fault. */
int arguments_fail(const char *name);
int arguments_misuse(const char *name);

#endif
