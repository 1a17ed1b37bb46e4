#include "base/option.h"

#include "base/error.h"

#include <assert.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Fields are read and written by memcpy alone: those of struct settings lie in bytes. */
static void *field(const struct option *option, const void *values) {
    return (char *)values + option->offset;
}

void option_set_number(const struct option *option, void *values, double number) {
    void *at = field(option, values);
    switch (option->type) {
    case OPTION_FLAG:
        memcpy(at, &(bool){number != 0}, sizeof(bool));
        return;
    case OPTION_INT:
    case OPTION_CHOICE:
        memcpy(at, &(int){(int)number}, sizeof(int));
        return;
    case OPTION_FLOAT:
        memcpy(at, &(float){(float)number}, sizeof(float));
        return;
    case OPTION_TEXT:
    case OPTION_LIST:
    case OPTION_SIZE:
        break;
    }
    assert(!"no number");
}

double option_number(const struct option *option, const void *values) {
    const void *at = field(option, values);
    bool flag;
    int number;
    float real;
    switch (option->type) {
    case OPTION_FLAG:
        memcpy(&flag, at, sizeof flag);
        return flag;
    case OPTION_INT:
    case OPTION_CHOICE:
        memcpy(&number, at, sizeof number);
        return number;
    case OPTION_FLOAT:
        memcpy(&real, at, sizeof real);
        return (double)real;
    case OPTION_TEXT:
    case OPTION_LIST:
    case OPTION_SIZE:
        break;
    }
    assert(!"no number");
    return 0;
}

void options_set_defaults(const struct option *table, void *values) {
    for (const struct option *o = table; o->name; o++) {
        int number = (int)o->default_value;
        if (o->type == OPTION_TEXT)
            *(const char **)field(o, values) = NULL;
        else if (o->type == OPTION_LIST)
            ((struct text_list *)field(o, values))->count = 0;
        else if (o->type == OPTION_SIZE)
            memcpy(field(o, values), (int[]){number, number}, sizeof(int[2]));
        else
            option_set_number(o, values, o->default_value);
    }
}

const struct option *option_find(const struct option *table, const char *name) {
    for (const struct option *o = table; o->name; o++)
        if (strcmp(o->name, name) == 0)
            return o;
    return NULL;
}

static bool refuse(const struct option *option, const char *text) {
    char allowed[512] = "";
    size_t used = 0;
    switch (option->type) {
    case OPTION_FLAG:
        snprintf(allowed, sizeof allowed, "on or off");
        break;
    case OPTION_INT:
        snprintf(allowed, sizeof allowed, "a whole number from %.0f to %.0f", option->minimum,
                 option->maximum);
        break;
    case OPTION_FLOAT:
        snprintf(allowed, sizeof allowed, "a number from %g to %g", option->minimum,
                 option->maximum);
        break;
    case OPTION_CHOICE:
        for (const char *const *c = option->choices; *c && used < sizeof allowed; c++)
            used += (size_t)snprintf(allowed + used, sizeof allowed - used, "%s%s",
                                     c == option->choices ? "one of " : ", ", *c);
        break;
    case OPTION_SIZE:
        snprintf(allowed, sizeof allowed, "WIDTHxHEIGHT, each from %.0f to %.0f", option->minimum,
                 option->maximum);
        break;
    case OPTION_TEXT:
    case OPTION_LIST:
        break;
    }
    return error_set("%s: '%s' is not %s", option->name, text, allowed);
}

static bool parse_int(const char **text, const struct option *option, int *value) {
    char *end;
    errno = 0;
    long number = strtol(*text, &end, 10);
    if (end == *text || errno || number < option->minimum || number > option->maximum)
        return false;
    *value = (int)number;
    *text = end;
    return true;
}

static bool parse_float(const char *text, const struct option *option, double *value) {
    char *end;
    double number = strtod(text, &end);
    if (end > text && strcmp(end, "%") == 0) {
        number /= 100;
        end++;
    } else if (end > text && option->unit && strcmp(end, option->unit) == 0) {
        end += strlen(option->unit);
    }
    if (end == text || *end || !isfinite(number) || number < option->minimum ||
        number > option->maximum)
        return false;
    *value = number;
    return true;
}

