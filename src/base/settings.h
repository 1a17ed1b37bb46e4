/* Settings of all parts of the program. Each part has an option table over its own struct. One
 * struct settings holds these structs; copy and compare it as a value.
 *
 * A setting has a full name, "gather.interleave", or "gather-interleave" with a dash for the dot.
 * The last part, "interleave", is enough if it is unique. */
#ifndef BASE_SETTINGS_H
#define BASE_SETTINGS_H

#include "base/option.h"
#include "base/words.h"

#include <stdint.h>

struct settings_part {
    const char *owner; /* "gather" */
    const char *title; /* heading: "gathering light" */
    const struct option *table;
    size_t size; /* size of the struct of the table */
};

enum { SETTINGS_PARTS_MAX = 48, SETTINGS_BYTES_MAX = 2048, SETTING_NAME_SIZE = 64 };

/* Zeroed: no parts. */
struct settings {
    const struct settings_part *parts[SETTINGS_PARTS_MAX];
    int part_count;
    /* For each part a bit per row of its table: set by settings_give_word. */
    uint32_t given[SETTINGS_PARTS_MAX];
    unsigned char bytes[SETTINGS_BYTES_MAX]; /* structs of the parts, one after another */
};

/* Adds a part with its defaults, unless it is present. Asserts the limits. */
void settings_add(struct settings *settings, const struct settings_part *part);

/* Returns a copy of a part's struct, valid in the block of the call. The part must be present. */
#define settings_of(type, settings, part)                                                          \
    ((const type *)settings_get(settings, part, &(type){0}, sizeof(type)))

/* Copy a part's struct to values, which the first returns, and back. */
const void *settings_get(const struct settings *settings, const struct settings_part *part,
                         void *values, size_t size);
void settings_set(struct settings *settings, const struct settings_part *part, const void *values);

/* True if both have equal values of a part. */
bool settings_same(const struct settings *a, const struct settings *b,
                   const struct settings_part *part);

/* Copies the values of a part. */
void settings_copy(struct settings *to, const struct settings *from,
                   const struct settings_part *part);

/* One setting of a part. */
struct setting {
    const struct settings_part *part;
    const struct option *option;
};

/* True if the part is in a NULL-terminated list. */
bool settings_parts_have(const struct settings_part *const *parts,
                         const struct settings_part *part);

/* Steps to the next of all settings, from {0}. Returns false after the last. */
bool settings_next(const struct settings *settings, struct setting *setting);

/* Finds the setting of that name. Error: there is none, or several, which the message names. */
bool settings_find(const struct settings *settings, const char *name, struct setting *setting);

/* Writes the full name, or returns whether it is in a list of full names; NULL: empty list. */
void setting_name(const struct setting *setting, char name[SETTING_NAME_SIZE]);
bool setting_is_among(const struct setting *setting, const char *names);

/* Write the value as text, and set it from text. Error: as option_parse. */
void setting_format(const struct setting *setting, const struct settings *settings, char *text,
                    size_t size);
bool setting_parse(const struct setting *setting, struct settings *settings, const char *text);

/* Get and set the value as a number: all settings are flags, numbers or choices. */
double setting_number(const struct setting *setting, const struct settings *settings);
void setting_set_number(const struct setting *setting, struct settings *settings, double number);

/* True if the setting is equal in both. */
bool setting_equal(const struct setting *setting, const struct settings *a,
                   const struct settings *b);

/* Returns setting_number of a named setting, which must be present. For callers that cannot include
 * its part. */
double settings_number(const struct settings *settings, const char *name);

/* Sets "name=value", or several separated by spaces or commas. Error: a name or a value. */
bool settings_assign(struct settings *settings, const char *assignments);

/* Set "name=value" of a user and record it as given; forget the records; or copy the given values
 * over a choice of the program. Error: a name or a value. */
bool settings_give_word(struct settings *settings, const struct word *word);
void settings_forget_given(struct settings *settings);
void settings_copy_given(struct settings *to, const struct settings *from);

/* One condition of option->needs, a list separated by spaces or commas. A condition is a setting's
 * full name or "technique"; "=", "!=" or ">"; and a value, or several separated by bars.
 *
 *     for (struct need need = {.word.at = option->needs}; need_next(&need);)
 */
struct need {
    struct word word;                   /* the whole condition */
    char name[SETTING_NAME_SIZE], sign; /* '!' for "!=" */
    char values[SETTING_NAME_SIZE];
};

/* Steps to the next condition. Returns false after the last or if there are none. */
bool need_next(struct need *need);

/* True if the value is one of the condition's values. */
bool need_names(const struct need *need, const char *value);

/* Prints the help of a setting. with: as for option_print_help. */
void setting_print_help(FILE *out, const struct setting *setting, const char *with);

#endif
