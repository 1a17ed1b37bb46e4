/* The values that an option or a setting takes, for completions. */
#ifndef LAB_MANUAL_VALUE_H
#define LAB_MANUAL_VALUE_H

#include "base/settings.h"
#include "base/text.h"

enum value_kind {
    VALUE_NONE, /* a flag */
    VALUE_WORDS,
    VALUE_FILE,
    VALUE_FOLDER,
    VALUE_SETTING, /* KEY=VALUE of --set */
    VALUE_FREE,    /* numbers, names in a scene and the like */
};

struct value {
    enum value_kind kind;
    struct text words; /* with spaces between; empty but for VALUE_WORDS */
};

/* value_free frees the words. */
struct value value_of_option(const struct option *option);
void value_free(struct value *value);

/* Calls put with each setting of all techniques and its words, "" where it is a number; then with
 * "path" and the presets. */
typedef void put_setting(FILE *out, const char *name, const char *words);
void value_each_setting(FILE *out, put_setting *put);

#endif
