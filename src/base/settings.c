#include "base/settings.h"

#include "base/error.h"
#include "base/names.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

/* --- parts --- */

/* Where a part's struct begins; where the next would, if the part is not there. */
static size_t offset_of(const struct settings *settings, const struct settings_part *part,
                        bool *found) {
    size_t offset = 0;
    for (int i = 0; i < settings->part_count; i++) {
        *found = settings->parts[i] == part;
        if (*found)
            return offset;
        offset += settings->parts[i]->size;
    }
    *found = false;
    return offset;
}

static int row_count(const struct settings_part *part) {
    int count = 0;
    while (part->table[count].name)
        count++;
    return count;
}

bool settings_parts_have(const struct settings_part *const *parts,
                         const struct settings_part *part) {
    while (*parts && *parts != part)
        parts++;
    return *parts;
}

void settings_add(struct settings *settings, const struct settings_part *part) {
    bool found;
    size_t offset = offset_of(settings, part, &found);
    if (found)
        return;
    assert(settings->part_count < SETTINGS_PARTS_MAX);
    assert(offset + part->size <= SETTINGS_BYTES_MAX);
    assert(row_count(part) <= 32); /* as many as there are bits in settings->given */
    settings->parts[settings->part_count++] = part;
    options_set_defaults(part->table, settings->bytes + offset);
}

static const unsigned char *bytes_of(const struct settings *settings,
                                     const struct settings_part *part) {
    bool found;
    size_t offset = offset_of(settings, part, &found);
    assert(found);
    return settings->bytes + offset;
}

const void *settings_get(const struct settings *settings, const struct settings_part *part,
                         void *values, size_t size) {
    assert(size == part->size);
    return memcpy(values, bytes_of(settings, part), size);
}

void settings_set(struct settings *settings, const struct settings_part *part, const void *values) {
    memcpy((void *)bytes_of(settings, part), values, part->size);
}

bool settings_same(const struct settings *a, const struct settings *b,
                   const struct settings_part *part) {
    for (const struct option *option = part->table; option->name; option++)
        if (!option_equal(option, bytes_of(a, part), bytes_of(b, part)))
            return false;
    return true;
}

void settings_copy(struct settings *to, const struct settings *from,
                   const struct settings_part *part) {
    settings_set(to, part, bytes_of(from, part));
}

/* --- settings --- */

bool settings_next(const struct settings *settings, struct setting *setting) {
    int part = 0;
    if (setting->part) {
        setting->option++;
        if (setting->option->name)
            return true;
        while (settings->parts[part] != setting->part)
            part++;
        part++;
    }
    for (; part < settings->part_count; part++) {
        *setting = (struct setting){settings->parts[part], settings->parts[part]->table};
        if (setting->option->name)
            return true;
    }
    return false;
}

/* Whether "owner.name" is that text, a dash in which may stand for the dot. */
static bool is_full_name(const struct setting *setting, const char *text) {
    size_t length = strlen(setting->part->owner);
    return strncmp(text, setting->part->owner, length) == 0 &&
           (text[length] == '.' || text[length] == '-') &&
           strcmp(text + length + 1, setting->option->name) == 0;
}

static bool refuse_ambiguous(const struct settings *settings, const char *name) {
    struct names names = {0};
    char full[SETTING_NAME_SIZE];
    for (struct setting s = {0}; settings_next(settings, &s);)
        if (strcmp(s.option->name, name) == 0) {
            setting_name(&s, full);
            names_add(&names, " and ", full);
        }
    return error_set("'%s' may be %s", name, names.text);
}

bool settings_find(const struct settings *settings, const char *name, struct setting *setting) {
    int count = 0;
    for (struct setting s = {0}; settings_next(settings, &s);) {
        if (is_full_name(&s, name)) {
            *setting = s;
            return true;
        }
        if (strcmp(s.option->name, name) == 0) {
            *setting = s;
            count++;
        }
    }
    if (count == 0)
        return error_set("no setting is called '%s' (--help-all lists them)", name);
    return count == 1 || refuse_ambiguous(settings, name);
}

void setting_name(const struct setting *setting, char name[SETTING_NAME_SIZE]) {
    snprintf(name, SETTING_NAME_SIZE, "%s.%s", setting->part->owner, setting->option->name);
}