static bool parse_flag(const char *text, double *value) {
    static const char *const words[] = {"off", "on", "false", "true", "no", "yes", "0", "1"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strcmp(text, words[i]) == 0) {
            *value = (double)(i % 2);
            return true;
        }
    return false;
}

static bool parse_choice(const char *text, const struct option *option, double *value) {
    for (int i = 0; option->choices[i]; i++)
        if (strcmp(text, option->choices[i]) == 0) {
            *value = i;
            return true;
        }
    return false;
}

static bool parse_number(const struct option *option, const char *text, double *value) {
    int number = 0;
    if (option->type == OPTION_FLAG)
        return parse_flag(text, value);
    if (option->type == OPTION_FLOAT)
        return parse_float(text, option, value);
    if (option->type == OPTION_CHOICE)
        return parse_choice(text, option, value);
    bool ok = parse_int(&text, option, &number) && !*text;
    *value = number;
    return ok;
}

bool option_parse(const struct option *option, void *values, const char *text) {
    void *at = field(option, values);
    const char *rest = text;
    double number;
    int size[2];
    switch (option->type) {
    case OPTION_FLAG:
    case OPTION_INT:
    case OPTION_FLOAT:
    case OPTION_CHOICE:
        if (!parse_number(option, text, &number))
            return refuse(option, text);
        option_set_number(option, values, number);
        return true;
    case OPTION_TEXT:
        if (option->check && !option->check(text))
            return error_prefix("%s", option->name);
        *(const char **)at = text;
        return true;
    case OPTION_LIST: {
        struct text_list *list = at;
        if (list->count == TEXT_LIST_MAX)
            return error_set("%s: given more than %d times", option->name, TEXT_LIST_MAX);
        list->items[list->count++] = text;
        return true;
    }
    case OPTION_SIZE:
        if (!parse_int(&rest, option, &size[0]) || *rest++ != 'x' ||
            !parse_int(&rest, option, &size[1]) || *rest)
            return refuse(option, text);
        memcpy(at, size, sizeof size);
        return true;
    }
    return false;
}

void option_format(const struct option *option, const void *values, char *text, size_t size) {
    const void *at = field(option, values);
    switch (option->type) {
    case OPTION_FLAG:
        snprintf(text, size, "%s", option_number(option, values) != 0 ? "on" : "off");
        break;
    case OPTION_INT:
        snprintf(text, size, "%.0f", option_number(option, values));
        break;
    case OPTION_FLOAT:
        snprintf(text, size, "%.9g", option_number(option, values));
        break;
    case OPTION_CHOICE:
        snprintf(text, size, "%s", option->choices[(int)option_number(option, values)]);
        break;
    case OPTION_TEXT:
        snprintf(text, size, "%s", *(const char *const *)at ? *(const char *const *)at : "");
        break;
    case OPTION_LIST:
        snprintf(text, size, "%d items", ((const struct text_list *)at)->count);
        break;
    case OPTION_SIZE:
        snprintf(text, size, "%dx%d", ((const int *)at)[0], ((const int *)at)[1]);
        break;
    }
}

bool option_equal(const struct option *option, const void *a, const void *b) {
    const void *x = field(option, a), *y = field(option, b);
    if (option->type == OPTION_TEXT) {
        const char *s = *(const char *const *)x, *t = *(const char *const *)y;
        return s && t ? strcmp(s, t) == 0 : s == t;
    }
    if (option->type == OPTION_SIZE)
        return memcmp(x, y, 2 * sizeof(int)) == 0;
    return option_number(option, a) == option_number(option, b);
}

static const struct option *find_argument(const struct option *table, const char *argument,
                                          const char **value) {
    *value = NULL;
    if (argument[1] != '-') {
        for (const struct option *o = table; o->name; o++)
            if (o->letter && o->letter == argument[1]) {
                *value = argument[2] ? argument + 2 : NULL;
                return o;
            }
        return NULL;
    }
    char name[64];
    size_t length = strcspn(argument + 2, "=");
    snprintf(name, sizeof name, "%.*s", length < sizeof name ? (int)length : 0, argument + 2);
    *value = argument[2 + length] ? argument + 2 + length + 1 : NULL;
    return option_find(table, name);
}

