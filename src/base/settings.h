/* Settings by owner: each part of the program has an option table over a struct of its own, and one
 * value, to be copied and compared as any struct, holds the structs of all.
 *
 * A setting is called by its full name, "gather.interleave"; by its last name where no other part
 * has it, "interleave"; or with a dash in place of the dot, "blur-radius" for "blur.radius".
 */
#ifndef BASE_SETTINGS_H
#define BASE_SETTINGS_H

#include "base/option.h"
#include "base/words.h"

#include <stdint.h>

struct settings_part {
    const char *owner; /* "gather" */
    const char *title; /* a heading: "gathering light" */
    const struct option *table;
    size_t size; /* of the struct that the table's rows lie in */
};

enum { SETTINGS_PARTS_MAX = 48, SETTINGS_BYTES_MAX = 2048, SETTING_NAME_SIZE = 64 };

/* All zero: no part yet. */
struct settings {
    const struct settings_part *parts[SETTINGS_PARTS_MAX];
    int part_count;
    /* Of each part, by rows of its table: those that settings_give_word set. */
    uint32_t given[SETTINGS_PARTS_MAX];
    unsigned char bytes[SETTINGS_BYTES_MAX]; /* the parts' structs, one after another */
};

/* Adds a part with its defaults, unless it is there; parts beyond the limits are a mistake of the
 * program's. */
void settings_add(struct settings *settings, const struct settings_part *part);

/* A part's struct, which must be there: a copy that lives as long as the block of the call. */
#define settings_of(type, settings, part)                                                          \
    ((const type *)settings_get(settings, part, &(type){0}, sizeof(type)))

/* Copies a part's struct to the values, and returns these; and back. */
const void *settings_get(const struct settings *settings, const struct settings_part *part,
                         void *values, size_t size);
void settings_set(struct settings *settings, const struct settings_part *part, const void *values);

/* Whether both have the same values of a part. */
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

/* Whether the part is in a list that NULL ends. */
bool settings_parts_have(const struct settings_part *const *parts,
                         const struct settings_part *part);

/* Steps through all settings, from {0}; false after the last. */
bool settings_next(const struct settings *settings, struct setting *setting);

/* The setting of that name, or of that former name. Error: there is none, or several, which it names. */
bool settings_find(const struct settings *settings, const char *name, struct setting *setting);

/* The full name; whether it is one of those names, NULL = none. */
void setting_name(const struct setting *setting, char name[SETTING_NAME_SIZE]);
bool setting_is_among(const struct setting *setting, const char *names);

/* The value as text that setting_parse reads back; and back. Error: option_parse's. */
void setting_format(const struct setting *setting, const struct settings *settings, char *text,
                    size_t size);
bool setting_parse(const struct setting *setting, struct settings *settings, const char *text);

/* The value of a flag, a number or a choice, as all settings are. */
double setting_number(const struct setting *setting, const struct settings *settings);
void setting_set_number(const struct setting *setting, struct settings *settings, double number);

/* Whether the setting is the same in both. */
bool setting_equal(const struct setting *setting, const struct settings *a,
                   const struct settings *b);

/* setting_number of the setting of that name, which must be there: for who cannot know its part. */
double settings_number(const struct settings *settings, const char *name);

/* Parses "name=value", or several with spaces or commas between. Error: of a name, or of a value. */
bool settings_assign(struct settings *settings, const char *assignments);

/* The same of what a user gives, which is kept in mind, or forgotten again; and copies all that was given, where a
 * choice of the program's went over it. */
bool settings_give_word(struct settings *settings, const struct word *word);
void settings_forget_given(struct settings *settings);
void settings_copy_given(struct settings *to, const struct settings *from);

/* One condition of option->needs, which has spaces or commas between: a setting's full name or "technique"; "=", "!=" or
 * ">"; and a value, or several with bars between.
 *
 *     for (struct need need = {.word.at = option->needs}; need_next(&need);)
 */
struct need {
    struct word word;                   /* all of it */
    char name[SETTING_NAME_SIZE], sign; /* '!' of "!=" */
    char values[SETTING_NAME_SIZE];
};

/* False after the last, or of NULL. */
bool need_next(struct need *need);

/* Whether the value is one of them. */
bool need_names(const struct need *need, const char *value);

/* A line or two of a setting, for --help. with: as of option_print_help. */
void setting_print_help(FILE *out, const struct setting *setting, const char *with);

#endif
