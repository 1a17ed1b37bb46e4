/* Tables of options: name, help, type, default and range of each field of a struct of values. They
 * serve command lines, the renderer's settings (--set key=value), the viewer's panel, the
 * benchmark's sweeps and --help. */
#ifndef BASE_OPTION_H
#define BASE_OPTION_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum option_type {
    OPTION_FLAG,   /* bool; no value on the command line; "on"/"off" as text */
    OPTION_INT,    /* int */
    OPTION_FLOAT,  /* float; "1%" is .01 */
    OPTION_CHOICE, /* int, an index into choices */
    OPTION_TEXT,   /* const char *, not owned; default NULL */
    OPTION_LIST,   /* struct text_list; may be given several times */
    OPTION_SIZE,   /* int[2]: WxH, each in the range */
};

/* Asserts that an OPTION_SIZE row can write both fields of the struct. */
#define OPTION_ASSERT_SIZE(type, width, height)                                                    \
    _Static_assert(offsetof(type, height) == offsetof(type, width) + sizeof(int),                  \
                   "OPTION_SIZE writes both")

enum { TEXT_LIST_MAX = 64 };

struct text_list {
    const char *items[TEXT_LIST_MAX];
    int count;
};

struct option {
    const char *name; /* "val-count": name after -- and in --set */
    char letter;      /* 'o' for -o; 0: none */
    enum option_type type;
    size_t offset; /* offset of the field in the struct of values */
    double default_value, minimum, maximum;
    const char *const *choices; /* OPTION_CHOICE: null-terminated */
    /* OPTION_TEXT: returns false with an error to refuse the text; NULL: accepts any. */
    bool (*check)(const char *text);
    const char *value_name; /* in --help: "FILE"; NULL: by type */
    const char *unit;       /* unit allowed after a number: "ms"; NULL: none */
    const char *label;      /* for settings: label in the viewer; NULL: name */
    const char *help;
    /* For settings: conditions of an effect (struct need); NULL: none. */
    const char *needs;
    bool rare; /* shown by --help-all only */
};

/* A table ends with a row whose name is NULL. */

/* Sets every field to its default. OPTION_SIZE takes the default for both. */
void options_set_defaults(const struct option *table, void *values);

/* Returns the row of that name, or NULL. */
const struct option *option_find(const struct option *table, const char *name);

/* Sets one field from text. Error: names the option, the text and the allowed values. */
bool option_parse(const struct option *option, void *values, const char *text);

/* Get and set the field of a flag, a number or a choice. */
double option_number(const struct option *option, const void *values);
void option_set_number(const struct option *option, void *values, double number);

/* Writes the field as text that option_parse reads back. */
void option_format(const struct option *option, const void *values, char *text, size_t size);

/* True if a field is equal in two structs of values. Not for OPTION_LIST. */
bool option_equal(const struct option *option, const void *a, const void *b);

/* Parses a command line: --name value, --name=value, -o value, flags, and up to max_positional
 * other arguments; "--" ends the options. argv[0] is skipped. given, unless NULL, receives the
 * names of the options present. Error: unknown option, missing value and others. */
bool options_parse_arguments(const struct option *table, void *values, int argc, char **argv,
                             const char **positional, int max_positional, int *positional_count,
                             struct text_list *given);

/* Prints the help of an option. prefix precedes its name, "--" on a command line. with: words after
 * the help, or "". */
void option_print_help(FILE *out, const struct option *option, const char *prefix,
                       const char *with);

/* Prints the help of each row; without `all` only of rows that are not rare. Returns the number of
 * rows left out. */
int options_print_help(FILE *out, const struct option *table, const char *prefix, bool all);

#endif