/* Once, however often it is given. */
static void add_given(struct text_list *given, const char *name) {
    for (int i = 0; i < given->count; i++)
        if (strcmp(given->items[i], name) == 0)
            return;
    if (given->count < TEXT_LIST_MAX)
        given->items[given->count++] = name;
}

bool options_parse_arguments(const struct option *table, void *values, int argc, char **argv,
                             const char **positional, int max_positional, int *positional_count,
                             struct text_list *given) {
    bool only_positional = false;
    *positional_count = 0;
    for (int i = 1; i < argc; i++) {
        const char *argument = argv[i], *value;
        if (!only_positional && strcmp(argument, "--") == 0) {
            only_positional = true;
        } else if (only_positional || argument[0] != '-' || argument[1] == '\0') {
            if (*positional_count == max_positional)
                return error_set("one argument too many: '%s'", argument);
            positional[(*positional_count)++] = argument;
        } else {
            const struct option *option = find_argument(table, argument, &value);
            if (!option)
                return error_set("unknown option '%s' (--help-all lists them)", argument);
            if (!value && option->type == OPTION_FLAG)
                value = "on";
            else if (!value && i + 1 < argc)
                value = argv[++i];
            if (!value)
                return error_set("--%s needs a value", option->name);
            if (!option_parse(option, values, value))
                return false;
            if (given)
                add_given(given, option->name);
        }
    }
    return true;
}

/* " [DEFAULT; MINIMUM to MAXIMUM]" or a similar text, or "". */
static void describe_range(const struct option *o, char *text, size_t size) {
    text[0] = '\0';
    size_t used = 0;
    switch (o->type) {
    case OPTION_INT:
    case OPTION_FLOAT:
        snprintf(text, size, " [%g; %g to %g]", o->default_value, o->minimum, o->maximum);
        break;
    case OPTION_SIZE:
        if (o->default_value != 0)
            snprintf(text, size, " [%gx%g]", o->default_value, o->default_value);
        break;
    case OPTION_CHOICE:
        used = (size_t)snprintf(text, size, " [%s", o->choices[(int)o->default_value]);
        for (int i = 0; o->choices[i] && used < size; i++)
            used += (size_t)snprintf(text + used, size - used, "%s%s", i ? ", " : "; one of ",
                                     o->choices[i]);
        if (used < size)
            snprintf(text + used, size - used, "]");
        break;
    case OPTION_FLAG:
        if (o->default_value != 0)
            snprintf(text, size, " [on]");
        break;
    case OPTION_TEXT:
    case OPTION_LIST:
        break;
    }
}

/* The word for a value in help, "N" or "WxH"; "" for a flag. */
static const char *value_word(const struct option *o) {
    static const char *const words[] = {"", "N", "X", "NAME", "TEXT", "TEXT", "WxH"};
    return o->value_name ? o->value_name : words[o->type];
}

/* What goes on in a new line stands below its beginning. */
static void print_indented(FILE *out, const char *text) {
    for (; *text; text++)
        fprintf(out, *text == '\n' ? "\n%29s" : "%.1s", *text == '\n' ? "" : text);
}

/* Columns that a line of help may take beside the names. */
enum { HELP_WIDTH = 91 };

void option_print_help(FILE *out, const struct option *o, const char *prefix, const char *with) {
    char left[96], range[512], letter[8] = "";
    if (o->letter)
        snprintf(letter, sizeof letter, "-%c, ", o->letter);
    const char *value = value_word(o);
    bool shown = *value && *prefix == '-';
    snprintf(left, sizeof left, "%s%s%s%s%s", letter, prefix, o->name, shown ? " " : "",
             shown ? value : "");
    describe_range(o, range, sizeof range);
    fprintf(out, "  %-26s ", left);
    print_indented(out, o->help);
    if (*with) {
        const char *line = strrchr(o->help, '\n');
        size_t length = strlen(line ? line + 1 : o->help) + strlen(with) + strlen(range);
        fprintf(out, length > HELP_WIDTH - 7 ? ";\n%29swith %s" : ";%.0s with %s", "", with);
    }
    fprintf(out, "%s\n", range);
}

int options_print_help(FILE *out, const struct option *table, const char *prefix, bool all) {
    int left_out = 0;
    for (const struct option *o = table; o->name; o++)
        if (all || !o->rare)
            option_print_help(out, o, prefix, "");
        else
            left_out++;
    return left_out;
}
