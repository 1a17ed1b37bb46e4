#include "lab/manual/value.h"

#include "metrics/metric.h"
#include "reference/channels.h"
#include "renderer/renderer.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

static void add(struct text *words, const char *word, int length) {
    text_print(words, "%s%.*s", words->length ? " " : "", length, word);
}

static void add_whole(struct text *words, const char *word) {
    add(words, word, (int)strlen(word));
}

static bool has_word(const struct text *words, const char *word, int length) {
    for (struct word at = {.at = words->data ? words->data : ""}; word_next(&at);)
        if (at.length == length && strncmp(at.at, word, (size_t)length) == 0)
            return true;
    return false;
}

static void add_once(struct text *words, const char *word, int length) {
    if (!has_word(words, word, length))
        add(words, word, length);
}

/* --- words that no row of a table lists ------------------------------------------------------- */

static void list_techniques(struct text *words) {
    for (const struct technique *const *t = techniques; *t; t++)
        add_whole(words, (*t)->name);
}

static void list_direct(struct text *words) {
    for (const struct direct_method *const *d = direct_methods; *d; d++)
        add_whole(words, (*d)->name);
}

static void list_presets(struct text *words) {
    for (const struct technique *const *t = techniques; *t; t++)
        for (const struct preset *p = (*t)->presets; p && p->name; p++)
            add_once(words, p->name, (int)strlen(p->name));
}

/* As bench takes them: techniques and the presets of the default. */
static void list_variants(struct text *words) {
    for (const struct preset *p = technique_default->presets; p && p->name; p++)
        add_whole(words, p->name);
    list_techniques(words);
}

static void list_metrics(struct text *words) {
    add_whole(words, "all");
    for (int i = 0; i < METRIC_COUNT; i++)
        add_whole(words, metrics[i].name);
}

static int layer_length(const struct word *channel) {
    int length = channel->length;
    while (length > 0 && channel->at[length] != '.')
        length--;
    return length;
}

/* Of pictures of this program: all that comes before a channel's last dot. */
static void list_layers(struct text *words) {
    static const char channels[] = CHANNELS_OF_PATH_TRACER
        " " CHANNELS_OF_SEEN " " CHANNELS_OF_SPECULAR " " CHANNELS_OF_AO " " CHANNELS_OF_AIRLIGHT
        " " CHANNELS_OF_CAUSTIC " " CHANNELS_OF_VOLUME " bound.R nodes.R";
    add_whole(words, "beauty");
    for (struct word channel = {.at = channels}; word_next(&channel);) {
        int length = layer_length(&channel);
        if (length > 0)
            add_once(words, channel.at, length);
    }
}

static const struct {
    const char *option;
    void (*list)(struct text *words);
} lists[] = {
    {"technique", list_techniques}, {"direct", list_direct}, {"variant", list_variants},
    {"metric", list_metrics},       {"layer", list_layers},  {"reference-layer", list_layers},
};

static bool list_by_name(const struct option *option, struct text *words) {
    for (size_t i = 0; i < sizeof lists / sizeof *lists; i++)
        if (strcmp(lists[i].option, option->name) == 0 &&
            (option->type == OPTION_LIST || lists[i].list != list_variants)) {
            lists[i].list(words);
            return true;
        }
    return false;
}

/* Of a value's name such as "none|COLOUR" or "png|exr|..." the words in lower case. */
static void list_of_value_name(const char *name, struct text *words) {
    while (*name) {
        int length = (int)strcspn(name, "|"), lower = 0;
        while (lower < length && islower((unsigned char)name[lower]))
            lower++;
        if (lower == length)
            add(words, name, length);
        name += length + (name[length] == '|');
    }
}

static void list_choices(const struct option *option, struct text *words) {
    if (option->type == OPTION_FLAG)
        add_whole(words, "on off");
    for (const char *const *c = option->choices; option->type == OPTION_CHOICE && *c; c++)
        add_whole(words, *c);
}

/* --- options ---------------------------------------------------------------------------------- */

static struct value value_of_text(const struct option *option) {
    const char *name = option_value_word(option);
    struct value value = {VALUE_FREE, {0}};
    if (strcmp(option->name, "set") == 0)
        value.kind = VALUE_SETTING;
    else if (strncmp(name, "FILE", 4) == 0)
        value.kind = VALUE_FILE;
    else if (strcmp(name, "DIR") == 0 || strcmp(name, "FOLDER") == 0)
        value.kind = VALUE_FOLDER;
    else if (!list_by_name(option, &value.words))
        list_of_value_name(name, &value.words);
    if (value.words.length > 0)
        value.kind = VALUE_WORDS;
    return value;
}

struct value value_of_option(const struct option *option) {
    struct value value = {option->type == OPTION_FLAG ? VALUE_NONE : VALUE_FREE, {0}};
    if (option->type == OPTION_TEXT || option->type == OPTION_LIST)
        return value_of_text(option);
    if (option->type == OPTION_CHOICE) {
        value.kind = VALUE_WORDS;
        list_choices(option, &value.words);
    }
    return value;
}

void value_free(struct value *value) {
    free(value->words.data);
    *value = (struct value){VALUE_NONE, {0}};
}

/* --- settings --------------------------------------------------------------------------------- */

void value_each_setting(FILE *out, put_setting *put) {
    struct settings settings;
    struct text presets = {0};
    renderer_settings_init(&settings);
    for (struct setting s = {0}; settings_next(&settings, &s);) {
        char name[SETTING_NAME_SIZE];
        struct text words = {0};
        setting_name(&s, name);
        list_choices(s.option, &words);
        put(out, name, words.data ? words.data : "");
        free(words.data);
    }
    list_presets(&presets);
    put(out, "path", presets.data ? presets.data : "");
    free(presets.data);
}
