/* Options as one table: name, help, type, default and range of each field of a struct of values.
 *
 * The same kind of table feeds the command line of every subcommand, the renderer's settings
 * (--set key=value), the viewer's panel, the benchmark's sweeps and --help.
 */
#ifndef BASE_OPTION_H
#define BASE_OPTION_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum option_type {
    OPTION_FLAG,   /* bool; on the command line without a value; "on"/"off" as text */
    OPTION_INT,    /* int */
    OPTION_FLOAT,  /* float; "1%" is .01 */
    OPTION_CHOICE, /* int, an index into choices */
    OPTION_TEXT,   /* const char *, not owned; NULL by default */
    OPTION_LIST,   /* struct text_list: may be given several times */
    OPTION_SIZE,   /* int[2]: WxH, each within the range */
};

/* Of a struct whose width and height one such row writes. */
#define OPTION_ASSERT_SIZE(type, width, height)                                                    \
    _Static_assert(offsetof(type, height) == offsetof(type, width) + sizeof(int),                  \
                   "OPTION_SIZE writes both")

enum { TEXT_LIST_MAX = 64 };

struct text_list {
    const char *items[TEXT_LIST_MAX];
    int count;
};

struct option {
    const char *name; /* "val-count": as after --, and in --set */
    char letter;      /* 'o' for -o; 0 = none */
    enum option_type type;
    size_t offset; /* of the field in the struct of values */
    double default_value, minimum, maximum;
    const char *const *choices; /* OPTION_CHOICE: null-terminated */
    bool (*check)(
        const char *text);  /* OPTION_TEXT: false with an error set refuses it; NULL = any */
    const char *value_name; /* in --help: "FILE"; NULL = by type */
    const char *unit;       /* may stand behind a number: "ms"; NULL = none */
    const char *label;      /* for settings: name of the viewer's row; NULL = name */
    const char *help;
    const char
        *needs; /* for settings: what must hold for an effect (struct need); NULL = nothing */
    bool rare;  /* --help leaves it out, --help-all does not */
};

/* A table ends with a row whose name is NULL. */

/* Sets every field to its default. OPTION_SIZE takes the default for both. */
void options_set_defaults(const struct option *table, void *values);

/* The row of that name, or NULL. */
const struct option *option_find(const struct option *table, const char *name);

/* Sets one field from text. Error: names the option, the text and what is allowed. */
bool option_parse(const struct option *option, void *values, const char *text);

/* The field of a flag, a number or a choice. */
double option_number(const struct option *option, const void *values);
void option_set_number(const struct option *option, void *values, double number);

/* The field as text that option_parse reads back. */
void option_format(const struct option *option, const void *values, char *text, size_t size);

/* Whether a field is the same in two structs of values. Not for OPTION_LIST. */
bool option_equal(const struct option *option, const void *a, const void *b);

/* Parses a command line: --name value, --name=value, -o value, flags, and up to max_positional
 * other arguments ("--" ends the options). argv[0] is skipped. given gets the names of the options
 * that are there, unless it is NULL. Error: unknown option, missing value... */
bool options_parse_arguments(const struct option *table, void *values, int argc, char **argv,
                             const char **positional, int max_positional, int *positional_count,
                             struct text_list *given);

/* "N", "WxH": the word for a value in help; "" of a flag. */
const char *option_value_word(const struct option *option);

/* " [DEFAULT; MINIMUM to MAXIMUM]" and alike, or "". */
void option_describe_range(const struct option *option, char *text, size_t size);

/* A line or two under the name with a prefix: "--" on a command line. with: further words after the help; or "". */
void option_print_help(FILE *out, const struct option *option, const char *prefix,
                       const char *with);

/* The same of each row, or of those alone that are not rare; how many were left out. */
int options_print_help(FILE *out, const struct option *table, const char *prefix, bool all);

#endif