bool setting_is_among(const struct setting *setting, const char *names) {
    char name[SETTING_NAME_SIZE];
    setting_name(setting, name);
    for (struct word word = {.at = names ? names : ""}; word_next(&word);)
        if (word_is(&word, name))
            return true;
    return false;
}

void setting_format(const struct setting *setting, const struct settings *settings, char *text,
                    size_t size) {
    option_format(setting->option, bytes_of(settings, setting->part), text, size);
}

bool setting_parse(const struct setting *setting, struct settings *settings, const char *text) {
    return option_parse(setting->option, (void *)bytes_of(settings, setting->part), text);
}

double setting_number(const struct setting *setting, const struct settings *settings) {
    return option_number(setting->option, bytes_of(settings, setting->part));
}

void setting_set_number(const struct setting *setting, struct settings *settings, double number) {
    option_set_number(setting->option, (void *)bytes_of(settings, setting->part), number);
}

bool setting_equal(const struct setting *setting, const struct settings *a,
                   const struct settings *b) {
    return setting_number(setting, a) == setting_number(setting, b);
}

double settings_number(const struct settings *settings, const char *name) {
    struct setting setting;
    bool found = settings_find(settings, name, &setting);
    assert(found);
    return found ? setting_number(&setting, settings) : 0;
}

/* --- texts --- */

static bool assign(struct settings *settings, const struct word *word, struct setting *setting) {
    const char *equals = memchr(word->at, '=', (size_t)word->length);
    char assignment[256];
    if (!equals)
        return error_set("'%.*s' is not key=value", word->length, word->at);
    if ((size_t)word->length >= sizeof assignment)
        return error_set("'%.40s...' is too long", word->at);
    snprintf(assignment, sizeof assignment, "%.*s", word->length, word->at);
    char *value = assignment + (equals - word->at);
    *value++ = '\0';
    return settings_find(settings, assignment, setting) && setting_parse(setting, settings, value);
}

static int part_number(const struct settings *settings, const struct setting *setting) {
    int part = 0;
    while (settings->parts[part] != setting->part)
        part++;
    return part;
}

/* In settings->given. */
static uint32_t row_bit(const struct setting *setting) {
    return (uint32_t)1 << (setting->option - setting->part->table);
}

bool settings_give_word(struct settings *settings, const struct word *word) {
    struct setting setting;
    if (!assign(settings, word, &setting))
        return false;
    settings->given[part_number(settings, &setting)] |= row_bit(&setting);
    return true;
}

void settings_forget_given(struct settings *settings) {
    memset(settings->given, 0, sizeof settings->given);
}

void settings_copy_given(struct settings *to, const struct settings *from) {
    for (struct setting s = {0}; settings_next(from, &s);)
        if (from->given[part_number(from, &s)] & row_bit(&s))
            setting_set_number(&s, to, setting_number(&s, from));
}

bool settings_assign(struct settings *settings, const char *assignments) {
    struct setting setting;
    for (struct word word = {.at = assignments}; word_next(&word);)
        if (!assign(settings, &word, &setting))
            return false;
    return true;
}

/* --- needs --- */

bool need_next(struct need *need) {
    if (!need->word.at || !word_next(&need->word))
        return false;
    int name = (int)strcspn(need->word.at, "=!>");
    need->sign = need->word.at[name];
    int values = name + (need->sign == '!' ? 2 : 1);
    assert(values < need->word.length && need->word.length - values < SETTING_NAME_SIZE);
    snprintf(need->name, sizeof need->name, "%.*s", name, need->word.at);
    snprintf(need->values, sizeof need->values, "%.*s", need->word.length - values,
             need->word.at + values);
    return true;
}

bool need_names(const struct need *need, const char *value) {
    size_t length = strlen(value);
    for (const char *at = need->values; *at; at += strcspn(at, "|"), at += *at == '|')
        if (strcspn(at, "|") == length && strncmp(at, value, length) == 0)
            return true;
    return false;
}

/* --- help --- */

void setting_print_help(FILE *out, const struct setting *setting, const char *with) {
    char prefix[SETTING_NAME_SIZE];
    snprintf(prefix, sizeof prefix, "%s.", setting->part->owner);
    option_print_help(out, setting->option, prefix, with);
}
